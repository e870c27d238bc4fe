// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Drives that were asked and are asked no more: what becomes of them, and what resets it.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>

#include "catalog/catalog.hpp"
#include "line/open_line.hpp"

namespace tool {

/// How a drive supervises its line.
struct line_supervision {
    bool is_off{false};                    ///< a silent line changes nothing
    bool ends_in_fault{true};              ///< where it is known, else taken to be so
    std::optional<std::uint16_t> tenths{}; ///< of a second, without a request; nothing where the drive does not tell
};

/// Reads it, by two requests at most.
line_supervision supervision_of(open_line& line, rtuwire::unit_id unit, rtuwire::altivar::drive_layout const& layout);

class left_alone {
public:
    /// Reads how the drive supervises its line, by two requests at most. `reset`: the command that resets it. Of a unit that
    /// is noted twice the later counts.
    void note(open_line& line, rtuwire::unit_id unit, drive_catalog const& drive, std::string const& reset);

    /// Which of them trip, and how long after their last request; empty where none does.
    std::string sentence() const;

private:
    struct tripping {
        std::string end; ///< "after 10.0 s"
        std::string reset;
    };

    std::map<std::uint8_t, tripping> trips_after_{}; ///< by the unit
};

} // namespace tool
