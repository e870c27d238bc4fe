// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// The next command on the way to a target state, from any state. A command is sent once and its state awaited; where
// there is no command, the drive itself must change state first.
// Internal: may change with any version.
#pragma once

#include <rtuwire/cia402/command.hpp>
#include <rtuwire/cia402/state.hpp>
#include <rtuwire/core/version.hpp>

namespace rtuwire {
inline namespace RTUWIRE_BUILD {
namespace cia402 {

/// The next command toward "operation enabled"; `none` in that state, and where only the drive itself or a fault
/// reset can change the state.
[[nodiscard]] constexpr command next_command_to_enable(state from) noexcept
{
    switch (from) {
    case state::switch_on_disabled: return command::shutdown;
    case state::ready_to_switch_on: return command::switch_on;
    case state::switched_on: return command::enable_operation;
    case state::unknown:
    case state::not_ready_to_switch_on:
    case state::operation_enabled:
    case state::quick_stop_active:
    case state::fault_reaction_active:
    case state::fault: break;
    }
    return command::none;
}

/// The next command toward a cleared fault; only a fault has one. It acts on an edge: a word with bit 7 low must be
/// sent before it.
[[nodiscard]] constexpr command next_command_to_reset(state from) noexcept
{
    return from == state::fault ? command::fault_reset : command::none;
}

/// How far a state is on the way to "operation enabled": 0 to 4; -1 for states outside it.
[[nodiscard]] constexpr int enable_rank(state at) noexcept
{
    switch (at) {
    case state::not_ready_to_switch_on: return 0;
    case state::switch_on_disabled: return 1;
    case state::ready_to_switch_on: return 2;
    case state::switched_on: return 3;
    case state::operation_enabled: return 4;
    case state::unknown:
    case state::quick_stop_active:
    case state::fault_reaction_active:
    case state::fault: break;
    }
    return -1;
}

} // namespace cia402
} // namespace RTUWIRE_BUILD
} // namespace rtuwire
