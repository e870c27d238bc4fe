// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Words "REG=VALUE" as what may be written to a unit: all that its table forbids, and all that is refused for safety, ends
// the command.
#pragma once

#include <string>
#include <vector>

#include "choices.hpp"
#include "line/line_words.hpp"
#include "line/open_line.hpp"
#include "line/who_is_it.hpp"
#include "words/value_words.hpp"

namespace tool {

/// All values, with the registers that limit them read first. Each is checked with what the ones before it will have
/// written.
std::vector<value_to_write> checked_values(std::vector<std::string> const& words, open_line& line,
                                           named_unit const& unit, write_rules const& rules, choices const& chosen);

/// While somebody was asked, a register that sets the step of a value may have been written: what was confirmed is another
/// word then, or the same word another amount. Ends the command where that is so; both are of the same words.
void refuse_changed_values(std::vector<value_to_write> const& confirmed, std::vector<value_to_write> const& now);

/// Ends the command where values of a register file may not be written to a unit of these rules: it is a drive, one of them
/// commands a motor, or moves something.
void refuse_unsafe_values(std::vector<value_to_write> const& values, write_rules const& rules, choices const& chosen);

} // namespace tool
