// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Registers after whose writing a motor may turn that did not, or turn otherwise, by their roles in the library's list.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "catalog/catalog.hpp"

namespace tool {

/// Whether it is a command or a reference, or a word that the drive's scanner puts there: only `start` and `stop` write
/// these.
bool commands_a_motor(std::uint16_t address, drive_catalog const& drive);

/// Whether it runs the motor of any drive that is known, or says who runs it: its commands and references, its extended command,
/// and its channels (CHCF, CD1, FR1 and the like).
bool runs_a_drive(std::uint16_t address);

/// Why a motor may turn after a write to a register, though it stood, as what follows its name; empty where it may not.
std::string why_it_may_move(register_entry const& entry);

/// Why a motor that runs turns otherwise after it, as what follows its name: a speed, a ramp, a limit. Empty where it does
/// not, and where a motor that stands may turn after it, too.
std::string why_it_runs_otherwise(register_entry const& entry);

/// What a value does to what stops a motor, as what follows "SLL=0": the drive's watch of its link, or its reaction to a
/// fault. A motor that runs then runs on. Empty where that stays.
std::string why_it_runs_on(std::uint16_t address, std::uint16_t word, drive_catalog const& drive);

/// What a value does to a drive's place on its line, as what follows "ADD=0": nobody can ask it any more. Empty where it
/// stays within reach.
std::string why_it_is_out_of_reach(register_entry const& entry, std::uint16_t word);

/// Why a register is a guard of a drive that nobody may change unwatched, as what follows its name: its place on a line, the time
/// after which it misses its controller, its reaction to a fault, a detection. Empty where it is none.
std::string why_it_is_a_guard(register_entry const& entry);

/// Why this program never writes a value, as what follows "CMI=1": an order that takes settings away. Empty where it
/// does.
std::string why_it_is_never_written(register_entry const& entry, std::uint16_t word, drive_catalog const& drive);

/// Whether a register takes orders that are gone once they are executed, so that it need not hold what was written.
bool takes_orders(register_entry const& entry, drive_catalog const& drive);

} // namespace tool
