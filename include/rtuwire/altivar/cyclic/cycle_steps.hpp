// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// The requests of one drive's cycle, and what their responses change; no clock. A drive that must not run is stopped
// by function 06 and otherwise only read. After a loss the stop command is sent to it, as long as the client allows
// it, and it is read before anything else is written.
// Internal: may change with any version.
#pragma once

#include <cstddef>
#include <cstdint>
#include <utility>

#include <rtuwire/altivar/cyclic/cycle_agenda.hpp>
#include <rtuwire/altivar/cyclic/cycle_frames.hpp>
#include <rtuwire/altivar/cyclic/cycle_layout.hpp>
#include <rtuwire/altivar/cyclic/cycle_preparation.hpp>
#include <rtuwire/altivar/cyclic/cycle_step.hpp>
#include <rtuwire/altivar/cyclic/cyclic_control.hpp>
#include <rtuwire/altivar/cyclic/cyclic_options.hpp>
#include <rtuwire/ask/commander.hpp>
#include <rtuwire/core/time.hpp>
#include <rtuwire/core/version.hpp>

namespace rtuwire {
inline namespace RTUWIRE_BUILD {
namespace altivar {

/// The requests to one drive, one by one.
template <drive_type Device> class cycle_steps {
    using words = cycle_layout<Device>;
    using step = cycle_step;

    static constexpr bool has_io_profile = may_have_io_profile(Device::layout) and Device::layout.safeguards.chcf != 0;

public:
    constexpr cycle_steps(unit_id its_unit, cyclic_options const& its_options) noexcept
        : agenda_{words::fits_function_23 and its_options.by_function_23 ? step::exchange : step::read},
          preparation_{its_options.supervision}, period_{its_options.period},
          wanted_period_{its_options.period}, frames_{its_unit}, tolerated_misses_{its_options.tolerated_misses}
    {}

    /// The user's orders. An order to run is accepted only for a drive that was checked, within the limits read then.
    constexpr bool run(reference_write reference) noexcept
    {
        bool const is_able = preparation_.succeeded() and control().is_able();
        return is_able and agenda_.control().allows(reference, report().limits) and
               agenda_.run(reference.at_least(report().limits.least_speed()).word);
    }
    constexpr void stop(stop_by how) noexcept
    {
        bool const has_none = how == stop_by::halt and Device::layout.halt == 0;
        agenda_.stop(has_none ? stop_by::ramp : how);
    }
    constexpr bool reset_fault() noexcept { return agenda_.control().reset_fault(); }

    /// All that an order relies on is read anew before the next write.
    constexpr void check_anew() noexcept { preparation_.renew(); }

    /// The drive was not heard for long: it is read before the next write of an order.
    constexpr void doubt() noexcept { agenda_.doubt(); }

    /// Another conversation stopped the drive, or read it in fault: it has to be read anew.
    constexpr void note_stopped() noexcept { agenda_.control().note_stopped(); }

    /// A stop by another conversation is in force.
    constexpr void yield() noexcept { agenda_.yield(); }

    /// Whether another conversation's order to run counts.
    constexpr void give_way(bool gives_way) noexcept { agenda_.control().give_way(gives_way); }

    /// Enabling took too long.
    constexpr void note_late() noexcept { agenda_.control().note_late(); }
    [[nodiscard]] constexpr cycle_frames<Device>& frames() noexcept { return frames_; }
    [[nodiscard]] constexpr cycle_frames<Device> const& frames() const noexcept { return frames_; }
    [[nodiscard]] constexpr cyclic_control const& control() const noexcept { return agenda_.control(); }
    [[nodiscard]] constexpr supervision_report const& report() const noexcept { return preparation_.report(); }
    [[nodiscard]] constexpr bool is_lost() const noexcept { return agenda_.is_lost(); }

    /// Whether the request that was made last is the stop command.
    [[nodiscard]] constexpr bool says_stop() const noexcept { return agenda_.now() == step::say_stop; }

    /// Whether the last request had no response.
    [[nodiscard]] constexpr bool is_missed() const noexcept { return agenda_.is_missed(); }

    /// How long the drive runs on without a request, as it was read; else the longest that can be set.
    [[nodiscard]] constexpr duration drive_timeout() const noexcept
    {
        duration const read = report().period.timeout;
        return read != duration{} ? read : Device::layout.longest_silence;
    }

    /// The time from one exchange to the next.
    [[nodiscard]] constexpr duration period() const noexcept { return period_; }

    /// What the next request does to the motor; `was_rearranged`: another conversation may have changed the drive.
    [[nodiscard]] constexpr detail::effect intent(bool was_rearranged) const noexcept
    {
        step const next = due_step(was_rearranged);
        if (next == step::say_stop) {
            return detail::effect::stopping;
        }
        if (next != step::exchange and next != step::write) {
            return detail::effect::none;
        }
        return control().is_resetting() ? detail::effect::resetting
               : control().is_ordered() ? detail::effect::enabling
                                        : detail::effect::none;
    }

    /// The next request. `is_confirmed`: the drive is known to take the words of all stops as such.
    constexpr byte_view ask(bool was_rearranged, bool is_confirmed) noexcept
    {
        agenda_.begin(due_step(was_rearranged));
        if (was_rearranged) {
            preparation_.renew();
        }
        return make_frame(is_confirmed);
    }

    /// What a read found of the motor's power, whether it found the drive newly in fault, what it found in CHCF (as for
    /// `commander::note_meaning`), whether a stop that was ordered here has ended, and whether the next request waits for a
    /// period; each reported once.
    constexpr detail::power_seen take_power() noexcept { return agenda_.take_power(); }
    constexpr bool take_fault() noexcept { return agenda_.control().take_fault(); }
    constexpr std::uint16_t take_meaning() noexcept { return std::exchange(meaning_, std::uint16_t{0}); }
    constexpr bool take_end_of_stop() noexcept { return agenda_.control().take_end_of_stop(); }
    constexpr bool take_pause() noexcept { return agenda_.take_pause(); }

    /// Takes the response to the request. A drive that has left its order behind may have lost its power, and its settings and
    /// its scanner's words with it.
    constexpr void take(response const& response) noexcept
    {
        bool const was_ordered = control().is_ordered();
        agenda_.note_response();
        take_response(response);
        if (was_ordered and not control().is_ordered()) {
            agenda_.note_end_of_order();
            preparation_.renew();
        }
    }

    constexpr void miss(errc error) noexcept
    {
        if (agenda_.now() == step::prepare and is_exception(error)) {
            preparation_.take_exception(error);
            return go_on_preparing(0);
        }
        bool const was_preparing = agenda_.now() == step::prepare; // and has to begin anew
        if (agenda_.miss(error, tolerated_misses_) or was_preparing) {
            preparation_.renew();
        }
    }

    /// The link is lost, or its data cannot be trusted.
    constexpr void lose(errc error) noexcept
    {
        agenda_.lose(error);
        preparation_.renew();
    }

private:
    constexpr void take_response(response const& response) noexcept
    {
        if (agenda_.now() == step::write) {
            return agenda_.end_exchange();
        }
        if (agenda_.now() == step::say_stop) {
            return agenda_.end_stop_word(preparation_.succeeded());
        }
        constexpr std::size_t words_from = 2;
        register_view const read{response.pdu().subspan(words_from)};
        switch (agenda_.now()) {
        case step::look: return agenda_.take_look(read[0]);
        case step::look_for_fault: return agenda_.take_fault_code(read[0], preparation_.succeeded());
        case step::prepare: preparation_.take(read, frames_.outputs_in_use()); return go_on_preparing(read[0]);
        case step::check_control:
        case step::compare_control: return agenda_.compare(read[0], frames_.command());
        case step::compare_meaning:
            if (has_io_profile) {
                bool const is_ours = is_drive_profile(read[0]);
                meaning_ = is_ours ? Device::layout.cmd : detail::other_meaning;
                return agenda_.compare(is_ours ? 1 : 0, 1);
            }
            return agenda_.compare(read[0], frames_.command());
        case step::compare_reference: return agenda_.compare(read[0], frames_.reference());
        case step::exchange:
        case step::read:
        case step::observe:
        case step::write:
        case step::say_stop: break;
        }
        take_inputs(read);
    }

    constexpr step due_step(bool was_rearranged) const noexcept
    {
        return agenda_.due(preparation_.succeeded(), was_rearranged, frames_.command());
    }

    constexpr byte_view make_frame(bool is_confirmed) noexcept
    {
        constexpr drive_layout const& layout = Device::layout;
        switch (agenda_.now()) {
        case step::look: return frames_.read_one(layout.eta);
        case step::look_for_fault: return frames_.read_one(layout.lft);
        case step::prepare: return frames_.read(preparation_.request());
        case step::read:
        case step::observe: return frames_.read_inputs();
        case step::say_stop: agenda_.note_write(); return frames_.say(control().word_to_stop(is_confirmed, layout));
        case step::check_control:
        case step::compare_control: return frames_.read_one(layout.cmd);
        case step::compare_meaning: return frames_.read_one(has_io_profile ? layout.safeguards.chcf : layout.cmd);
        case step::compare_reference: return frames_.read_one(words::reference.address);
        case step::write:
        case step::exchange: break;
        }
        agenda_.note_write();
        std::uint16_t const command = agenda_.control().next_command();
        return agenda_.now() == step::write ? frames_.write(command, control().reference())
                                            : frames_.exchange(command, control().reference());
    }

    /// `last_read` is the status where the check has succeeded.
    constexpr void go_on_preparing(std::uint16_t last_read) noexcept
    {
        outcome_kind const found = preparation_.finding();
        if (found == outcome_kind::pending) {
            return;
        }
        meaning_ = preparation_.take_meaning();
        if (found == outcome_kind::succeeded) {
            duration const longest = period_rule{drive_timeout()}.longest_period();
            period_ = longest < wanted_period_ ? longest : wanted_period_;
            return agenda_.end_preparation(last_read);
        }
        agenda_.fail_preparation(found);
        preparation_.renew();
    }

    constexpr void take_inputs(register_view read) noexcept
    {
        std::int16_t const before = frames_.speed();
        frames_.take(read);
        std::uint16_t const status = frames_.status();
        if (words::has_scanner and cia402::decode(status) == cia402::state::unknown) {
            lose(errc::malformed); // the first word is no status word: the scanner holds other registers
            return agenda_.wait_a_period();
        }
        if (words::has_scanner and status == 0) {
            preparation_.renew();
            return agenda_.look_again();
        }
        agenda_.take_status(status, frames_.speed() == 0);
        if (before != 0 and frames_.speed() == 0) {
            agenda_.note_standstill();
        }
    }

    cycle_agenda agenda_;
    cycle_preparation<Device> preparation_;
    duration period_;
    duration wanted_period_;
    cycle_frames<Device> frames_;
    std::uint16_t meaning_{0}; ///< what was read of CHCF, until it is taken
    std::uint8_t tolerated_misses_;
};

} // namespace altivar
} // namespace RTUWIRE_BUILD
} // namespace rtuwire
