// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// A drive that is asked many things which are not about its motor: each request feeds its supervision of the line.
#pragma once

#include <chrono>
#include <optional>
#include <string>

#include "line/who_is_it.hpp"

namespace tool {

/// What a unit is that is to be asked many things.
struct fed_unit {
    bool may_be_drive{false};
    drive_catalog const* drive{nullptr}; ///< its table, where it is known which one
};

/// By what was said of it; else, of none and of a register file too, by what it says of itself.
fed_unit who_is_fed(open_line& line, named_unit const& unit);

/// How long such a unit may be without a request that it answers.
struct fed_pause {
    std::chrono::microseconds longest{};
    std::string why{}; ///< "its time-out of 10 s allows 5 s"
};

/// Half of what the drive's supervision of the line allows, as it is set; where it does not tell, a third of 7 s, the shortest
/// that these drives are delivered with. Nothing where it supervises nothing, and of what is no drive.
std::optional<fed_pause> pause_of(open_line& line, rtuwire::unit_id unit, fed_unit const& who);

/// Asks whoever sits there before a drive is fed, by `act` ("a map") and `question` ("map it?"); without a terminal --yes says
/// so. Ends where the answer is a no.
void ask_before_it_is_fed(fed_unit const& who, named_unit const& unit, permissions const& allowed,
                          std::string const& act, char const* question);

} // namespace tool
