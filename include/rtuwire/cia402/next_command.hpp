// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// The next command on the way to a target state, from any state. A command is sent once and its state awaited; where
// there is no command, the drive itself must change state first.
#pragma once

#include <rtuwire/cia402/command.hpp>
#include <rtuwire/cia402/state.hpp>
#include <rtuwire/core/version.hpp>

namespace rtuwire {
inline namespace RTUWIRE_BUILD {
namespace detail {

/// The next command toward "operation enabled"; `none` in that state, and where only the drive itself or a fault
/// reset can change the state.
[[nodiscard]] constexpr cia402::command next_command_to_enable(cia402::state from) noexcept
{
    switch (from) {
    case cia402::state::switch_on_disabled: return cia402::command::shutdown;
    case cia402::state::ready_to_switch_on: return cia402::command::switch_on;
    case cia402::state::switched_on: return cia402::command::enable_operation;
    case cia402::state::unknown:
    case cia402::state::not_ready_to_switch_on:
    case cia402::state::operation_enabled:
    case cia402::state::quick_stop_active:
    case cia402::state::fault_reaction_active:
    case cia402::state::fault: break;
    }
    return cia402::command::none;
}

/// How far a state is on the way to "operation enabled": 0 to 4; -1 for states outside it.
[[nodiscard]] constexpr int enable_rank(cia402::state at) noexcept
{
    switch (at) {
    case cia402::state::not_ready_to_switch_on: return 0;
    case cia402::state::switch_on_disabled: return 1;
    case cia402::state::ready_to_switch_on: return 2;
    case cia402::state::switched_on: return 3;
    case cia402::state::operation_enabled: return 4;
    case cia402::state::unknown:
    case cia402::state::quick_stop_active:
    case cia402::state::fault_reaction_active:
    case cia402::state::fault: break;
    }
    return -1;
}

} // namespace detail
} // namespace RTUWIRE_BUILD
} // namespace rtuwire
