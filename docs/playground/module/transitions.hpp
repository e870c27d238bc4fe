// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// A drive's state machine as data: its states by name, and its transitions.
#pragma once

#include <array>
#include <string>
#include <vector>

#include <rtuwire/drives.hpp>

namespace playground {

/// From a state to another, and what causes it: a command, or an event of the drive's own.
struct drawn_transition {
    rtuwire::cia402::transition number;
    rtuwire::cia402::state from; ///< `unknown`: from any
    rtuwire::cia402::state to;
    std::string cause;
    bool is_command;
};

/// All transitions of a drive. Those that a command causes are what `cia402::step` says for each state and command.
[[nodiscard]] std::vector<drawn_transition> transitions_of(rtuwire::cia402::state_machine_options const& options);

/// The same in JSON, with the names of the states.
[[nodiscard]] std::string describe_machine(rtuwire::cia402::state_machine_options const& options);

} // namespace playground
