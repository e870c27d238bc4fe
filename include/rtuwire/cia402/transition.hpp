// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// The transitions of the drive profile, with their numbers, and the command that causes each. How a drive differs is
// in `state_machine_options`, so that one table serves all.
#pragma once

#include <array>
#include <cstdint>

#include <rtuwire/cia402/command.hpp>
#include <rtuwire/cia402/state.hpp>
#include <rtuwire/core/literal.hpp>
#include <rtuwire/core/version.hpp>

namespace rtuwire {
inline namespace RTUWIRE_BUILD {
namespace cia402 {

/// The number of a transition. 3B leads directly from "ready to switch on" to "operation enabled" on some drives; the
/// profile's 16, from "quick stop active" back to operation, is one that a drive may lack.
enum class transition : std::uint8_t {
    t0,
    t1,
    t2,
    t3,
    t4,
    t5,
    t6,
    t7,
    t8,
    t9,
    t10,
    t11,
    t12,
    t13,
    t14,
    t15,
    t16,
    t3b,
    none = 0xFF,
};

/// How a drive's state machine differs from the profile's.
struct state_machine_options {
    bool enables_from_ready{false};      ///< has transition 3B
    bool quick_stop_waits{false};        ///< transition 12 waits for "disable voltage"
    bool resumes_from_quick_stop{false}; ///< has transition 16
};

/// One transition that a command causes.
struct transition_rule {
    transition number;
    state from;
    command cause;
    state to;
};

/// The transitions that commands cause. The others happen by themselves: 0 and 1 at power-up, 12 at the end of a
/// quick stop, 13 and 14 when a fault is detected.
inline constexpr std::array<transition_rule, 16> transition_rules{{
    {transition::t2, state::switch_on_disabled, command::shutdown, state::ready_to_switch_on},
    {transition::t3, state::ready_to_switch_on, command::switch_on, state::switched_on},
    {transition::t3b, state::ready_to_switch_on, command::enable_operation, state::operation_enabled},
    {transition::t4, state::switched_on, command::enable_operation, state::operation_enabled},
    {transition::t5, state::operation_enabled, command::switch_on, state::switched_on},
    {transition::t6, state::switched_on, command::shutdown, state::ready_to_switch_on},
    {transition::t7, state::ready_to_switch_on, command::disable_voltage, state::switch_on_disabled},
    {transition::t7, state::ready_to_switch_on, command::quick_stop, state::switch_on_disabled},
    {transition::t8, state::operation_enabled, command::shutdown, state::ready_to_switch_on},
    {transition::t9, state::operation_enabled, command::disable_voltage, state::switch_on_disabled},
    {transition::t10, state::switched_on, command::disable_voltage, state::switch_on_disabled},
    {transition::t10, state::switched_on, command::quick_stop, state::switch_on_disabled},
    {transition::t11, state::operation_enabled, command::quick_stop, state::quick_stop_active},
    {transition::t12, state::quick_stop_active, command::disable_voltage, state::switch_on_disabled},
    {transition::t15, state::fault, command::fault_reset, state::switch_on_disabled},
    {transition::t16, state::quick_stop_active, command::enable_operation, state::operation_enabled},
}};

} // namespace cia402

namespace detail {

/// Whether a drive with these options has a transition.
[[nodiscard]] constexpr bool is_present(cia402::transition number,
                                        cia402::state_machine_options const& options) noexcept
{
    if (number == cia402::transition::t3b) {
        return options.enables_from_ready;
    }
    return number != cia402::transition::t16 or options.resumes_from_quick_stop;
}

} // namespace detail

namespace cia402 {

/// The transition that a command causes in a state; `none` to the same state where it is not accepted.
[[nodiscard]] constexpr transition_rule step(state from, command cause, state_machine_options const& options) noexcept
{
    for (transition_rule const& each : transition_rules) {
        if (each.from == from and each.cause == cause and detail::is_present(each.number, options)) {
            return each;
        }
    }
    return {transition::none, from, cause, from};
}

/// The number of a transition as the diagrams print it.
[[nodiscard]] constexpr literal name_of(transition number) noexcept
{
    constexpr std::array<literal, 18> names{"0", "1",  "2",  "3",  "4",  "5",  "6",  "7",  "8",
                                            "9", "10", "11", "12", "13", "14", "15", "16", "3B"};
    auto const at = static_cast<std::uint8_t>(number);
    return at < names.size() ? names[at] : literal{"none"};
}

/// The same, for what shows any value.
[[nodiscard]] constexpr literal text_of(transition of) noexcept { return name_of(of); }

} // namespace cia402
} // namespace RTUWIRE_BUILD
} // namespace rtuwire
