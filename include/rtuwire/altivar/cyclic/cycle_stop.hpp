// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// A stop that was ordered in a cycle, from the order until the drive is at rest, and the word that stops it.
// Internal: may change with any version.
#pragma once

#include <cstdint>
#include <utility>

#include <rtuwire/altivar/cyclic/cycle_sight.hpp>
#include <rtuwire/altivar/procedure/motion/stop.hpp>
#include <rtuwire/cia402/command.hpp>
#include <rtuwire/core/version.hpp>

namespace rtuwire {
inline namespace RTUWIRE_BUILD {
namespace altivar {

/// The stop of one drive.
class cycle_stop {
public:
    /// Orders a stop. Another one does not replace a freewheel; DC injection is the ramp here.
    constexpr void order(stop_by how) noexcept
    {
        bool const coasts = is_under_way_ and how_ == stop_by::freewheel;
        how_ = coasts ? how_ : how;
        is_under_way_ = true;
    }

    /// An order to run ends a halt.
    constexpr void end() noexcept { is_under_way_ = false; }

    /// Takes what was read. A stop has ended where the drive is in a state in which no single word can start it.
    constexpr void note(cycle_sight const& seen) noexcept
    {
        bool const is_low = seen.state() == cia402::state::switch_on_disabled or
                            seen.state() == cia402::state::not_ready_to_switch_on or
                            seen.state() == cia402::state::fault;
        // A halt stays in force in operation; the next order ends it.
        bool const is_over = is_under_way_ and (is_low or (is_halting(seen) and seen.stands()));
        has_ended_ = has_ended_ or is_over;
        is_under_way_ = is_under_way_ and not is_low;
    }

    /// Whether a stop has ended; reported once.
    constexpr bool take_end() noexcept { return std::exchange(has_ended_, false); }

    /// Whether a halt was ordered, and is under way.
    [[nodiscard]] constexpr bool is_halting(cycle_sight const& seen) const noexcept
    {
        return is_under_way_ and how_ == stop_by::halt and seen.state() == cia402::state::operation_enabled;
    }

    /// Whether an order may follow: there is no stop, or a halt whose motor stands.
    [[nodiscard]] constexpr bool is_over(cycle_sight const& seen) const noexcept
    {
        return not is_under_way_ or (is_halting(seen) and seen.stands());
    }

    /// The control word of a drive that must not run, whether a stop was ordered or not.
    [[nodiscard]] constexpr std::uint16_t word(cycle_sight const& seen) const noexcept
    {
        switch (seen.state()) {
        case cia402::state::operation_enabled:
        case cia402::state::quick_stop_active: return word_with_power(seen);
        case cia402::state::unknown:
            // An unknown state, or one that can no longer be read, may be "operation enabled".
            return seen.is_known() or seen.was_lost_running() or is_under_way_ ? word_with_power(seen)
                                                                               : std::uint16_t{0};
        case cia402::state::not_ready_to_switch_on:
        case cia402::state::switch_on_disabled:
        case cia402::state::ready_to_switch_on:
        case cia402::state::switched_on:
        case cia402::state::fault_reaction_active:
        case cia402::state::fault: break;
        }
        // Without power, but perhaps one word away from it: to a state where no single word can start the motor.
        return seen.has_enabled() ? word_with_power(seen) : std::uint16_t{0};
    }

private:
    /// The stop command in operation or in a quick stop. A quick stop, also one by another client, goes on until the
    /// motor is at rest; only a freewheel ends it.
    constexpr std::uint16_t word_with_power(cycle_sight const& seen) const noexcept
    {
        if (is_halting(seen)) {
            return cia402::word_of(cia402::command::enable_operation) | detail::halt_bit;
        }
        bool const stands = seen.stands() and not seen.has_enabled();
        if (stands or (is_under_way_ and how_ == stop_by::freewheel)) {
            return cia402::word_of(cia402::command::disable_voltage);
        }
        bool const is_quick =
            seen.state() == cia402::state::quick_stop_active or (is_under_way_ and how_ == stop_by::quick_stop);
        return cia402::word_of(is_quick ? cia402::command::quick_stop : cia402::command::switch_on);
    }

    stop_by how_{stop_by::ramp};
    bool is_under_way_{false};
    bool has_ended_{false};
};

} // namespace altivar
} // namespace RTUWIRE_BUILD
} // namespace rtuwire
