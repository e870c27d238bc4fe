// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Which drive is at which address, as far as --name and --drive say: a listener asks nobody.
#pragma once

#include <array>
#include <cstdint>

#include "catalog/catalog.hpp"
#include "choices.hpp"

namespace tool {

class known_units {
public:
    /// --drive is for all units of which --name says nothing. Refuses names of no drive.
    explicit known_units(line_choices const& line);

    /// Null where nobody said.
    drive_catalog const* drive_of(std::uint8_t unit) const { return drives_[unit]; }

private:
    std::array<drive_catalog const*, 256> drives_{};
};

} // namespace tool
