// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// Where a cycle is, and which request is due there: what has to be sent before anything else comes first, then what
// has to be read before the next write.
// Internal: may change with any version.
#pragma once

#include <cstdint>

#include <rtuwire/altivar/cyclic/cycle_step.hpp>
#include <rtuwire/altivar/cyclic/cyclic_control.hpp>
#include <rtuwire/core/version.hpp>

namespace rtuwire {
inline namespace RTUWIRE_BUILD {
namespace altivar {

/// What has to be sent to a drive before anything else, because it was stopped or lost.
class stop_duty {
public:
    /// A stop was ordered. A halt is sent after a read.
    constexpr void take_stop(bool is_halt) noexcept
    {
        is_coming_down_ = true;
        must_say_ = not is_halt;
        must_observe_ = is_halt;
    }
    /// An order to run was accepted.
    constexpr void take_order() noexcept { must_say_ = false; }

    /// The link was lost; `may_run`: the drive may be running.
    constexpr void note_loss(bool may_run) noexcept
    {
        is_coming_down_ = is_coming_down_ or may_run;
        must_say_ = is_coming_down_;
    }
    /// The drive must not be ordered any more.
    constexpr void note_finding(bool was_ordered) noexcept { is_coming_down_ = is_coming_down_ or was_ordered; }
    constexpr void say_if(bool must_stop) noexcept { must_say_ = is_coming_down_ and must_stop; }

    /// Another conversation's stop is in force.
    constexpr void yield() noexcept
    {
        must_say_ = false;
        is_coming_down_ = false;
    }
    constexpr void note_said() noexcept { must_say_ = false; }

    /// The drive was read by the step `observe`, or by another; it was found without power, or not.
    constexpr void note_read(bool is_observed) noexcept { must_observe_ = must_observe_ and not is_observed; }
    constexpr void note_look(bool is_at_rest) noexcept { is_coming_down_ = is_coming_down_ and not is_at_rest; }

    [[nodiscard]] constexpr bool must_say() const noexcept { return must_say_; }
    [[nodiscard]] constexpr bool must_observe() const noexcept { return must_observe_; }

private:
    bool must_say_{false};       ///< the stop command
    bool must_observe_{false};   ///< a read, where a halt was ordered
    bool is_coming_down_{false}; ///< it was stopped here, or lost its order while it ran
};

/// The step that a cycle has come to, and what was read back since. The first situation that holds decides what is due;
/// elsewhere a step is due where the cycle is.
///
/// | situation                                          | exchange, read  | write         | say_stop | any other step |
/// |----------------------------------------------------|-----------------|---------------|----------|----------------|
/// | a stop must be sent                                | say_stop        | say_stop      | say_stop | say_stop       |
/// | an order, or a reset                               |                 |               | look     |                |
/// | a halt was ordered, and the drive was checked      | observe         | observe       | observe  | observe        |
/// | not checked, or rearranged by another conversation | look            | look          |          |                |
/// | a halt is under way                                | observe         | observe       |          |                |
/// | the drive may turn without an order                | say_stop        | say_stop      |          |                |
/// | no order, and another conversation's order counts  | observe         | observe       |          |                |
/// | the word that it accepted would be sent again      | observe         | observe       |          |                |
/// | the command to run is next, CMD was not read back  | check_control, but read | check_control | |              |
/// | ten exchanges since the last comparison            | compare_meaning, ..._control, ..._reference in turn | | | |
class cycle_position {
    using step = cycle_step;

public:
    /// With the step that begins an exchange: one request, or the first half of two.
    explicit constexpr cycle_position(cycle_step first) noexcept : first_{first} {}

    [[nodiscard]] constexpr cycle_step now() const noexcept { return now_; }
    [[nodiscard]] constexpr cycle_step first() const noexcept { return first_; }
    constexpr void go_to(cycle_step next) noexcept { now_ = next; }

    /// A request that writes is made; the drive accepted it.
    constexpr void note_write() noexcept { was_taken_ = false; }
    constexpr void note_taken() noexcept
    {
        was_taken_ = true;
        comparison_.note_exchange();
        now_ = first_;
    }

    /// A word was read back, as it should be or not.
    constexpr void note_comparison() noexcept
    {
        bool const is_before_enabling = now_ == step::check_control;
        comparison_.note_comparison(now_);
        now_ = is_before_enabling and first_ == step::read ? step::write : first_;
    }
    constexpr void note_standstill() noexcept { comparison_.note_standstill(); }
    constexpr void keep_comparison_if(bool is_still_so) noexcept { comparison_.keep_if(is_still_so); }

    /// The step that is due now: before any other step, a drive that must not run is stopped; one that is halted is
    /// read first, because the halt's word could enable it in another state. `is_prepared`: the drive was checked;
    /// `was_rearranged`: another conversation may have changed it since; `last_command`: the control word written last.
    [[nodiscard]] constexpr cycle_step due(cyclic_control const& control, stop_duty const& duty, bool is_prepared,
                                           bool was_rearranged, std::uint16_t last_command) const noexcept
    {
        if (duty.must_say()) {
            return step::say_stop;
        }
        bool const is_exchange = now_ == step::exchange or now_ == step::read;
        bool const writes = is_exchange or now_ == step::write;
        if (now_ == step::say_stop and control.moves()) {
            return step::look; // an order came after a stop that was not answered
        }
        if (duty.must_observe() and is_prepared) {
            return step::observe;
        }
        if (not writes) {
            return now_;
        }
        if (not is_prepared or was_rearranged) {
            return step::look;
        }
        if (control.must_stop()) {
            return control.is_halting() ? step::observe : step::say_stop;
        }
        if (control.gives_way()) {
            return step::observe;
        }
        // A word that the drive accepted and does not follow is not sent again: where its STOP key was pressed after
        // it, or its power failed briefly, the drive is only read.
        if (was_taken_ and control.would_repeat(last_command)) {
            return step::observe;
        }
        bool const is_enabling = now_ != step::read and control.is_about_to_enable();
        if (is_enabling and not comparison_.is_checked()) {
            return step::check_control;
        }
        bool const is_running = control.is_ordered() and control.is_running();
        return is_exchange and is_running and comparison_.is_due() ? comparison_.next() : now_;
    }

private:
    cycle_comparison comparison_{};
    step first_;
    step now_{step::look};
    bool was_taken_{false}; ///< the drive answered the last write
};

} // namespace altivar
} // namespace RTUWIRE_BUILD
} // namespace rtuwire
