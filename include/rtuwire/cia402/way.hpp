// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// The next command on the way to a goal, from any state. A command is given once and the state awaited;
// where no command leads on, the drive itself must move first.
#pragma once

#include <rtuwire/cia402/command.hpp>
#include <rtuwire/cia402/state.hpp>
#include <rtuwire/core/version.hpp>

namespace rtuwire::inline RTUWIRE_BUILD::cia402 {

/// The next command toward "operation enabled"; `none` in it, and where only the drive or a fault
/// reset leads on.
[[nodiscard]] constexpr command toward_running(state from) noexcept
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

/// The next command toward a cleared fault; only a fault has one. Its control word is an edge: a word
/// with bit 7 low goes before it.
[[nodiscard]] constexpr command toward_cleared(state from) noexcept
{
    return from == state::fault ? command::fault_reset : command::none;
}

/// How far a state is on the way to "operation enabled": 0 to 4, and -1 off the way.
[[nodiscard]] constexpr int height_of(state at) noexcept
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

} // namespace rtuwire::cia402
