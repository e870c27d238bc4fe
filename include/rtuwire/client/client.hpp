// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// The client's end of a line (SL 2.4.1): one request at a time. Owns neither the wire nor a clock; knows
// of functions only what wire/answer.hpp says. client/transaction.hpp does what one request needs,
// client/turns.hpp says whose it is and who is next, client/orders.hpp which motors run by order.
#pragma once

#include <cstddef>

#include <rtuwire/client/commander.hpp>
#include <rtuwire/client/orders.hpp>
#include <rtuwire/client/transaction.hpp>
#include <rtuwire/core/version.hpp>

namespace rtuwire::inline RTUWIRE_BUILD {

/// Asks one question at a time, for any number of conversations. In each pass call `receive` with what
/// arrived, `sent` when the last stop bit has left, `advance`; then `converse` for each conversation, in the
/// same order; then send what `poll_transmit` gives. Sleep no longer than `poll_deadline` says.
///
/// Lifetimes: a conversation may be destroyed, moved or begun anew between any two calls. A request, and each
/// repetition of it, leaves only in a pass in which its conversation came by; the octets that leave are the
/// client's own and stay as they are until `sent` is called or the client gave up waiting for it; an outcome
/// reaches the conversation that asked, or is dropped.
///
/// `Debts` holds the units that owe an answer; `Front` is `shared_memory` or `separate_memory`; `Orders` is
/// `no_orders`, or `orders<Units>` for conversations that command motors: see client/orders.hpp.
template <typename Statistics, typename Line = held<line_timing>,
          typename Options = held<client_options>, typename Debts = quarantine<1>,
          std::size_t Front = shared_memory, typename Orders = no_orders>
class basic_client : public transaction<Statistics, Line, Options, Debts, Front> {
    using base = transaction<Statistics, Line, Options, Debts, Front>;
    using client_state::is_held_back_;
    using client_state::turns_;

public:
    using base::base;
    using base::cancel;

    /// Lets time pass.
    constexpr void advance(instant now) noexcept
    {
        bool const is_silence_over = orders_.advance(now);
        if ((base::advance(now) or is_silence_over) and is_held_back_) {
            is_held_back_ = false;
            turns_.void_marks();
            turns_.note_waiting();
        }
    }

    /// When the next pass has something to do.
    [[nodiscard]] constexpr deadline poll_deadline() const noexcept
    {
        earliest next;
        add_to(next);
        return next;
    }

    /// The same, for whoever collects several.
    constexpr void add_to(earliest& next) const noexcept
    {
        base::add_to(next);
        orders_.add_to(next);
    }

    /// Whether a unit is asked nothing new now: it owes an answer, `hold` says so, or it was lost while it was ordered
    /// to run, and its own time-out has to stop it.
    [[nodiscard]] constexpr bool is_held(std::uint8_t unit) const noexcept
    {
        return base::is_held(unit) or orders_.is_silent(unit, effect::none);
    }
    [[nodiscard]] constexpr bool is_held(unit_id unit) const noexcept { return is_held(unit.octet()); }

    /// Which units run by order.
    [[nodiscard]] constexpr Orders& motor_orders() noexcept { return orders_; }
    [[nodiscard]] constexpr Orders const& motor_orders() const noexcept { return orders_; }

    /// Lets a unit be commanded again that a stop holds which was given up before its end; all units, where a stop of
    /// everyone was.
    constexpr void release(unit_id unit) noexcept requires(Orders::is_kept) { orders_.release(unit.octet()); }
    constexpr void release_all() noexcept requires(Orders::is_kept) { orders_.release_all(); }

    /// Gives up what is under way, only where it is this conversation's.
    constexpr void cancel(asker const& whose, instant now) noexcept
    {
        if (is_asked_by(whose)) {
            cancel(now);
        }
    }

    /// Whether it was this conversation that asked last.
    [[nodiscard]] constexpr bool is_asked_by(asker const& who) const noexcept { return turns_.is_own(who); }

    /// Lets a conversation come by: hands it its outcome, and asks its next question when it is its turn. After
    /// an outcome the next turn is that of the others that came by meanwhile. A question to a unit that owes an
    /// answer stays with its conversation; a question that cannot be asked at all is refused at once.
    template <conversation Talk> constexpr void converse(Talk& talk, instant now) noexcept
    {
        client_options const& all = base::options();
        // The time is made anew: GCC would read a constant's copy from memory.
        converse(talk, now,
                 {.response_timeout = duration{all.response_timeout.microseconds},
                  .retries = all.retries});
    }

    /// The same, with patience for this conversation's unit.
    template <conversation Talk>
    constexpr void converse(Talk& talk, instant now, patience const& with) noexcept
    {
        static_cast<void>(deliver(talk, not talk.settled(), now));
        advance_talk(talk, now);
        command(talk, now);
        static_cast<void>(ask(talk, now, with));
        if constexpr (Orders::is_kept and timed_conversation<Talk>) {
            orders_.wake_for(talk.poll_deadline(), now);
        }
    }

    /// The second part of `converse`, behind its `advance`: takes note of what a commander's user wants. A stop makes
    /// its way.
    template <conversation Talk> constexpr void command(Talk& talk, instant now) noexcept
    {
        if constexpr (commanding_conversation<Talk> or stops_everyone<Talk>) {
            static_assert(Orders::is_kept, "this client does not keep whose motor it ordered to run: take "
                                           "drive_client<Units>, or a bus");
            if constexpr (stops_everyone<Talk>) {
                orders_.visit_for_all(talk, now);
                for (auto& each : talk.stops()) {
                    if (orders_.visit(each, each.unit().octet(), now)) {
                        each.note_loss();
                    }
                }
            } else if (orders_.visit(talk, talk.unit().octet(), now)) {
                talk.note_loss();
            }
            if (talk.intent() == effect::stopping and not is_asked_by(talk)) {
                make_way_for(talk, now);
            }
        }
    }

    /// The first part of `converse`: the error of the outcome that the conversation was handed (`none` for an
    /// answer), or `pending`. `wants_turn` tells whether it has something to ask.
    template <conversation Talk>
    constexpr errc deliver(Talk& talk, bool wants_turn, instant now) noexcept
    {
        errc told = errc::pending;
        if (turns_.was_dropped(talk, base::phase_now() == client_phase::idle)) {
            told = reason_of_drop(talk);
            talk.accept(told);
            wants_turn = wants_turn and not talk.settled();
        }
        if (not comes_by(talk, wants_turn, now)) { // what lies there may be another's
            return told;
        }
        turns_.renew(talk);
        talk.forget();
        result<response> const outcome = take_outcome(now);
        talk.accept(outcome);
        return outcome.error();
    }

    /// The last part of `converse`: `none` where a question was taken, `busy` where it is not the turn of this
    /// conversation, `pending` where it has nothing to ask now or its unit is held; else why the question was
    /// refused, which the conversation was told.
    template <conversation Talk>
    constexpr errc ask(Talk& talk, instant now, patience const& with) noexcept
    {
        if (talk.settled() and not turns_.is_last(talk)) {
            return errc::pending;
        }
        effect const what = effect_of(talk);
        if (what == effect::stopping ? not may_stop() : not may_ask(talk, prompt_conversation<Talk>, now)) {
            return errc::busy;
        }
        if constexpr (prompt_conversation<Talk>) {
            if (errc const wrong = check_order(talk, what); wrong != errc::none) {
                return refuse(talk, wrong, now);
            }
            if (is_barred(talk.unit().octet(), what)) {
                return hold_back(talk);
            }
        }
        auto const question = talk.next();
        if (not question) {
            return errc::pending;
        }
        std::uint8_t const unit = question->frame().empty() ? std::uint8_t{0} : to_u8(question->frame()[0]);
        if (is_barred(unit, what)) {
            return hold_back(talk);
        }
        errc const wrong = start(*question, now, unit, with);
        if (wrong != errc::none) {
            return refuse(talk, wrong, now);
        }
        turns_.renew(talk);
        note_asked(talk, what);
        return errc::none;
    }

private:
    /// A conversation comes by. Whether the outcome is there and its own. Where the next in turn finds the asker
    /// missing twice, or the asker itself has given its request up, it is dropped.
    constexpr bool comes_by(asker& who, bool wants_turn, instant now) noexcept
    {
        client_phase const at = base::phase_now();
        bool const is_own = is_asked_by(who);
        if (at == client_phase::idle or not(is_own or wants_turn)) {
            return false;
        }
        standing place = standing::is_last;
        if (not is_own) {
            place = turns_.visit(who);
        } else if (at == client_phase::settled) {
            return true;
        } else if (at == client_phase::waiting) {
            turns_.renew(who);
        }
        if (base::awaits_asker()) {
            if (is_own) {
                base::get_ready(now);
            } else {
                replace_asker(place, now);
            }
        }
        return false;
    }

    /// Why a request was given up: a stop of its unit came before it, or somebody cancelled it.
    template <typename Talk> constexpr errc reason_of_drop(Talk const& talk) const noexcept
    {
        if constexpr (commanding_conversation<Talk>) {
            return orders_.is_overruled(talk, talk.unit().octet()) ? errc::overruled : errc::cancelled;
        }
        return errc::cancelled;
    }

    /// What the next question of a conversation does to a motor.
    template <typename Talk> static constexpr effect effect_of(Talk const& talk) noexcept
    {
        if constexpr (commanding_conversation<Talk> or stops_everyone<Talk>) {
            return talk.intent();
        }
        return effect::none;
    }

    /// Whether a unit is asked nothing of this effect now. Words that stop it do not wait for answers that it owes:
    /// none of them is the echo of such a word.
    constexpr bool is_barred(std::uint8_t unit, effect what) const noexcept
    {
        return orders_.is_silent(unit, what) or (what != effect::stopping and base::is_held(unit));
    }

    template <typename Talk> constexpr errc check_order(Talk const& talk, effect what) const noexcept
    {
        if constexpr (commanding_conversation<Talk>) {
            return orders_.check(talk, talk.unit().octet(), what);
        }
        return errc::none;
    }

    template <typename Talk> constexpr void note_asked(Talk& talk, effect what) noexcept
    {
        if constexpr (commanding_conversation<Talk>) {
            orders_.note_asked(talk.unit().octet(), what, talk.drive_timeout(), talk.tolerated_misses());
        } else if constexpr (stops_everyone<Talk>) {
            for (auto& each : talk.stops()) {
                if (each.unit().octet() == base::asked_unit()) {
                    note_asked(each, what);
                }
            }
        }
    }

    /// Starts a question to a unit. One that is lost hears each word that stops it once.
    constexpr errc start(request const& asked, instant now, std::uint8_t unit,
                         patience const& with) noexcept
    {
        if constexpr (Orders::is_kept) {
            patience own = with;
            own.retries = orders_.is_lost(unit) ? std::uint8_t{0} : with.retries;
            return base::start(asked, now, own);
        } else {
            return base::start(asked, now, with);
        }
    }

    /// A question cannot be asked.
    template <typename Talk> constexpr errc refuse(Talk& talk, errc wrong, instant now) noexcept
    {
        talk.accept(wrong);
        base::wake(now); // it may have another question, and nothing else would tell
        return wrong;
    }

    /// What came of the request. Whatever becomes of its asker, an answer that did not come is noted: a unit that was
    /// asked and not waited for has heard its master as well.
    constexpr result<response> take_outcome(instant now) noexcept
    {
        orders_.note_outcome(base::asked_unit(), base::heard_of_unit(), base::was_repeated(), now);
        return base::take_outcome();
    }

    /// A word that stops comes by. Until it has left, nobody else asks; what is under way for its unit is given up,
    /// unless its answer is arriving, and what is under way for another is not repeated.
    template <typename Talk> constexpr void make_way_for(Talk& talk, instant now) noexcept
    {
        if (base::phase_now() == client_phase::idle and base::is_quiet()) {
            return; // it leaves in this pass
        }
        // Of several such words the first one to come by is next, also to drop what nobody comes for any more.
        if (not(turns_.is_reserved() and base::awaits_asker())) {
            turns_.reserve(talk);
        }
        bool may_cut = false;
        if constexpr (stops_everyone<Talk>) {
            may_cut = talk.may_cut(base::asked_unit());
        } else {
            may_cut = talk.unit().octet() == base::asked_unit();
        }
        base::make_way(may_cut, now);
        if (base::was_cut()) {
            static_cast<void>(base::take_outcome()); // its asker is told that it was cancelled
        }
    }

    /// Whether a word that stops may be asked: it waits for silence and for nobody.
    constexpr bool may_stop() noexcept
    {
        bool const may = base::phase_now() == client_phase::idle and base::is_quiet();
        if (may) {
            turns_.end_reservation();
        }
        return may;
    }

    /// Only the asker is missing, and another conversation comes by: whether it takes that one's place. Inlined: smaller.
    [[gnu::always_inline]] constexpr void replace_asker(standing place, instant now) noexcept
    {
        base::wake(now);
        bool const takes_over = place == standing::is_next and turns_.misses_asker();
        if (takes_over or place == standing::is_last) {
            base::drop(now);
            static_cast<void>(take_outcome(now));
        }
    }

    /// A conversation's unit is asked nothing now. Who asked last has had its turn; any other gets one behind that.
    constexpr errc hold_back(asker const& who) noexcept
    {
        if (not turns_.is_last(who)) {
            is_held_back_ = true;
        }
        return errc::pending;
    }

    /// Whether it is this conversation's turn to ask. While others wait, or for a question that is made at the
    /// last moment, the line has to be silent first.
    constexpr bool may_ask(asker& who, bool is_prompt, instant now) noexcept
    {
        if (base::phase_now() != client_phase::idle) {
            return false;
        }
        bool const is_quiet = base::is_quiet();
        if constexpr (Orders::is_kept) {
            if (turns_.is_reserved() and not turns_.misses_reserver(who)) {
                if (is_quiet) {
                    base::wake(now);
                }
                return false;
            }
        }
        if (not turns_.others_wait() and (is_quiet or not is_prompt)) {
            return true;
        }
        standing const at = turns_.visit(who);
        bool const may = is_quiet and turns_.take(at);
        if (is_quiet and not may) {
            base::wake(now);
        }
        return may;
    }

    [[no_unique_address]] Orders orders_{};
};

/// A client that counts nothing.
using client = basic_client<no_statistics>;

/// The same for conversations that command the motors of up to `Units` units: start, stop, cycle and the like.
template <std::size_t Units = 1>
using drive_client = basic_client<no_statistics, held<line_timing>, held<client_options>,
                                  quarantine<1>, shared_memory, orders<Units>>;

/// The same where memory does not matter: its requests and answers may have any size.
using host_client = basic_client<no_statistics, held<line_timing>, held<client_options>,
                                 quarantine<1>, separate_memory, orders<32>>;

} // namespace rtuwire
