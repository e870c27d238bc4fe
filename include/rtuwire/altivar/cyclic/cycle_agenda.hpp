// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// Which request of a cycle comes next, whatever the device: it depends on the drive's state and order, on what was
// answered, and on what has to be sent before anything else. It knows no frames and no clock.
// Internal: may change with any version.
#pragma once

#include <cstdint>
#include <utility>

#include <rtuwire/altivar/cyclic/cycle_position.hpp>
#include <rtuwire/altivar/cyclic/cycle_step.hpp>
#include <rtuwire/altivar/cyclic/cyclic_control.hpp>
#include <rtuwire/ask/commander.hpp>
#include <rtuwire/core/version.hpp>

namespace rtuwire {
inline namespace RTUWIRE_BUILD {
namespace altivar {

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

    cyclic_control control_{};
    stop_duty duty_{};
    cycle_position position_;
    std::uint8_t misses_{0};
    bool is_lost_{true};
    bool waits_{false}; ///< a period, until the next request
};

} // namespace altivar
} // namespace RTUWIRE_BUILD
} // namespace rtuwire
