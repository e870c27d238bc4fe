// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// Which request of a cycle comes next, whatever the device: what has to be sent before anything else comes first, then
// what has to be read before the next write; it depends on the drive's state and order, and on what was answered. It knows
// no frames and no clock.
// Internal: may change with any version.
#pragma once

#include <cstdint>
#include <utility>

#include <rtuwire/altivar/cyclic/cyclic_control.hpp>
#include <rtuwire/ask/commander.hpp>
#include <rtuwire/core/version.hpp>

namespace rtuwire {
inline namespace RTUWIRE_BUILD {
namespace altivar {

/// The requests of a cycle.
enum class cycle_step : std::uint8_t {
    look,
    look_for_fault,
    prepare, ///< reads the drive's safeguards and its scanner's addresses
    exchange,
    read,              ///< the first half of an exchange by functions 03 and 16
    write,             ///< and the second
    say_stop,          ///< the stop command, by function 06
    observe,           ///< reads as an exchange does, and writes nothing
    check_control,     ///< the control word, before the command to run
    compare_meaning,   ///< CHCF, from time to time while it runs: in the I/O profile it runs by the same word
    compare_control,   ///< the control word, in the same way
    compare_reference, ///< and the reference
};

/// The control word is read back before each command to run; CHCF, it and the reference in turn every tenth exchange.
class cycle_comparison {
public:
    /// The drive accepted an exchange.
    constexpr void note_exchange() noexcept
    {
        exchanges_ = static_cast<std::uint8_t>(exchanges_ + (exchanges_ < exchanges_between ? 1 : 0));
    }
    /// One of the two was read back.
    constexpr void note_comparison(cycle_step which) noexcept
    {
        is_checked_ = which == cycle_step::check_control;
        next_ = which == cycle_step::compare_meaning   ? cycle_step::compare_control
                : which == cycle_step::compare_control ? cycle_step::compare_reference
                                                       : cycle_step::compare_meaning;
        exchanges_ = 0;
    }

    /// The motor stands that was turning: CHCF is read next.
    constexpr void note_standstill() noexcept
    {
        next_ = cycle_step::compare_meaning;
        exchanges_ = exchanges_between;
    }

    /// Whether the command to run may be sent: the control word was read back, and nothing happened since.
    [[nodiscard]] constexpr bool is_checked() const noexcept { return is_checked_; }
    constexpr void keep_if(bool is_still_so) noexcept { is_checked_ = is_checked_ and is_still_so; }

    /// Whether a comparison is due while the motor runs, and of which word.
    [[nodiscard]] constexpr bool is_due() const noexcept { return exchanges_ >= exchanges_between; }
    [[nodiscard]] constexpr cycle_step next() const noexcept { return next_; }

private:
    static constexpr std::uint8_t exchanges_between = 10;

    std::uint8_t exchanges_{0};
    bool is_checked_{false};
    cycle_step next_{cycle_step::compare_meaning};
};

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

/// The steps of one drive's cycle. `is_prepared`: the drive was checked. "First" is `exchange`, or `read` where an
/// exchange takes two requests; (f) is `look_for_fault` where the drive is newly in fault, (s) `say_stop` where it may
/// turn without an order, (p) `prepare` and (l) `look` where it was not checked.
///
/// | step           | response               | one miss, while ordered  | lost     | cancelled | overruled |
/// |----------------|------------------------|--------------------------|----------|-----------|-----------|
/// | look           | look_for_fault         | look                     | look     | the same  | look      |
/// | look_for_fault | first (p)              | look                     | look     | the same  | look      |
/// | prepare        | itself, then first (f) | look                     | look     | the same  | look      |
/// | exchange       | first (f)              | look                     | look     | the same  | look      |
/// | read           | write (f)              | look                     | look     | the same  | look      |
/// | write          | first                  | look                     | look     | the same  | look      |
/// | say_stop       | observe (l)            | the same                 | the same | the same  | look      |
/// | observe        | first (f) (s)          | look                     | look     | the same  | look      |
/// | check_control  | exchange, or write     | look                     | look     | the same  | look      |
/// | compare_...    | first                  | look                     | look     | the same  | look      |
///
/// One miss of a drive without an order leaves the step as it is.
class cycle_agenda {
    using step = cycle_step;

public:
    /// With the step that begins an exchange: one request, or the first half of two.
    explicit constexpr cycle_agenda(cycle_step first) noexcept : position_{first} {}

    [[nodiscard]] constexpr cyclic_control& control() noexcept { return control_; }
    [[nodiscard]] constexpr cyclic_control const& control() const noexcept { return control_; }
    [[nodiscard]] constexpr cycle_step now() const noexcept { return position_.now(); }
    [[nodiscard]] constexpr bool is_lost() const noexcept { return is_lost_; }
    [[nodiscard]] constexpr bool is_missed() const noexcept { return misses_ != 0; }

    constexpr bool run(std::uint16_t reference) noexcept
    {
        bool const is_taken = control_.run(reference);
        if (is_taken) {
            duty_.take_order();
        }
        return is_taken;
    }
    constexpr void stop(stop_by how) noexcept
    {
        unheard_halts_ = 0;
        control_.stop(how);
        duty_.take_stop(control_.is_halting());
    }

    /// Each reported once: what a read found of the motor's power; the next request waits for a period.
    constexpr detail::power_seen take_power() noexcept
    {
        detail::power_seen const seen = control_.take_power();
        duty_.note_look(seen == detail::power_seen::off or seen == detail::power_seen::waits);
        return seen;
    }
    constexpr bool take_pause() noexcept { return std::exchange(waits_, false); }

    /// The step that is due now. `was_rearranged`: another conversation may have changed the drive; `last_command`: the
    /// control word written last.
    [[nodiscard]] constexpr cycle_step due(bool is_prepared, bool was_rearranged,
                                           std::uint16_t last_command) const noexcept
    {
        return position_.due(control_, duty_, is_prepared, was_rearranged, last_command);
    }
    constexpr void begin(cycle_step next) noexcept { position_.go_to(next); }

    /// A request that writes is made.
    constexpr void note_write() noexcept { position_.note_write(); }

    /// A response came, whatever it holds.
    constexpr void note_response() noexcept { misses_ = 0; }

    /// The drive has accepted what was written.
    constexpr void end_exchange() noexcept
    {
        position_.note_taken();
        wait_a_period();
    }

    /// The drive accepted the stop command; its state is read next.
    constexpr void end_stop_word(bool is_prepared) noexcept
    {
        unheard_halts_ = 0;
        duty_.note_said();
        position_.go_to(is_prepared ? step::observe : step::look);
        if (not is_lost_) {
            wait_a_period();
        }
    }

    constexpr void take_look(std::uint16_t status) noexcept
    {
        control_.note_status(status, false);
        position_.go_to(step::look_for_fault);
    }
    constexpr void take_fault_code(std::uint16_t code, bool is_prepared) noexcept
    {
        control_.note_fault(code);
        position_.go_to(is_prepared ? position_.first() : step::prepare);
    }

    /// The drive may be ordered; the last word of its check was this status.
    constexpr void end_preparation(std::uint16_t status) noexcept
    {
        position_.go_to(judge(status, false) ? step::look_for_fault : position_.first());
        is_lost_ = false;
    }
    /// It must not, for this reason.
    constexpr void fail_preparation(outcome_kind found) noexcept
    {
        duty_.note_finding(control_.is_ordered());
        control_.note_finding(found);
        duty_.say_if(control_.must_stop());
        is_lost_ = true;
        position_.go_to(step::look);
        wait_a_period();
    }

    /// A status word of 0: a drive that was powered up, or another scanner setting; its ETA tells which.
    constexpr void look_again() noexcept { position_.go_to(step::look); }

    /// The drive was not heard for long: it is read before the next write of an order.
    constexpr void doubt() noexcept
    {
        bool const writes = now() == step::exchange or now() == step::write;
        if (writes and control_.is_ordered()) {
            position_.keep_comparison_if(false);
            position_.go_to(step::look);
        }
    }

    /// An exchange, or a read, has found this status.
    constexpr void take_status(std::uint16_t status, bool stands) noexcept
    {
        step const at = position_.now();
        duty_.note_read(at == step::observe);
        bool const is_newly_in_fault = judge(status, stands);
        if (at == step::read) {
            position_.go_to(step::write);
        } else if (at == step::exchange) {
            end_exchange();
        } else if (control_.must_stop()) {
            position_.go_to(step::say_stop); // right after the read
        } else {
            position_.go_to(position_.first());
            wait_a_period();
        }
        if (is_newly_in_fault) {
            position_.go_to(step::look_for_fault);
        }
    }

    /// The motor stands that was turning.
    constexpr void note_standstill() noexcept { position_.note_standstill(); }

    /// A status or a comparison has ended the order: what may turn, or is one word away from that, is stopped first.
    constexpr void note_end_of_order() noexcept
    {
        bool const waits = power_in(control_.state()) == detail::power_seen::waits and not control_.gives_way();
        duty_.note_finding(true);
        duty_.say_if(waits or control_.must_stop());
        waits_ = waits_ and not duty_.must_say();
    }

    /// The drive holds what was written last, or another client commands it, or it lost its power.
    constexpr void compare(std::uint16_t found, std::uint16_t written) noexcept
    {
        if (found != written) {
            control_.note_overwritten();
            wait_a_period();
        }
        position_.note_comparison();
    }

    /// A request failed. Whether all that is known of the drive has to be read again.
    constexpr bool miss(errc error, std::uint8_t tolerated_misses) noexcept
    {
        wait_a_period();
        if (error == errc::cancelled) {
            return false; // another conversation, or its owner, took precedence
        }
        if (error == errc::overruled) {
            yield();
            return false;
        }
        if (now() == step::say_stop) { // repeated, as long as the client allows it
            if (control_.is_halting() and ++unheard_halts_ == most_unheard_halts) {
                stop(stop_by::ramp);
            }
            position_.go_to(control_.is_halting() ? step::observe : step::say_stop);
            return false;
        }
        bool const is_final = error == errc::unit_lost or error == errc::too_many_ordered or is_exception(error);
        if (misses_ < tolerated_misses and not is_final) {
            ++misses_;
            return start_over();
        }
        lose(error);
        return true;
    }

    /// The link is lost, or its data cannot be trusted.
    constexpr void lose(errc error) noexcept
    {
        duty_.note_loss(control_.may_run());
        control_.note_loss(error);
        is_lost_ = true;
        position_.go_to(step::look);
    }

    /// A stop by another conversation is in force: the drive is read, and nothing is written.
    constexpr void yield() noexcept
    {
        control_.note_overruled();
        duty_.yield();
        position_.go_to(step::look);
    }

    /// Waits a period before the next request; a stop command does not wait, unless it is itself repeated.
    constexpr void wait_a_period() noexcept
    {
        waits_ = not(duty_.must_say() or duty_.must_observe()) or now() == step::say_stop;
    }

private:
    /// Takes a status; whether the drive is newly in fault.
    constexpr bool judge(std::uint16_t status, bool stands) noexcept
    {
        bool const was_in_fault = cia402::is_in_fault(control_.state());
        control_.note_status(status, stands);
        position_.keep_comparison_if(control_.is_about_to_enable());
        return not was_in_fault and cia402::is_in_fault(control_.state());
    }

    /// A request to an ordered drive was not answered: it may have lost its power meanwhile, so it is read before the next
    /// write. One that does not run yet is checked anew; one that did is, where it is found not to run any more.
    constexpr bool start_over() noexcept
    {
        if (not control_.is_ordered()) {
            return false;
        }
        position_.keep_comparison_if(false);
        control_.note_miss();
        position_.go_to(step::look);
        return not control_.is_running();
    }

    /// So many words of a halt in a row without an answer, with answered reads between them, and the ramp's takes its place: that is
    /// repeated without a read, and ends in silence.
    static constexpr std::uint8_t most_unheard_halts = 3;

    cyclic_control control_{};
    stop_duty duty_{};
    cycle_position position_;
    std::uint8_t misses_{0};
    std::uint8_t unheard_halts_{0};
    bool is_lost_{true};
    bool waits_{false}; ///< a period, until the next request
};

} // namespace altivar
} // namespace RTUWIRE_BUILD
} // namespace rtuwire
