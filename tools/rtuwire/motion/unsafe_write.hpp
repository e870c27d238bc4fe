// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Which writes are refused for safety, before a frame leaves.
#pragma once

#include <optional>
#include <vector>

#include "catalog/catalog.hpp"
#include "choices.hpp"
#include "exit_status.hpp"
#include "line/open_line.hpp"
#include "line/who_is_it.hpp"
#include "words/value_words.hpp"

namespace tool {

/// Whether a drive that numbers its registers as the objects of CiA 402 is commanded there: its control word, its mode of
/// operation, its target torque, position, speed (vl) and velocity.
[[nodiscard]] bool is_target_of_profile(unsigned address);

/// Ends the command where a value goes to what commands a motor, whatever its form and its text: of the drive, and of any
/// where the unit may be one.
void refuse_command(value_to_write const& value, write_rules const& rules, choices const& chosen);

/// Ends the command where a value is never written, or needs --allow-run that was not said. A value that is not known
/// yet, because another register sets its step, is looked at once it is.
void refuse_unsafe_write(value_to_write const& value, drive_catalog const& drive, choices const& chosen);

/// Ends the command where a register file says that something moves after a value, and --allow-run was not said.
void refuse_what_moves(value_to_write const& value, permissions const& allowed);

/// Why none of these values may be written now: one of them changes how a running motor turns, --allow-run was not said,
/// and the drive is not read to be without power, its output frequency 0. Nothing where they may. Asks the drive where
/// that depends on it; what it said is as old as that answer, so this is asked before each write.
std::optional<ended> why_not_now(std::vector<value_to_write> const& values, open_line& line, rtuwire::unit_id unit,
                                 drive_catalog const& drive, permissions const& allowed);

} // namespace tool
