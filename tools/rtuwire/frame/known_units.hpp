// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Which device is at which address, as far as --name, --drive and --device say: a listener asks nobody.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <vector>

#include "choices.hpp"
#include "frame/register_names.hpp"
#include "words/named_places.hpp"

namespace tool {

class known_units {
public:
    /// The same names for all units, none where null. They must outlive this.
    known_units(register_names const* all = nullptr) { of_.fill(all); }

    /// --drive is for all units of which --name says nothing, and so is --device, or for the units that --unit names.
    /// Refuses names of no drive, and a register file for a drive.
    explicit known_units(line_choices const& line);

    /// Null where nobody said.
    register_names const* of(std::uint8_t unit) const { return of_[unit]; }

private:
    register_names const* named_by(drive_catalog const* drive);
    register_names const* named_by(named_places const& file);

    std::array<register_names const*, 256> of_{};
    std::vector<std::unique_ptr<register_names>> own_{};
};

} // namespace tool
