// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// Keeps a drive running: one exchange a period, by function 23 over the scanner where the device supports it for
// these words, by functions 03 and 16 elsewhere. Before the first order it checks that the drive would stop by itself
// (altivar/procedure/inspection/supervision.hpp). A drive that must not run is stopped by function 06 and otherwise only
// read. After a loss the stop command is sent to it, as long as the client allows it, and it is read before anything else
// is written.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <utility>

#include <rtuwire/altivar/cyclic/cycle_agenda.hpp>
#include <rtuwire/altivar/cyclic/cycle_frames.hpp>
#include <rtuwire/altivar/cyclic/cycle_preparation.hpp>
#include <rtuwire/altivar/cyclic/cyclic_control.hpp>
#include <rtuwire/altivar/device/drive_type.hpp>
#include <rtuwire/altivar/device/reference.hpp>
#include <rtuwire/altivar/procedure/inspection/supervision_report.hpp>
#include <rtuwire/ask/commander.hpp>
#include <rtuwire/core/time.hpp>
#include <rtuwire/core/version.hpp>
#include <rtuwire/table/device.hpp>
#include <rtuwire/wire/function.hpp>

namespace rtuwire {
inline namespace RTUWIRE_BUILD {
namespace altivar {

/// The period of a cycle, and what the drive is checked against before the first order.
struct cyclic_options {
    /// The time between exchanges; at most a third of the drive's time-out is used, which is read from it, and where it has
    /// none a third of the longest that can be set.
    duration period{milliseconds(100)};
    /// The longest gap of the line, and the risks that are accepted: see `check_supervision`.
    supervision_options supervision{};
    /// The time limit from an order to "operation enabled".
    duration enable_timeout{milliseconds(3'000)};
    /// How many exchanges in a row may fail before the link counts as lost. None is repeated unchanged: the next one
    /// carries what is ordered then.
    std::uint8_t tolerated_misses{1};
    /// Whether function 23 is used where the device's words fit into it.
    bool by_function_23{true};
};

/// The requests to one drive, one by one. Knows no clock.
/// Internal.
template <drive_type Device> class cycle_steps {
    using words = cycle_layout<Device>;
    using step = cycle_step;

    static constexpr bool has_io_profile = may_have_io_profile(Device::layout) and Device::layout.safeguards.chcf != 0;

public:
    constexpr cycle_steps(unit_id its_unit, cyclic_options const& its_options) noexcept
        : agenda_{words::fits_function_23 and its_options.by_function_23 ? step::exchange : step::read},
          period_{its_options.period}, wanted_period_{its_options.period}, frames_{its_unit},
          tolerated_misses_{its_options.tolerated_misses}, preparation_{its_options.supervision}
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
        std::uint16_t const word = read[0];
        switch (agenda_.now()) {
        case step::look: return agenda_.take_look(word);
        case step::look_for_fault: return agenda_.take_fault_code(word, preparation_.succeeded());
        case step::prepare: preparation_.take(read, frames_.outputs_in_use()); return go_on_preparing(word);
        case step::check_control:
        case step::compare_control: return agenda_.compare(word, frames_.command());
        case step::compare_meaning:
            if (has_io_profile) {
                bool const is_ours = is_drive_profile(word);
                meaning_ = is_ours ? Device::layout.cmd : detail::other_meaning;
                return agenda_.compare(is_ours ? 1 : 0, 1);
            }
            return agenda_.compare(word, frames_.command());
        case step::compare_reference: return agenda_.compare(word, frames_.reference());
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
    duration period_;
    duration wanted_period_;
    cycle_frames<Device> frames_;
    std::uint16_t meaning_{0}; ///< what was read of CHCF, until it is taken
    std::uint8_t tolerated_misses_;
    cycle_preparation<Device> preparation_; ///< large, and so behind all else
};

/// A conversation without an end: give it to a client or a bus in each pass. Where the drive's time-out has passed since the
/// last request of it that was answered, as in a program that was not scheduled, the drive is lost, whatever its reaction to
/// a lost link is (SLL) and whatever risk was accepted: the order is gone, and the stop command goes first. Where the drive's
/// cycle uses its scanner, the slots of its words must be as delivered, or set so by `configure_scanner`, and no further
/// output slot may be active unless `set_output` was called for it. Before the first exchange, after each loss, and after
/// each conversation of this client that could have changed them, it reads the scanner's addresses and the drive's safeguards, some twelve requests; where they
/// are wrong it writes nothing but the stop command to a motor it ordered to run, and `control().reason()` gives the
/// cause. Without an order it stops a motor that it finds running, whoever runs it: `watch` only reads.
template <device_type Device> class cyclic : public detail::commander {
    static_assert(drive_check<Device>::passed);
    using words = cycle_layout<Device>;

public:
    static constexpr conversation_properties properties{
        .urgency = detail::urgency::stop_of_unit, .repetition = repetition::never, .freshness = freshness::when_free};

    static constexpr bool keeps_meaning = true;
    static constexpr function_set asks{function_code::read_holding_registers, function_code::write_single_register,
                                       Device::cycle.by};
    static constexpr frame_sizes longest_frames = cycle_frames<Device>::longest;

    /// A cycle of this drive, which orders nothing before `run` or `stop`.
    explicit constexpr cyclic(station<Device> const& its_drive, cyclic_options const& its_options = {}) noexcept
        : commander{its_drive.unit()}, enable_timeout_{its_options.enable_timeout},
          tolerated_misses_{its_options.tolerated_misses}, steps_{its_drive.unit(), its_options}
    {}

    /// Orders operation at a speed (a frequency where the drive's cycle writes one), negative in reverse; 0 in reverse, or
    /// while the motor turns in reverse, is 0.1 Hz in reverse, so that it does not turn forward at LSP. False, with
    /// nothing changed, until the drive was checked, before the first exchange and after a loss; in a fault, in local
    /// control, in a quick stop, while a stop has not ended, after another conversation's stop until the drive was
    /// read again, and for a negative reference together with `run_direction::reverse`. False, too, and the order in force
    /// goes on, for a reference above HSP, or below LSP where the motor stands, as the last check read them:
    /// `control().reason()` names the limit. One no faster than that of the order in force, the same way, is taken
    /// whatever the limits are; `beyond_limits::limit` in the options takes all, and the drive limits them.
    constexpr bool run(setting<words::reference> reference, run_direction direction = run_direction::forward) noexcept
    {
        reference_write const asked{0, reference.word(), words::is_by_speed};
        bool const is_reverse = direction == run_direction::reverse;
        if ((is_reverse and asked.is_reverse()) or this->was_stopped()) {
            return false;
        }
        bool const was_ordered = control().is_ordered();
        // The direction is in the word of the reference: no write of several words is assumed to take effect whole.
        std::uint16_t const status = control().is_running() ? control().status() : std::uint16_t{0};
        bool const is_taken = steps_.run(is_reverse ? asked.reversed() : asked.keeping(status));
        if (is_taken and not was_ordered) {
            is_new_order_ = true;
            look_.note_order(false);
            if (this->is_doubtful()) {
                steps_.check_anew(); // it may have lost its power since it was checked
            }
            this->note_order_to_run();
        }
        return is_taken;
    }

    /// Withdraws the order: the motor stops on its ramp, or by `how`; on the ramp, too, where the device has no halt.
    /// The stop command is sent at once, before the requests of all others and before any read; a halt is sent after
    /// a read, and becomes the ramp where three of its words in a row get no answer. `run` is accepted again once the motor is at rest. After a loss, and behind a missing response, the motor
    /// coasts, as for a `stop` of a drive that this client has not checked; a cycle slower than 0.5 s reads CHCF first.
    constexpr void stop(stop_by how = stop_by::ramp) noexcept
    {
        if (control().is_ordered()) {
            look_.note_order(true);
        }
        steps_.stop(how);
        this->note_stop();
        is_due_ = has_begun_;
    }

    /// Orders one fault reset. False, with nothing changed, where the drive is not known to be in fault, and while a
    /// reset is under way: so it may be called in each pass.
    constexpr bool reset_fault() noexcept
    {
        bool const is_taken = steps_.reset_fault();
        if (is_taken) {
            this->note_order();
        }
        return is_taken;
    }

    /// Sets an output word beside command and reference, where the drive's cycle has it. It is written in each cycle
    /// from then on, to whatever register the scanner's slot stands for.
    constexpr void set_output(std::size_t slot, std::uint16_t word) noexcept { steps_.frames().set_output(slot, word); }

    /// An input word of the last exchange; 0 before it.
    [[nodiscard]] constexpr std::uint16_t input(std::size_t slot) const noexcept { return steps_.frames().input(slot); }

    /// The motor's speed in rpm at the last exchange.
    [[nodiscard]] constexpr std::int16_t speed() const noexcept { return steps_.frames().speed(); }

    /// The result of the check before the first order: the register that prevents it, the time-out that was read.
    [[nodiscard]] constexpr supervision_report const& supervision() const noexcept { return steps_.report(); }

    /// State, order, and why the last order was dropped.
    [[nodiscard]] constexpr cyclic_control const& control() const noexcept { return steps_.control(); }

    /// Whether more exchanges in a row failed than are tolerated, none was made yet, or the check of the drive
    /// failed.
    [[nodiscard]] constexpr bool link_lost() const noexcept { return steps_.is_lost(); }

    using commander::unit;

    /// For the client: the effect of the next request on the motor, and how a loss is reported.
    [[nodiscard]] constexpr detail::effect intent() const noexcept
    {
        return is_due_ and not look_.is_under_way() ? this->effect_now(steps_.intent(this->was_rearranged()))
                                                    : detail::effect::none;
    }
    [[nodiscard]] constexpr duration drive_timeout() const noexcept { return steps_.drive_timeout(); }
    [[nodiscard]] constexpr std::uint8_t tolerated_misses() const noexcept { return tolerated_misses_; }

    constexpr void note_loss() noexcept
    {
        has_lost_ = true;
        heed_loss();
    }

    constexpr void advance(instant now) noexcept
    {
        instant const at = has_begun_ ? detail::within_reach(now_, now) : now;
        duration const passed = has_begun_ and reached(at, now_) ? at - now_ : duration{};
        since_heard_ = since_heard_ + passed;
        since_asked_ = since_asked_ + passed;
        now_ = now;
        heed_silence();
        detail::keep_over(enable_end_, now, at);
        if (is_new_order_) { // given since the visit before, which may be long ago
            is_new_order_ = false;
            enable_end_ = now + enable_timeout_;
        }
        steps_.give_way(this->is_ordered_by_another());
        if (control().is_ordered() and this->is_overruled() and not is_asking_) {
            steps_.yield();
        }
        // Whether a drive that does not answer would follow is not known: it answers again, or it is lost.
        bool const enables = control().is_ordered() and not control().is_running() and not steps_.is_missed();
        if (enables and reached(now, enable_end_)) {
            steps_.note_late();
        }
        if (not has_begun_) {
            has_begun_ = true;
            due_ = now;
        }
        is_due_ = is_due_ or reached(at, due_);
        heed_look(at);
    }

    constexpr std::optional<request_frame> next() noexcept
    {
        if (not is_due_) {
            return std::nullopt;
        }
        if (look_.is_under_way()) {
            is_asking_ = true;
            since_asked_ = {};
            return request_frame{steps_.frames().read_one(Device::layout.safeguards.chcf)};
        }
        if (since_heard_ > detail::longest_gap_in_presence and not has_doubted_) {
            has_doubted_ = true; // once a period: the line may be as slow
            steps_.doubt();
        }
        bool const was_rearranged = this->was_rearranged();
        this->note_arrangement();
        if (this->was_stopped()) {
            this->heed_stop();
            steps_.note_stopped();
        }
        is_asking_ = true;
        since_asked_ = {};
        byte_view const frame = steps_.ask(was_rearranged, look_.allows_word(this->confirmed() == Device::layout.cmd));
        this->note_command(control().has_enabled());
        return request_frame{frame};
    }

    constexpr void accept(result<response> const& outcome) noexcept
    {
        is_asking_ = false;
        if (outcome or is_exception(outcome.error())) {
            is_heard_ = true;
            since_heard_ = since_asked_;
        }
        if (steps_.says_stop() and not look_.is_under_way() and outcome.error() != errc::cancelled) {
            look_.note_word(); // else it never left
        }
        if (look_.is_under_way()) {
            end_look(meaning_in(outcome, Device::layout.cmd));
        } else if (outcome) {
            steps_.take(*outcome);
        } else {
            steps_.miss(outcome.error());
        }
        this->note_power(steps_.take_power());
        if (steps_.take_fault()) {
            this->note_fault();
        }
        this->note_meaning(steps_.take_meaning());
        if (steps_.take_end_of_stop()) {
            this->note_stop_over();
        }
        if (steps_.take_pause()) {
            is_due_ = false;
            has_doubted_ = false;
            due_ = now_ + steps_.period();
        }
        heed_silence();
        heed_loss();
    }

    [[nodiscard]] constexpr deadline poll_deadline() const noexcept
    {
        return not has_begun_       ? deadline{}
               : not is_due_        ? deadline{due_}
               : has_limited_look() ? deadline{look_end_}
                                    : deadline{};
    }

    /// For the client: how long the response may take.
    [[nodiscard]] constexpr duration limited(duration timeout) const noexcept
    {
        duration const rest = look_end_ - now_;
        return has_limited_look() ? detail::shorter_of(rest, timeout) : timeout;
    }

    /// Never: the cycle goes on as long as it is polled.
    [[nodiscard]] static constexpr bool settled() noexcept { return false; }

private:
    /// Whether it looks before the first word of a stop.
    constexpr bool has_limited_look() const noexcept { return look_.is_under_way() and not look_.has_said(); }

    /// A stop command that stops only a drive in its drive profile waits for one read of that, where it is due. Behind a
    /// missing response, and after a loss, 0000 goes at once.
    constexpr void heed_look(instant at) noexcept
    {
        constexpr drive_layout const& layout = Device::layout;
        if constexpr (may_have_io_profile(layout) and layout.safeguards.chcf != 0) {
            bool const is_due = not steps_.is_missed() and not steps_.is_lost() and
                                this->last_confirmed() == layout.cmd and look_.is_due(this->is_doubtful());
            bool const waits = is_due_ and steps_.intent(this->was_rearranged()) == detail::effect::stopping and
                               control().word_to_stop(true, layout) != 0;
            if (is_asking_) {
                return;
            }
            if (is_due and waits) {
                look_.begin();
                look_end_ = now_ + longest_look_of_a_stop;
            } else if (look_.is_under_way() and not waits) {
                look_.give_up();
            } else if (has_limited_look() and reached(at, look_end_)) {
                end_look(0);
            }
        }
    }
    constexpr void end_look(std::uint16_t meaning) noexcept
    {
        look_.end(meaning == Device::layout.cmd);
        this->note_meaning(meaning);
    }

    /// The drive has stopped its motor by itself, or runs on as nobody asked it to, where its time-out has passed since the
    /// last request that it answered. A program may have slept meanwhile: nothing else tells it.
    constexpr void heed_silence() noexcept
    {
        if (is_heard_ and not is_asking_ and since_heard_ > drive_timeout()) {
            note_loss();
        }
    }

    /// A request to the drive, by any conversation, had no response: it is stopped while the client allows it.
    constexpr void heed_loss() noexcept
    {
        if (has_lost_ and not is_asking_) {
            has_lost_ = false;
            is_heard_ = false;
            steps_.lose(errc::unit_lost);
            is_due_ = has_begun_;
        }
    }

    // Small processors reach what is near with short instructions.
    duration enable_timeout_;
    instant now_{0};
    instant due_{0};
    instant enable_end_{0};
    instant look_end_{0};
    duration since_heard_{}; ///< since the last request that was answered was made
    duration since_asked_{}; ///< since the last one was made
    std::uint8_t tolerated_misses_;
    bool has_begun_{false};
    bool is_due_{false};
    bool is_asking_{false};
    bool has_lost_{false};
    bool is_new_order_{false};
    stop_look look_{false};   ///< what the stop command means
    bool is_heard_{false};    ///< since the last loss
    bool has_doubted_{false}; ///< since the last pause
    cycle_steps<Device> steps_;
};

} // namespace altivar
} // namespace RTUWIRE_BUILD
} // namespace rtuwire
