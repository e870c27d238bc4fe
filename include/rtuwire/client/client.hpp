// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// The client's end of a line (SL 2.4.1): one request at a time. Owns neither the wire nor a clock; knows of functions
// only what wire/response.hpp says. client/transaction.hpp runs one request, client/turns.hpp knows whose it is and
// who is next, client/orders.hpp which motors run by order.
#pragma once

#include <cstddef>

#include <rtuwire/ask/commander.hpp>
#include <rtuwire/client/orders.hpp>
#include <rtuwire/client/transaction.hpp>
#include <rtuwire/core/version.hpp>

namespace rtuwire::inline RTUWIRE_BUILD {

/// Sends one request at a time, for any number of conversations. In each pass call `receive` with what arrived, `sent`
/// when the last stop bit has left, `advance`; then `converse` for each conversation, in the same order; then send
/// what `poll_transmit` returns. Sleep no longer than until `poll_deadline`.
///
/// Lifetimes: a conversation may be destroyed, moved or begun anew between any two calls. A request, and each
/// repetition of it, leaves only in a pass in which its conversation visits (`converse` is called for it); the bytes
/// to send are the client's own and unchanged until `sent` is called or the client's wait for it times out; an outcome
/// goes to the conversation that asked, or is dropped.
///
/// `Debts` holds the units with an outstanding response; `Front` is `shared_memory` or `separate_memory`; `Orders` is
/// `no_orders`, or `orders<Units>` for conversations that command motors: see client/orders.hpp.
template <typename Statistics, typename Line = stored<line_timing>, typename Options = stored<client_options>,
          typename Debts = quarantine<1>, std::size_t Front = shared_memory, typename Orders = no_orders>
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

    /// The same, for a caller that collects several.
    constexpr void add_to(earliest& next) const noexcept
    {
        base::add_to(next);
        orders_.add_to(next);
    }

    /// Whether no new request goes to a unit now: its response is outstanding, `hold` says so, or it was lost while it
    /// was ordered to run, and its own time-out has to stop it.
    [[nodiscard]] constexpr bool is_held(std::uint8_t unit) const noexcept
    {
        return base::is_held(unit) or orders_.is_silent(unit, effect::none);
    }
    [[nodiscard]] constexpr bool is_held(unit_id unit) const noexcept { return is_held(unit.byte()); }

    /// Which motors this client ordered to run.
    [[nodiscard]] constexpr Orders& motor_orders() noexcept { return orders_; }
    [[nodiscard]] constexpr Orders const& motor_orders() const noexcept { return orders_; }

    /// Ends the hold of a stop that was given up before its end: its unit can be commanded again; all units, where a
    /// stop of all units was given up.
    constexpr void release(unit_id unit) noexcept requires(Orders::is_kept) { orders_.release(unit.byte()); }
    constexpr void release_all() noexcept requires(Orders::is_kept) { orders_.release_all(); }

    /// Gives up the request under way, only where it is this conversation's.
    constexpr void cancel(asker const& whose, instant now) noexcept
    {
        if (is_asked_by(whose)) {
            cancel(now);
        }
    }

    /// Whether it was this conversation that asked last.
    [[nodiscard]] constexpr bool is_asked_by(asker const& who) const noexcept { return turns_.is_own(who); }

    /// One visit of a conversation: gives it its outcome, and takes its next request when it is its turn. After an
    /// outcome the next turn is that of the others that visited meanwhile. A request to a unit with an outstanding
    /// response stays with its conversation; a request that cannot be sent at all is refused at once.
    template <conversation Conversation> constexpr void converse(Conversation& conversation, instant now) noexcept
    {
        client_options const& all = base::options();
        // The time is constructed anew: GCC would read a constant's copy from memory.
        converse(conversation, now,
                 {.response_timeout = duration{all.response_timeout.microseconds}, .retries = all.retries});
    }

    /// The same, with a `retry_policy` for this conversation's unit.
    template <conversation Conversation>
    constexpr void converse(Conversation& conversation, instant now, retry_policy const& with) noexcept
    {
        static_cast<void>(deliver(conversation, not conversation.settled(), now));
        advance_conversation(conversation, now);
        command(conversation, now);
        static_cast<void>(ask(conversation, now, with));
        if constexpr (Orders::is_kept and timed_conversation<Conversation>) {
            orders_.wake_for(conversation.poll_deadline(), now);
        }
    }

    /// The second part of `converse`, after its `advance`: notes what a commander's user wants. A stop request gets
    /// the line first.
    template <conversation Conversation> constexpr void command(Conversation& conversation, instant now) noexcept
    {
        if constexpr (commanding_conversation<Conversation> or stops_by_broadcast<Conversation>) {
            static_assert(Orders::is_kept, "this client does not keep whose motor it ordered to run: take "
                                           "drive_client<Units>, or a bus");
            if constexpr (stops_by_broadcast<Conversation>) {
                orders_.visit_for_all(conversation, now);
                for (auto& each : conversation.stops()) {
                    if (orders_.visit(each, each.unit().byte(), now)) {
                        each.note_loss();
                    }
                }
            } else if (orders_.visit(conversation, conversation.unit().byte(), now)) {
                conversation.note_loss();
            }
            if (conversation.intent() == effect::stopping and not is_asked_by(conversation)) {
                make_way_for(conversation, now);
            }
        }
    }

    /// The first part of `converse`: the error of the outcome that the conversation was given (`none` for a response),
    /// or `pending`. `wants_turn` tells whether it has a request to send.
    template <conversation Conversation>
    constexpr errc deliver(Conversation& conversation, bool wants_turn, instant now) noexcept
    {
        errc told = errc::pending;
        if (turns_.was_dropped(conversation, base::phase_now() == client_phase::idle)) {
            told = reason_of_drop(conversation);
            conversation.accept(told);
            wants_turn = wants_turn and not conversation.settled();
        }
        if (not comes_by(conversation, wants_turn, now)) { // the outcome may be another's
            return told;
        }
        turns_.renew(conversation);
        conversation.forget();
        result<response> const outcome = take_outcome(now);
        conversation.accept(outcome);
        return outcome.error();
    }

    /// The last part of `converse`: `none` where a request was taken, `busy` where it is not the turn of this
    /// conversation, `pending` where it has no request now or its unit is held; otherwise why the request was refused,
    /// which the conversation was given as its outcome.
    template <conversation Conversation>
    constexpr errc ask(Conversation& conversation, instant now, retry_policy const& with) noexcept
    {
        if (conversation.settled() and not turns_.is_last(conversation)) {
            return errc::pending;
        }
        effect const what = effect_of(conversation);
        if (what == effect::stopping ? not may_stop()
                                     : not may_ask(conversation, prompt_conversation<Conversation>, now)) {
            return errc::busy;
        }
        if constexpr (prompt_conversation<Conversation>) {
            if (errc const wrong = check_order(conversation, what); wrong != errc::none) {
                return refuse(conversation, wrong, now);
            }
            if (is_barred(conversation.unit().byte(), what)) {
                return hold_back(conversation);
            }
        }
        auto const request = conversation.next();
        if (not request) {
            return errc::pending;
        }
        std::uint8_t const unit = request->frame().empty() ? std::uint8_t{0} : to_u8(request->frame()[0]);
        if (is_barred(unit, what)) {
            return hold_back(conversation);
        }
        errc const wrong = start(*request, now, unit, with);
        if (wrong != errc::none) {
            return refuse(conversation, wrong, now);
        }
        turns_.renew(conversation);
        note_asked(conversation, what);
        return errc::none;
    }

private:
    /// A conversation visits. Returns whether the outcome is there and its own. A request is dropped where the next in
    /// turn finds its asker missing twice, or where the asker itself has given it up.
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

    /// Why a request was given up: a stop of its unit came before it, or it was cancelled.
    template <typename Conversation> constexpr errc reason_of_drop(Conversation const& conversation) const noexcept
    {
        if constexpr (commanding_conversation<Conversation>) {
            return orders_.is_overruled(conversation, conversation.unit().byte()) ? errc::overruled : errc::cancelled;
        }
        return errc::cancelled;
    }

    /// What the next request of a conversation does to a motor.
    template <typename Conversation> static constexpr effect effect_of(Conversation const& conversation) noexcept
    {
        if constexpr (commanding_conversation<Conversation> or stops_by_broadcast<Conversation>) {
            return conversation.intent();
        }
        return effect::none;
    }

    /// Whether a unit gets no request of this effect now. Stop requests do not wait for outstanding responses of their
    /// unit: none of these is the echo of a stop request.
    constexpr bool is_barred(std::uint8_t unit, effect what) const noexcept
    {
        return orders_.is_silent(unit, what) or (what != effect::stopping and base::is_held(unit));
    }

    template <typename Conversation>
    constexpr errc check_order(Conversation const& conversation, effect what) const noexcept
    {
        if constexpr (commanding_conversation<Conversation>) {
            return orders_.check(conversation, conversation.unit().byte(), what);
        }
        return errc::none;
    }

    template <typename Conversation> constexpr void note_asked(Conversation& conversation, effect what) noexcept
    {
        if constexpr (commanding_conversation<Conversation>) {
            orders_.note_asked(conversation.unit().byte(), what, conversation.drive_timeout(),
                               conversation.tolerated_misses());
        } else if constexpr (stops_by_broadcast<Conversation>) {
            for (auto& each : conversation.stops()) {
                if (each.unit().byte() == base::asked_unit()) {
                    note_asked(each, what);
                }
            }
        }
    }

    /// Starts a request to a unit. To a lost unit each stop request is sent once.
    constexpr errc start(request_frame const& asked, instant now, std::uint8_t unit, retry_policy const& with) noexcept
    {
        if constexpr (Orders::is_kept) {
            retry_policy own = with;
            own.retries = orders_.is_lost(unit) ? std::uint8_t{0} : with.retries;
            return base::start(asked, now, own);
        } else {
            return base::start(asked, now, with);
        }
    }

    /// A request cannot be sent.
    template <typename Conversation> constexpr errc refuse(Conversation& conversation, errc wrong, instant now) noexcept
    {
        conversation.accept(wrong);
        base::wake(now); // it may have another request, and no deadline shows that
        return wrong;
    }

    /// The outcome of the request. A missing response is noted, whatever becomes of the asker: a request that is not
    /// waited for has also fed its unit's watchdog.
    constexpr result<response> take_outcome(instant now) noexcept
    {
        orders_.note_outcome(base::asked_unit(), base::heard_of_unit(), base::was_repeated(), now);
        return base::take_outcome();
    }

    /// A conversation visits with a stop request. Until that has left, no other conversation sends; a request under
    /// way for its unit is given up, unless its response is arriving, and one for another unit is not repeated.
    template <typename Conversation> constexpr void make_way_for(Conversation& conversation, instant now) noexcept
    {
        if (base::phase_now() == client_phase::idle and base::is_quiet()) {
            return; // it leaves in this pass
        }
        // Of several such requests the first one to visit is next, also to drop one whose asker no longer visits.
        if (not(turns_.is_reserved() and base::awaits_asker())) {
            turns_.reserve(conversation);
        }
        bool may_cut = false;
        if constexpr (stops_by_broadcast<Conversation>) {
            may_cut = conversation.may_cut(base::asked_unit());
        } else {
            may_cut = conversation.unit().byte() == base::asked_unit();
        }
        base::make_way(may_cut, now);
        if (base::was_cut()) {
            static_cast<void>(base::take_outcome()); // its asker is told that it was cancelled
        }
    }

    /// Whether a stop request may be sent: it waits for silence, but not for its turn.
    constexpr bool may_stop() noexcept
    {
        bool const may = base::phase_now() == client_phase::idle and base::is_quiet();
        if (may) {
            turns_.end_reservation();
        }
        return may;
    }

    /// Only the asker is missing, and another conversation visits: whether that one takes its place. Inlined: smaller.
    [[gnu::always_inline]] constexpr void replace_asker(standing place, instant now) noexcept
    {
        base::wake(now);
        bool const takes_over = place == standing::is_next and turns_.misses_asker();
        if (takes_over or place == standing::is_last) {
            base::drop(now);
            static_cast<void>(take_outcome(now));
        }
    }

    /// A conversation's unit gets no request now. The one that asked last has had its turn; others get one later.
    constexpr errc hold_back(asker const& who) noexcept
    {
        if (not turns_.is_last(who)) {
            is_held_back_ = true;
        }
        return errc::pending;
    }

    /// Whether it is this conversation's turn to ask. While others wait, or for a request that is made at the
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
using drive_client = basic_client<no_statistics, stored<line_timing>, stored<client_options>, quarantine<1>,
                                  shared_memory, orders<Units>>;

/// The same where memory does not matter: its requests and responses may have any size.
using host_client = basic_client<no_statistics, stored<line_timing>, stored<client_options>, quarantine<1>,
                                 separate_memory, orders<32>>;

} // namespace rtuwire
