// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// The steps of a cycle: which request comes next, and what its response changes; no clock. A drive that must not run
// is stopped by function 06 and otherwise only read. After a loss the stop command is sent to it, as long as the
// client allows it, and it is read before anything else is written.
#pragma once

#include <cstddef>
#include <cstdint>
#include <utility>

#include <rtuwire/altivar/cyclic/cycle_frames.hpp>
#include <rtuwire/altivar/cyclic/cycle_layout.hpp>
#include <rtuwire/altivar/cyclic/cycle_preparation.hpp>
#include <rtuwire/altivar/cyclic/cycle_step.hpp>
#include <rtuwire/altivar/cyclic/cyclic_control.hpp>
#include <rtuwire/altivar/cyclic/cyclic_options.hpp>
#include <rtuwire/ask/commander.hpp>
#include <rtuwire/core/time.hpp>
#include <rtuwire/core/version.hpp>
#include <rtuwire/table/device.hpp>

namespace rtuwire::inline RTUWIRE_BUILD::altivar {

/// The requests to one drive, one by one.
template <device_type Device> class cycle_steps {
    using words = cycle_layout<Device>;
    using step = cycle_step;

public:
    constexpr cycle_steps(unit_id unit, cyclic_options const& options) noexcept
        : preparation_{options.supervision}, options_{options}, period_{options.period}, frames_{unit}
    {}

    /// The user's orders. An order to run is accepted only for a drive that was checked.
    constexpr bool run(std::uint16_t reference) noexcept
    {
        bool const is_taken = preparation_.succeeded() and control_.run(reference);
        must_say_stop_ = must_say_stop_ and not is_taken;
        return is_taken;
    }
    constexpr void stop(stop_by how) noexcept
    {
        bool const has_none = how == stop_by::halt and Device::layout.halt == 0;
        control_.stop(has_none ? stop_by::ramp : how);
        is_coming_down_ = true;
        must_say_stop_ = not control_.is_halting();
        must_observe_ = control_.is_halting();
    }
    constexpr bool reset_fault() noexcept { return control_.reset_fault(); }

    /// Another conversation stopped the drive.
    constexpr void note_stopped() noexcept { control_.note_stopped(); }

    /// Enabling took too long.
    constexpr void note_late() noexcept { control_.note_late(); }
    [[nodiscard]] constexpr cycle_frames<Device>& frames() noexcept { return frames_; }
    [[nodiscard]] constexpr cycle_frames<Device> const& frames() const noexcept { return frames_; }
    [[nodiscard]] constexpr cyclic_control const& control() const noexcept { return control_; }
    [[nodiscard]] constexpr supervision_report const& report() const noexcept { return preparation_.report(); }
    [[nodiscard]] constexpr bool is_lost() const noexcept { return is_lost_; }

    /// The time from one exchange to the next.
    [[nodiscard]] constexpr duration period() const noexcept { return period_; }

    /// What the next request does to the motor; `was_rearranged`: another conversation may have changed the drive.
    [[nodiscard]] constexpr effect intent(bool was_rearranged) const noexcept
    {
        step const next = due_step(was_rearranged);
        if (next == step::say_stop) {
            return effect::stopping;
        }
        if (next != step::exchange and next != step::write) {
            return effect::none;
        }
        return control_.is_resetting() ? effect::resetting : control_.is_ordered() ? effect::enabling : effect::none;
    }

    /// The next request.
    constexpr byte_view ask(bool was_rearranged) noexcept
    {
        step_ = due_step(was_rearranged);
        if (was_rearranged) {
            preparation_.renew();
        }
        return make_frame();
    }

    /// Whether a read found the drive without power, or newly in fault, whether a stop that was ordered here has
    /// ended, and whether the next request waits for a period; each reported once.
    constexpr bool take_rest() noexcept
    {
        bool const is_read = control_.take_rest();
        is_coming_down_ = is_coming_down_ and not is_read;
        return is_read;
    }
    constexpr bool take_fault() noexcept { return control_.take_fault(); }
    constexpr bool take_end_of_stop() noexcept { return control_.take_end_of_stop(); }
    constexpr bool take_pause() noexcept { return std::exchange(waits_, false); }

    /// Takes the response to the request.
    constexpr void take(response const& response) noexcept
    {
        misses_ = 0;
        if (step_ == step::write) {
            return end_exchange();
        }
        if (step_ == step::say_stop) {
            return end_stop_word();
        }
        constexpr std::size_t words_from = 2;
        register_view const read{response.pdu().subspan(words_from)};
        switch (step_) {
        case step::look: return take_look(read[0]);
        case step::look_for_fault:
            control_.note_fault(read[0]);
            step_ = step_after_look();
            return;
        case step::prepare: preparation_.take(read, frames_.outputs_in_use()); return go_on_preparing();
        case step::check_control:
        case step::compare_control: return compare(read[0], frames_.command());
        case step::compare_reference: return compare(read[0], frames_.reference());
        case step::exchange:
        case step::read:
        case step::observe:
        case step::write:
        case step::say_stop: break;
        }
        take_inputs(read);
    }

    constexpr void miss(errc error) noexcept
    {
        if (step_ == step::prepare and is_exception(error)) {
            preparation_.take_exception(error);
            return go_on_preparing();
        }
        wait_a_period();
        if (error == errc::cancelled) {
            return; // another conversation, or its owner, took precedence
        }
        if (error == errc::overruled) {
            return yield();
        }
        if (step_ == step::say_stop) { // repeated, as long as the client allows it
            step_ = control_.is_halting() ? step::observe : step_;
            return;
        }
        bool const is_final = error == errc::unit_lost or error == errc::too_many_ordered or is_exception(error);
        bool const is_tolerated = misses_ < options_.tolerated_misses and not is_final;
        if (is_tolerated) {
            ++misses_;
            return start_over();
        }
        lose(error);
    }

    /// The link is lost, or its data cannot be trusted.
    constexpr void lose(errc error) noexcept
    {
        is_coming_down_ = is_coming_down_ or control_.may_run();
        must_say_stop_ = is_coming_down_;
        control_.note_loss(error);
        preparation_.renew();
        is_lost_ = true;
        step_ = step::look;
    }

private:
    /// The step that is due now: before any other step, a drive that must not run is stopped; one that is halted is
    /// read first, because the halt's word could enable it in another state.
    constexpr step due_step(bool was_rearranged) const noexcept
    {
        if (must_say_stop_) {
            return step::say_stop;
        }
        bool const is_exchange = step_ == step::exchange or step_ == step::read;
        bool const writes = is_exchange or step_ == step::write;
        if (step_ == step::say_stop and control_.moves()) {
            return step::look; // an order came after a stop that was not answered
        }
        if (must_observe_ and preparation_.succeeded()) {
            return step::observe;
        }
        if (writes and (not preparation_.succeeded() or was_rearranged)) {
            return step::look;
        }
        if (writes and control_.must_stop()) {
            return control_.is_halting() ? step::observe : step::say_stop;
        }
        if (writes and repeats_itself()) {
            return step::observe;
        }
        bool const is_enabling = step_ != step::read and writes and control_.is_about_to_enable();
        if (is_enabling and not comparison_.is_checked()) {
            return step::check_control;
        }
        bool const is_running = control_.is_ordered() and control_.is_running();
        if (is_exchange and is_running and comparison_.is_due()) {
            return comparison_.next();
        }
        return step_;
    }

    /// Whether a word would be sent again that the drive accepted and does not follow. It would, where the drive fell
    /// back after it because its STOP key was pressed or its power failed briefly: such a drive is only read.
    constexpr bool repeats_itself() const noexcept { return was_taken_ and control_.would_repeat(frames_.command()); }

    constexpr step step_after_look() const noexcept { return preparation_.succeeded() ? first_step() : step::prepare; }

    constexpr step first_step() const noexcept
    {
        return words::fits_function_23 and options_.by_function_23 ? step::exchange : step::read;
    }

    constexpr byte_view make_frame() noexcept
    {
        constexpr drive_layout const& layout = Device::layout;
        switch (step_) {
        case step::look: return frames_.read_one(layout.eta);
        case step::look_for_fault: return frames_.read_one(layout.lft);
        case step::prepare: return frames_.read(preparation_.request());
        case step::read:
        case step::observe: return frames_.read_inputs();
        case step::say_stop:
            was_taken_ = false;
            return frames_.say(control_.word_to_stop(preparation_.meaning(), layout));
        case step::check_control:
        case step::compare_control: return frames_.read_one(layout.cmd);
        case step::compare_reference: return frames_.read_one(words::reference.address);
        case step::write:
        case step::exchange: break;
        }
        was_taken_ = false;
        std::uint16_t const command = control_.next_command();
        return step_ == step::write ? frames_.write(command, control_.reference())
                                    : frames_.exchange(command, control_.reference());
    }

    /// A request to a drive that does not run yet was not answered: the drive may have lost its power meanwhile. All
    /// that was known of it is read again.
    constexpr void start_over() noexcept
    {
        if (control_.is_ordered() and not control_.is_running()) {
            preparation_.renew();
            comparison_.keep_if(false);
            control_.note_miss();
            step_ = step::look;
        }
    }

    /// A stop by another conversation is in force: the drive is read, and nothing is written.
    constexpr void yield() noexcept
    {
        control_.note_overruled();
        must_say_stop_ = false;
        is_coming_down_ = false;
        step_ = step::look;
    }

    /// Waits a period before the next request; a stop command does not wait, unless it is itself repeated.
    constexpr void wait_a_period() noexcept
    {
        waits_ = not(must_say_stop_ or must_observe_) or step_ == step::say_stop;
    }

    /// The drive accepted the stop command; its state is read next.
    constexpr void end_stop_word() noexcept
    {
        must_say_stop_ = false;
        step_ = preparation_.succeeded() ? step::observe : step::look;
        if (not is_lost_) {
            wait_a_period();
        }
    }

    constexpr void take_look(std::uint16_t status) noexcept
    {
        control_.note_status(status, false);
        step_ = step::look_for_fault;
    }

    constexpr void go_on_preparing() noexcept
    {
        outcome_kind const found = preparation_.finding();
        if (found == outcome_kind::pending) {
            return;
        }
        step_ = first_step();
        if (found == outcome_kind::succeeded) {
            is_lost_ = false;
            duration const third = preparation_.report().period.longest_period();
            period_ = third != duration{} and third < options_.period ? third : options_.period;
            return;
        }
        is_coming_down_ = is_coming_down_ or control_.is_ordered();
        control_.note_finding(found);
        must_say_stop_ = is_coming_down_ and control_.must_stop();
        preparation_.renew();
        is_lost_ = true;
        step_ = step::look;
        wait_a_period();
    }

    constexpr void take_inputs(register_view read) noexcept
    {
        frames_.take(read);
        std::uint16_t const status = frames_.status();
        if (words::has_scanner and cia402::decode(status) == cia402::state::unknown) {
            return lose_words();
        }
        if (words::has_scanner and status == 0) {
            preparation_.renew(); // a drive that was powered up, or another scanner setting: its ETA tells which
            step_ = step::look;
            return;
        }
        note_inputs(status);
    }

    /// The first word is no status word: the scanner holds other registers.
    constexpr void lose_words() noexcept
    {
        lose(errc::malformed);
        wait_a_period();
    }

    constexpr void note_inputs(std::uint16_t status) noexcept
    {
        bool const was_in_fault = cia402::is_in_fault(control_.state());
        must_observe_ = must_observe_ and step_ != step::observe;
        control_.note_status(status, frames_.speed() == 0);
        if (step_ == step::read) {
            step_ = step::write;
        } else if (step_ == step::exchange) {
            end_exchange();
        } else if (control_.must_stop()) {
            step_ = step::say_stop; // right after the read
        } else {
            step_ = first_step();
            wait_a_period();
        }
        if (not was_in_fault and cia402::is_in_fault(control_.state())) {
            step_ = step::look_for_fault;
        }
        comparison_.keep_if(control_.is_about_to_enable());
    }

    /// The drive has accepted what was written.
    constexpr void end_exchange() noexcept
    {
        was_taken_ = true;
        comparison_.note_exchange();
        step_ = first_step();
        wait_a_period();
    }

    /// The drive holds what was written last, or another client commands it, or it lost its power.
    constexpr void compare(std::uint16_t found, std::uint16_t written) noexcept
    {
        bool const is_before_enabling = step_ == step::check_control;
        comparison_.note_comparison(step_);
        if (found != written) {
            control_.note_overwritten();
            wait_a_period();
        }
        step_ = is_before_enabling and first_step() == step::read ? step::write : first_step();
    }

    cyclic_control control_{};
    cycle_preparation<Device> preparation_;
    cyclic_options options_;
    duration period_;
    cycle_frames<Device> frames_;
    cycle_comparison comparison_{};
    step step_{step::look};
    std::uint8_t misses_{0};
    bool is_lost_{true};
    bool must_say_stop_{false};  ///< before anything else
    bool must_observe_{false};   ///< before anything else, where a halt was ordered
    bool is_coming_down_{false}; ///< it was stopped here, or lost its order while it ran
    bool was_taken_{false};      ///< the drive answered the last write
    bool waits_{false};          ///< a period, until the next request
};

} // namespace rtuwire::altivar
