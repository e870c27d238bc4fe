// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// The drive's side of the state machine: its state, what a control word does, what happens by itself. Knows no motor:
// "at rest" and "the cause is gone" are reported to it. Commands take the transitions of cia402/transition.hpp; the
// others are its own (number, or - where the profile has none):
//
//   state                  event                                  -> next state
//   any                    power_up                               -> not ready to switch on      0
//   not ready to switch on initialised                            -> switch on disabled          1
//   ready to switch on     enable operation, without 3B           -> operation enabled           3, then 4
//   operation enabled      switch on                              -> the same, leaving           -
//   leaving                at_rest                                -> switched on                 5
//                          enable operation                       -> operation enabled           -
//   quick stop active      at_rest, unless the quick stop waits   -> switch on disabled          12
//   any but a fault        trip                                   -> fault reaction active       13
//   fault reaction active  at_rest                                -> fault                       14
//   fault                  fault reset, once the cause is gone    -> switch on disabled          15
//   any but a fault and
//   not ready to switch on enable_directly                        -> operation enabled           -
#pragma once

#include <cstdint>

#include <rtuwire/cia402/transition.hpp>
#include <rtuwire/core/version.hpp>

namespace rtuwire {
inline namespace RTUWIRE_BUILD {
namespace detail {

/// A state machine that follows commands.
class state_machine {
public:
    explicit constexpr state_machine(cia402::state_machine_options const& options) noexcept : options_{options} {}

    [[nodiscard]] constexpr cia402::state state() const noexcept { return state_; }

    /// The last transition.
    [[nodiscard]] constexpr cia402::transition last() const noexcept { return last_; }

    /// All transitions since power-up, one bit each by number.
    [[nodiscard]] constexpr std::uint32_t taken() const noexcept { return taken_; }

    /// Whether "disable operation" waits for the motor to come to rest.
    [[nodiscard]] constexpr bool is_leaving() const noexcept { return is_leaving_; }

    /// Whether the present fault came during a quick stop.
    [[nodiscard]] constexpr bool tripped_in_quick_stop() const noexcept { return tripped_in_quick_stop_; }

    /// Transitions 0 and 1.
    constexpr void power_up() noexcept
    {
        is_leaving_ = false;
        taken_ = 0;
        go(cia402::transition::t0, cia402::state::not_ready_to_switch_on);
    }
    constexpr void initialised() noexcept
    {
        if (state_ == cia402::state::not_ready_to_switch_on) {
            go(cia402::transition::t1, cia402::state::switch_on_disabled);
        }
    }

    /// Applies a command. A fault is reset only when its cause is gone; "disable operation" takes effect at rest.
    constexpr void apply(cia402::command what, bool cause_is_gone) noexcept
    {
        if (what == cia402::command::fault_reset and not cause_is_gone) {
            return;
        }
        cia402::transition_rule const taken = cia402::step(state_, what, options_);
        if (state_ == cia402::state::operation_enabled) {
            is_leaving_ = taken.number == cia402::transition::t5;
            if (is_leaving_) {
                return;
            }
        }
        if (taken.number != cia402::transition::none) {
            go(taken.number, taken.to);
        } else if (state_ == cia402::state::ready_to_switch_on and what == cia402::command::enable_operation) {
            // Bit 3 is an x in "switch on", so this word is that as well; it stays set and then enables.
            go(cia402::transition::t3, cia402::state::switched_on);
            go(cia402::transition::t4, cia402::state::operation_enabled);
        }
    }

    /// Direct control: in operation at once, unless in fault.
    constexpr void enable_directly() noexcept
    {
        bool const is_able = state_ != cia402::state::fault and state_ != cia402::state::fault_reaction_active and
                             state_ != cia402::state::not_ready_to_switch_on;
        if (is_able) {
            state_ = cia402::state::operation_enabled;
            is_leaving_ = false;
        }
    }

    /// The motor is at rest: completes the transitions that wait for this.
    constexpr void at_rest() noexcept
    {
        if (is_leaving_) {
            is_leaving_ = false;
            go(cia402::transition::t5, cia402::state::switched_on);
        }
        if (state_ == cia402::state::quick_stop_active and not options_.quick_stop_waits) {
            go(cia402::transition::t12, cia402::state::switch_on_disabled);
        }
        if (state_ == cia402::state::fault_reaction_active) {
            go(cia402::transition::t14, cia402::state::fault);
        }
    }

    /// Transition 13.
    constexpr void trip() noexcept
    {
        if (state_ != cia402::state::fault and state_ != cia402::state::fault_reaction_active) {
            tripped_in_quick_stop_ = state_ == cia402::state::quick_stop_active;
            go(cia402::transition::t13, cia402::state::fault_reaction_active);
        }
    }

    /// STOP key, freewheel input, local control or a configuration write: back to "switch on disabled"
    /// by 7, 9, 10 or 12.
    constexpr void fall_back() noexcept { apply(cia402::command::disable_voltage, true); }

private:
    constexpr void go(cia402::transition number, cia402::state to) noexcept
    {
        state_ = to;
        last_ = number;
        is_leaving_ = false;
        taken_ |= std::uint32_t{1} << static_cast<unsigned>(number);
    }

    cia402::state_machine_options options_;
    std::uint32_t taken_{0};
    cia402::state state_{cia402::state::not_ready_to_switch_on};
    cia402::transition last_{cia402::transition::none};
    bool is_leaving_{false};
    bool tripped_in_quick_stop_{false};
};

} // namespace detail
} // namespace RTUWIRE_BUILD
} // namespace rtuwire
