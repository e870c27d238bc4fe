// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// A drive's state machine as data: its states by name, and its transitions.
#pragma once

#include <string>

#include <rtuwire/drives.hpp>

namespace playground {

/// The states and all transitions of a drive, in JSON: from a state, or from any, to another, by a command or by an event of
/// the drive's own. Those that a command causes are what `cia402::step` says for each state and command.
[[nodiscard]] std::string describe_machine(rtuwire::cia402::state_machine_options const& options);

} // namespace playground
