// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// The client's end of a line (SL 2.4.1): one request at a time. Owns neither the wire nor a clock; knows
// of functions only what wire/answer.hpp says. client/transaction.hpp does what one request needs,
// client/turns.hpp says whose it is and who is next.
#pragma once

#include <cstddef>

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
/// `Debts` holds the units that owe an answer; `Front` is `shared_memory` or `separate_memory`.
template <typename Statistics, typename Line = held<line_timing>,
          typename Options = held<client_options>, typename Debts = quarantine<1>,
          std::size_t Front = shared_memory>
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
        if (base::advance(now) and is_held_back_) {
            is_held_back_ = false;
            turns_.void_marks();
            turns_.note_waiting();
        }
    }

    /// When the next pass has something to do.
    [[nodiscard]] constexpr deadline poll_deadline() const noexcept
    {
        earliest next;
        base::add_to(next);
        return next;
    }

    /// Gives up what is under way, only where it is this conversation's.
    constexpr void cancel(asker const& whose, instant now) noexcept
    {
        if (is_asked_by(whose)) {
            cancel(now);
        }
    }

    /// Whether it was this conversation that asked last.
    [[nodiscard]] constexpr bool is_asked_by(asker const& who) const noexcept
    {
        return turns_.is_own(who);
    }

    /// Lets a conversation come by: hands it its outcome, and asks its next question when it is its turn. After
    /// an outcome the next turn is that of the others that came by meanwhile. A question to a unit that owes an
    /// answer stays with its conversation; a question that cannot be asked at all is refused at once.
    template <conversation Talk> constexpr void converse(Talk& talk, instant now) noexcept
    {
        client_options const& all = base::options();
        converse(talk, now, {.response_timeout = all.response_timeout, .retries = all.retries});
    }

    /// The same, with patience for this conversation's unit.
    template <conversation Talk>
    constexpr void converse(Talk& talk, instant now, patience const& with) noexcept
    {
        static_cast<void>(deliver(talk, not talk.settled(), now));
        advance_talk(talk, now);
        static_cast<void>(ask(talk, now, with));
    }

    /// The first part of `converse`: the error of the outcome that the conversation was handed (`none` for an
    /// answer), or `pending`. `wants_turn` tells whether it has something to ask.
    template <conversation Talk>
    constexpr errc deliver(Talk& talk, bool wants_turn, instant now) noexcept
    {
        errc told = errc::pending;
        if (turns_.was_dropped(talk, base::phase_now() == client_phase::idle)) {
            told = errc::cancelled;
            talk.accept(told);
            wants_turn = wants_turn and not talk.settled();
        }
        if (not comes_by(talk, wants_turn, now)) { // what lies there may be another's
            return told;
        }
        turns_.renew(talk);
        talk.forget();
        result<response> const outcome = base::take_outcome();
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
        if (not may_ask(talk, prompt_conversation<Talk>, now)) {
            return errc::busy;
        }
        if constexpr (prompt_conversation<Talk>) {
            if (base::is_held(talk.unit())) {
                return hold_back(talk);
            }
        }
        auto const question = talk.next();
        if (not question) {
            return errc::pending;
        }
        if (base::owes(*question)) {
            return hold_back(talk);
        }
        errc const wrong = base::start(*question, now, with);
        if (wrong != errc::none) {
            talk.accept(wrong);
            base::wake(now); // it may have another question, and nothing else would tell
            return wrong;
        }
        turns_.renew(talk);
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

    /// Only the asker is missing, and another conversation comes by: whether it takes that one's place.
    constexpr void replace_asker(standing place, instant now) noexcept
    {
        base::wake(now);
        bool const takes_over = place == standing::is_next and turns_.misses_asker();
        if (takes_over or place == standing::is_last) {
            base::cancel(now);
            static_cast<void>(base::take_outcome());
        }
    }

    /// A conversation's unit is asked nothing now. Who asked last has had its turn; any other gets one when that is
    /// over.
    constexpr errc hold_back(asker const& who) noexcept
    {
        is_held_back_ = is_held_back_ or not turns_.is_last(who);
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
};

/// A client that counts nothing.
using client = basic_client<no_statistics>;

/// The same where memory does not matter: its requests and answers may have any size.
using host_client = basic_client<no_statistics, held<line_timing>, held<client_options>,
                                 quarantine<1>, separate_memory>;

} // namespace rtuwire
