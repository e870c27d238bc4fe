// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// Runs a procedure as a conversation with one unit: single reads and writes, pauses, and a time limit.
// Internal: may change with any version.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>

#include <rtuwire/altivar/procedure/procedure.hpp>
#include <rtuwire/ask/conversation.hpp>
#include <rtuwire/core/time.hpp>
#include <rtuwire/core/version.hpp>
#include <rtuwire/wire/function.hpp>
#include <rtuwire/wire/registers.hpp>

namespace rtuwire::inline RTUWIRE_BUILD::altivar {

/// The conversation of a procedure. It ends at its limit, counted from the first `advance`; or later by the procedure's
/// grace, or at the end of the one request that is then under way or still has to be sent to leave the drive safe. A stop
/// does not end before its control word has left.
template <typename Script> class procedure_runner : public commander {
    /// Whether it may send a control word that stops, other than 0000.
    static constexpr bool says_stop = Script::is_stop or Script::is_order or Script::gives_way_to_order;

public:
    /// Each action says whether its request may be repeated.
    static constexpr conversation_properties properties{.urgency = urgency::stop_of_unit,
                                                        .freshness = freshness::when_free};
    static constexpr function_set asks{function_code::read_holding_registers, function_code::write_single_register};

    static constexpr bool keeps_meaning = true;

    constexpr procedure_runner(unit_id its_unit, Script const& procedure, duration its_limit) noexcept
        : procedure_{procedure}, limit_{its_limit}, unit_{its_unit}
    {}

    /// Begins anew, as it was made: its limit counts from the next `advance`. One under way is given up first, as if it
    /// had been destroyed. An order to move the motor is given by this call, and a stop that begins before the next visit ends
    /// it; the client that it visited last must not have been destroyed, unless another one is in its place.
    constexpr void again() noexcept
    {
        commander const former{*this};
        *this = procedure_runner{unit_, procedure_.anew(), limit_};
        if constexpr (Script::follows_order) {
            this->begin_anew(former);
        } else {
            this->replace(former);
        }
    }

    /// Processes the time: starts the clock, ends pauses, and ends the conversation at its limit.
    constexpr void advance(instant now) noexcept
    {
        instant const at = has_begun_ ? within_reach(now_, now) : now;
        now_ = now;
        if constexpr (Script::is_stop) {
            procedure_.note_confirmed(known_word());
        }
        if (not has_begun_) {
            has_begun_ = true;
            late_at_ = now + limit_;
            if constexpr (Script::is_stop) {
                this->note_stop();
            } else if constexpr (Script::is_order) {
                this->note_order_to_run();
            } else {
                this->note_order();
            }
            begin();
        }
        keep_over(late_at_, now, at);
        if (settled() or is_asking_) {
            return;
        }
        if (is_looking()) {
            bool const is_over = (has_length() and reached(at, pause_end_)) or (has_limit() and reached(now, late_at_));
            return is_over ? end_look(0) : void();
        }
        if (Script::follows_order and this->is_overruled() and not procedure_.takes_back()) {
            return take(procedure_.yield());
        }
        if (Script::gives_way_to_order and effect_of(action_) == effect::stopping and this->is_unit_ordered()) {
            return take(procedure_.yield());
        }
        if (has_to_look()) {
            return begin_look();
        }
        if (has_limit() and reached(now, late_at_)) {
            is_late_ = was_warned_ or Script::grace.microseconds == 0;
            was_warned_ = true;
            late_at_ = now + Script::grace;
            if (is_late_ or not procedure_.takes_back()) { // else it uses its grace for that
                take(procedure_.step({event::kind::late}));
            }
        } else if (has_length() and reached(at, pause_end_)) {
            bool const is_pause = what_of(action_) == action_kind::pause;
            take(procedure_.step(is_pause ? event{event::kind::pause_over}
                                          : event{event::kind::failed, 0, errc::bus_jam}));
        }
    }

    [[nodiscard]] constexpr unit_id unit() const noexcept { return unit_; }

    /// For the client: what the next request does to the motor, and when a unit counts as lost.
    [[nodiscard]] constexpr effect intent() const noexcept
    {
        return is_looking() ? effect::none : this->effect_now(effect_of(action_));
    }
    [[nodiscard]] constexpr duration drive_timeout() const noexcept { return procedure_.drive_timeout(); }
    [[nodiscard]] static constexpr std::uint8_t tolerated_misses() noexcept { return 1; }

    constexpr void note_loss() noexcept
    {
        has_lost_ = has_begun_ and not settled();
        heed_loss();
    }

    constexpr std::optional<request_frame> next() noexcept
    {
        if (not is_looking() and has_to_look()) {
            begin_look(); // it was heard of only now that what was read counts no more
            return std::nullopt;
        }
        if constexpr (Script::is_stop) {
            if (this->was_stopped()) {
                this->heed_stop();
                if (procedure_.keeps_power()) {
                    take(procedure_.step({event::kind::failed, 0, errc::overruled}));
                }
            }
        }
        if (not has_request()) {
            return std::nullopt;
        }
        is_asking_ = true;
        this->note_command(is_command_to_run());
        if (is_looking()) {
            return request_frame{frame_, repetition::never};
        }
        if (effect_of(action_) == effect::stopping) {
            if (procedure_.is_harmful(word_of(action_), look_.allows_word(counts(known_word())))) {
                action_ = to_stop(address_of(action_), 0);
                make_frame();
            }
            if (word_of(action_) != 0) {
                action_ = once(action_); // behind a missing response it may have another meaning
            }
        }
        return request_frame{frame_, repetition_of(action_)};
    }

    /// For the client: how long the response may take. A look of a stop ends when its time is over.
    [[nodiscard]] constexpr duration limited(duration timeout) const noexcept requires(says_stop)
    {
        duration const rest = pause_end_ - now_;
        return is_looking() and has_length() and rest < timeout ? rest : timeout;
    }

    /// From here on what was read of its words counts for the first one until the unit is lost, however long ago that was: of a
    /// stop that continues what broadcasts have begun.
    constexpr void count_old_readings(bool counts) noexcept requires(Script::is_stop) { counts_old_ = counts; }

    /// Where a drive of the declared type has its control word, and where one of the other family has it.
    [[nodiscard]] constexpr drive_layout const& layout() const noexcept requires(Script::is_stop)
    {
        return procedure_.layout();
    }

    /// Whether only 0000 is known to stop the drive, as far as this client has read.
    [[nodiscard]] constexpr bool may_run_on_a_stop() noexcept requires(Script::is_stop)
    {
        procedure_.note_confirmed(known_word());
        return procedure_.may_run_on_a_stop();
    }

    /// For the client: whether a stop has just found that the unit is of another family.
    constexpr bool take_other_family() noexcept requires(Script::is_stop)
    {
        bool const is_new = is_other_family_;
        is_other_family_ = false;
        return is_new;
    }

    /// Whether there is a request to send.
    [[nodiscard]] constexpr bool has_request() const noexcept
    {
        return has_begun_ and
               (is_looking() or what_of(action_) == action_kind::read or what_of(action_) == action_kind::write);
    }

    constexpr void accept(result<response> const& outcome) noexcept
    {
        is_asking_ = false;
        if (settled()) {
            return;
        }
        if (is_looking()) {
            end_look(meaning_in(outcome, procedure_.control_word()));
            return heed_loss();
        }
        if (effect_of(action_) == effect::stopping and outcome.error() != errc::cancelled) {
            look_.note_word(); // else it never left
        }
        take(outcome.error() == errc::overruled ? procedure_.yield() : procedure_.step(event_of(outcome)));
        if (Script::follows_order and settled() and is_done()) {
            heed_end_of_order();
        }
        heed_loss();
    }

    /// When `advance` has something to do; nothing while a request is under way.
    [[nodiscard]] constexpr deadline poll_deadline() const noexcept
    {
        if (settled() or is_asking_ or not has_begun_) {
            return {};
        }
        earliest next;
        if (not is_late_ and not(has_to_say() and reached(now_, late_at_))) { // else it waits for more than that
            next.add(late_at_);
        }
        if (has_length()) {
            next.add(pause_end_);
        }
        return next;
    }

    /// Whether the procedure has ended.
    [[nodiscard]] constexpr bool settled() const noexcept
    {
        return has_begun_ and what_of(action_) == action_kind::end;
    }

    /// How it ended; `pending` until it is settled. To be read in the pass in which it settles: from the next visit on it
    /// is `used_already`.
    [[nodiscard]] constexpr altivar::reason reason() const noexcept
    {
        return this->is_used_already() ? altivar::reason{outcome_kind::used_already}
               : settled()             ? procedure_.reason()
                                       : altivar::reason{};
    }

    /// Whether it ended with success.
    [[nodiscard]] constexpr bool succeeded() const noexcept { return reason().kind == outcome_kind::succeeded; }

protected:
    /// Of an order to run: whether it was carried out, and still counts.
    [[nodiscard]] constexpr bool has_done_its_order() const noexcept
    {
        return is_done() and this->is_order_in_force(unit_);
    }

    [[nodiscard]] constexpr Script const& told() const noexcept { return procedure_; }

private:
    constexpr bool is_done() const noexcept
    {
        outcome_kind const how = procedure_.reason().kind;
        return how == outcome_kind::succeeded or how == outcome_kind::reference_limited;
    }
    constexpr bool is_command_to_run() const noexcept
    {
        constexpr std::uint16_t run = cia402::word_of(cia402::command::enable_operation);
        return effect_of(action_) == effect::enabling and address_of(action_) == procedure_.control_word() and
               (word_of(action_) & run) == run;
    }
    constexpr bool is_looking() const noexcept { return says_stop and look_.is_under_way(); }

    /// Whether the control word to send stops only a drive in its drive profile, and that has to be read.
    [[gnu::noinline]] constexpr bool has_to_look() const noexcept
    {
        return says_stop and effect_of(action_) == effect::stopping and word_of(action_) != 0 and
               look_.is_due(counts(known_word()), was_confirmed_at()) and procedure_.may_have_io() and
               procedure_.chcf() != 0;
    }
    constexpr bool was_confirmed_at() const noexcept { return not counts_old() and counts(this->was_confirmed()); }
    constexpr bool counts_old() const noexcept { return Script::is_stop and counts_old_; }
    constexpr std::uint16_t known_word() const noexcept
    {
        return counts_old() and this->confirmed() == 0 ? this->was_confirmed() : this->confirmed();
    }
    constexpr bool counts(std::uint16_t confirmed) const noexcept { return confirmed == procedure_.control_word(); }

    constexpr void begin() noexcept
    {
        if constexpr (Script::is_stop) {
            if (procedure_.looks_first(was_confirmed_at())) {
                return begin_look();
            }
        }
        take(procedure_.step({event::kind::begun}));
    }

    constexpr void begin_look() noexcept
    {
        look_.begin();
        pause_end_ = now_ + longest_look_of_a_stop;
        make_frame(false, procedure_.chcf(), 1);
    }

    /// Begins, or sends the control word: the one meant where it is known to be that, else 0000.
    constexpr void end_look(std::uint16_t meaning) noexcept
    {
        look_.end(counts(meaning));
        this->note_meaning(meaning);
        if (effect_of(action_) == effect::stopping) {
            return make_frame();
        }
        if constexpr (Script::is_stop) {
            procedure_.note_confirmed(known_word());
        }
        take(procedure_.step({event::kind::begun}));
    }

    /// It was done, by what was read before its order came to an end: that has failed. A start withdraws its commands, for a
    /// drive that does not supervise its link runs on.
    constexpr void heed_end_of_order() noexcept
    {
        if (errc const why = this->end_of_order(unit_); why != errc::none) {
            procedure_.forget_end();
            take(why == errc::overruled ? procedure_.yield() : procedure_.step({event::kind::failed, 0, why}));
        }
    }

    /// The unit was lost: the next action, unless it is a word that stops, would wait until the drive has stopped by
    /// itself. So it fails now.
    constexpr void heed_loss() noexcept
    {
        if (not has_lost_ or is_asking_) {
            return;
        }
        has_lost_ = false;
        if (is_looking()) {
            return end_look(0);
        }
        if (not settled() and effect_of(action_) != effect::stopping) {
            take(procedure_.step({event::kind::failed, 0, errc::unit_lost}));
        }
    }

    /// Whether a stop's control word was never sent.
    constexpr bool has_to_say() const noexcept { return Script::is_stop and not look_.has_said(); }

    /// Whether the time limit is ahead, or over and not taken notice of. It ends no stop that has to say its word: only what such
    /// a one reads before.
    constexpr bool has_limit() const noexcept
    {
        bool const reads = is_looking() or what_of(action_) == action_kind::read;
        return not is_late_ and (reads or not has_to_say());
    }

    /// Whether the action is a pause, or a request that may wait only for a limited time. Before its first word a stop looks
    /// for a limited time, later as long as its turn and the response take.
    constexpr bool has_length() const noexcept
    {
        return is_looking() ? not look_.has_said()
                            : what_of(action_) == action_kind::pause or length_of(action_).microseconds != 0;
    }

    constexpr event event_of(result<response> const& outcome) const noexcept
    {
        if (not outcome) {
            return {event::kind::failed, 0, outcome.error()};
        }
        if (what_of(action_) == action_kind::write) {
            return {event::kind::written};
        }
        byte_view const pdu = outcome->pdu();
        constexpr std::size_t first = 2, second = 4;
        bool const are_two = count_of(action_) == 2;
        if (pdu.size() != (are_two ? second : first) + 2) {
            return {event::kind::failed, 0, errc::wrong_length};
        }
        return {event::kind::word_read, u16_at(pdu, first), errc::none,
                are_two ? u16_at(pdu, second) : std::uint16_t{0}};
    }

    constexpr void take(action next) noexcept
    {
        // After the limit one request is allowed, and no pause.
        bool const is_request = what_of(next) == action_kind::read or what_of(next) == action_kind::write;
        if (is_late_ and not has_to_say() and (what_of(next) == action_kind::pause or (is_request and was_granted_))) {
            next = procedure_.give_up();
        }
        was_granted_ = was_granted_ or (is_late_ and is_request);
        this->note_power(procedure_.take_power());
        if (procedure_.take_fault()) {
            this->note_fault();
        }
        this->note_meaning(procedure_.take_meaning());
        if (Script::is_stop and what_of(next) == action_kind::end) {
            this->note_stop_over();
            is_other_family_ = procedure_.reason().kind == outcome_kind::other_family;
        }
        action_ = next;
        pause_end_ = now_ + length_of(next);
        if (is_request) {
            make_frame();
        }
        if (has_to_look()) {
            begin_look();
        }
    }

    constexpr void make_frame() noexcept
    {
        bool const is_write = what_of(action_) == action_kind::write;
        make_frame(is_write, address_of(action_), is_write ? word_of(action_) : count_of(action_));
    }

    /// A read of holding registers, or the write of one: both are a function, an address, and a count or a word.
    [[gnu::noinline]] constexpr void make_frame(bool is_write, std::uint16_t address, std::uint16_t value) noexcept
    {
        constexpr std::byte read = to_byte(static_cast<std::uint8_t>(function_code::read_holding_registers));
        constexpr std::byte write = to_byte(static_cast<std::uint8_t>(function_code::write_single_register));
        frame_[0] = to_byte(unit_.byte());
        frame_[1] = is_write ? write : read;
        put_u16(&frame_[2], address);
        put_u16(&frame_[4], value);
        append_crc(frame_, frame_.size() - adu_overhead);
    }

    Script procedure_;
    action action_{to_pause({})};
    duration limit_;
    instant now_{0};
    instant late_at_{0};
    instant pause_end_{0};
    std::array<std::byte, 8> frame_{};
    unit_id unit_;
    bool has_begun_{false};
    bool is_asking_{false};
    bool has_lost_{false};
    bool is_late_{false};
    bool was_warned_{false}; ///< the limit is over; only the procedure's grace is left
    bool was_granted_{false};
    bool is_other_family_{false};
    bool counts_old_{false};
    stop_look look_{Script::is_stop};
};

} // namespace rtuwire::altivar
