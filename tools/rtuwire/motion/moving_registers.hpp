// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Registers after whose writing a motor may turn that did not, or turn otherwise.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "catalog/catalog.hpp"

namespace tool {

/// Whether it is a command or a reference, or a word that the drive's scanner puts there: only `start` and `stop` write
/// these.
bool commands_a_motor(std::uint16_t address, drive_catalog const& drive);

/// Why a motor may turn after a write to a register of that mnemonic, as what follows its name; empty where it may not.
std::string why_it_may_move(std::string_view code);

/// What a value does to the drive's watch of its link, as what follows "SLL=0": a motor that runs then runs on when its
/// controller or its cable fails. Empty where it keeps the watch.
std::string why_it_runs_on(std::uint16_t address, std::uint16_t word, drive_catalog const& drive);

} // namespace tool
