// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// The client's end of a line (SL 2.4.1): one request at a time, for any number of conversations. Owns neither the wire nor a
// clock. A client has the schedule of its conversations (client/turns.hpp), in it the transaction, which runs the request under
// way and knows no conversation (client/line/transaction.hpp); and the orders of those that command motors (client/orders.hpp).
// Here the three meet: a conversation that visits gets its outcome, and leaves its next request where it is its turn and no
// order forbids it.
#pragma once

#include <concepts>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <type_traits>

#include <rtuwire/ask/commander.hpp>
#include <rtuwire/ask/conversation.hpp>
#include <rtuwire/client/line/request.hpp>
#include <rtuwire/client/line/transaction.hpp>
#include <rtuwire/client/needs.hpp>
#include <rtuwire/client/orders.hpp>
#include <rtuwire/client/turns.hpp>
#include <rtuwire/core/bytes.hpp>
#include <rtuwire/core/result.hpp>
#include <rtuwire/core/time.hpp>
#include <rtuwire/core/version.hpp>
#include <rtuwire/rtu/line.hpp>
#include <rtuwire/trace/observer.hpp>
#include <rtuwire/wire/errc.hpp>
#include <rtuwire/wire/unit_id.hpp>

namespace rtuwire {
inline namespace RTUWIRE_BUILD {

/// Sends one request at a time, for any number of conversations. In each pass call `receive` with what arrived, `sent`
/// when the last stop bit has left, `advance`; then `converse` for each conversation, in the same order; then send
/// what `poll_transmit` returns. Sleep no longer than until `poll_deadline`. Whoever comes later, even by
/// hours, finds the times of before over: a program may be stopped, and a client left unused, for any time.
///
/// Lifetimes: a conversation may be destroyed, moved or begun anew between any two calls. A request, and each
/// repetition of it, leaves only in a pass in which its conversation visits (`converse` is called for it); the bytes
/// to send are the client's own and unchanged until `sent` is called or the client's wait for it times out; an outcome
/// goes to the conversation that asked, or is dropped. A client may be assigned, or made anew in its place: what its
/// conversations asked and ordered before is over, and they may ask and order anew. A copy is another client: it sends
/// nothing that its original was asked, and counts none of its orders; it knows which motors these may have left running,
/// and holds what stops held: a stop that visits the copy ends its hold there; for one that does not, call `release`.
///
/// `Needs` is the constant that says what it is for: see `client_needs`. `client`, `drive_client`, `static_client` and
/// `host_client` are names for the frequent ones.
template <auto const& Needs> class basic_client {
    using needed = detail::told_by<Needs>;
    using Observer = typename needed::observer;
    using Orders = std::conditional_t<Needs.motors == 0, detail::no_orders, detail::orders<Needs.motors>>;
    using Schedule = detail::schedule<detail::transaction<Needs>,
                                      std::conditional_t<Orders::is_kept, detail::reservation, detail::no_reservation>>;

public:
    /// The same, of which a sink takes the frames as they pass, from `trace_to(sink)` on:
    /// `client::traced_by<trace_ring<4096>>`.
    template <typename Sink> using traced_by = basic_client<detail::traced_needs<Needs, Sink>>;
    /// The same that counts: `drive_client<3>::observed_by<unit_statistics<3>>`.
    template <typename Counts> using observed_by = basic_client<detail::observed_needs<Needs, Counts>>;

    /// With these times and options, which are copied.
    explicit constexpr basic_client(line_timing const& its_timing, client_options const& its_options = {}) noexcept
        requires(not needed::is_fixed)
        : schedule_{its_timing, its_options}
    {}

    /// For needs with a `timing`. Zero-initialised, so a `constinit` client lives in .bss.
    constexpr basic_client() noexcept requires(needed::is_fixed) = default;

    // The line.

    /// Takes bytes that had arrived by `now`, in any chunking. While no response is awaited they are noise: dropped,
    /// but the line was not silent. A response that is passed in before `advance` has seen the time-out is in time. One that
    /// its length ends, with a right CRC, ends the request here; any other in `advance`.
    constexpr void receive(byte_view const& bytes, instant now) noexcept { transaction().receive(bytes, now); }

    /// The same of one byte: a program that calls only this has no code for chunks.
    constexpr void receive(std::same_as<std::byte> auto byte, instant now) noexcept
    {
        transaction().receive(byte, now);
    }

    /// Reports a receive error (parity, framing, overrun).
    constexpr void receive_error(instant now) noexcept { transaction().receive_error(now); }

    /// Notes that the last stop bit of what `poll_transmit` returned has left at `at`, or will have left by then.
    constexpr void sent(instant at) noexcept
    {
        sent(at, [](instant) {});
    }

    /// The same. Where the program was stopped since the latest `advance`, `judge` gets the time by which the times that
    /// were in force are judged.
    /// Internal.
    constexpr void sent(instant at, auto judge) noexcept
    {
        bool const was_leaving = detail::is_leaving(phase_now());
        transaction().sent(at);
        if constexpr (detail::has_system) { // elsewhere nothing stops the program between this and `advance`
            if (was_leaving) {
                duration const ahead = transaction().time_to_send();
                keep_up(at - ahead, ahead, judge);
            }
        }
    }

    /// Lets time pass.
    constexpr void advance(instant now) noexcept { static_cast<void>(advance_within_reach(now)); }

    /// The same. Returns the time by which what was in force before is to be judged: see `within_reach`.
    /// Internal.
    constexpr instant advance_within_reach(instant now) noexcept
    {
        instant const at = judged_at(now);
        seen_ = instant{now.microseconds | 1U}; // never 0
        bool const is_silence_over = orders_.advance(at, is_busy(), asked_unit());
        if (transaction().advance(now, at) or is_silence_over) {
            schedule_.note_free_unit();
        }
        return at;
    }

    /// The time by which a deadline that was named since the last `advance` is to be judged `now`: see `within_reach`.
    /// Internal.
    [[nodiscard]] constexpr instant judged_at(instant now) const noexcept
    {
        return seen_ == instant{0} ? now : detail::within_reach(seen_, now); // 0: the first time
    }

    /// The bytes to send now, each request and repetition once; empty when there is nothing to send. Unchanged until `sent`.
    [[nodiscard]] constexpr byte_view poll_transmit() noexcept { return transaction().poll_transmit(); }

    /// When the next pass has something to do; behind an outcome at once or when the line is silent, so that who was begun
    /// anew asks again. It knows nothing of what was begun from elsewhere since its last visit: let it visit before the loop sleeps.
    [[nodiscard]] constexpr deadline poll_deadline() const noexcept
    {
        detail::earliest next;
        add_to(next);
        return next;
    }

    /// The same, for a caller that collects several.
    constexpr void add_to(detail::earliest& next) const noexcept
    {
        transaction().add_to(next, schedule_.is_reserved(), instant{seen_.microseconds - 1U});
        orders_.add_to(next);
    }

    /// The timing of its line.
    [[nodiscard]] constexpr line_timing const& line() const noexcept { return transaction().line(); }

    /// Whether the line has fallen silent since the last byte.
    [[nodiscard]] constexpr bool is_quiet() const noexcept { return transaction().is_quiet(); }

    /// Whether the line has given back what was sent: `client_options::has_line_echo` says what follows.
    [[nodiscard]] constexpr bool has_seen_echo() const noexcept { return transaction().has_seen_echo(); }

    /// What was counted.
    [[nodiscard]] constexpr auto& statistics() noexcept { return detail::first_of(transaction().observer()); }
    [[nodiscard]] constexpr auto const& statistics() const noexcept
    {
        return detail::first_of(transaction().observer());
    }

    /// Hands the frames that pass from here on to a sink, which must outlive the client. For a client `traced_by` it.
    template <typename Sink>
        requires detail::is_traced_by<Observer, Sink>
    constexpr void trace_to(Sink& frames) noexcept { transaction().observer().trace_to(frames); }

    // The request under way.

    /// Whether a request is under way or its outcome not taken yet.
    [[nodiscard]] constexpr bool is_busy() const noexcept { return transaction().is_busy(); }

    /// How far it is.
    /// Internal.
    [[nodiscard]] constexpr detail::client_phase phase_now() const noexcept { return transaction().phase_now(); }

    /// The unit of the last request; 0 for a broadcast.
    [[nodiscard]] constexpr std::uint8_t asked_unit() const noexcept { return transaction().asked_unit(); }

    /// Whether it was this conversation that asked last.
    [[nodiscard]] constexpr bool is_asked_by(asker const& who) const noexcept { return turns().is_own(who); }

    /// Gives up the request under way, of whichever conversation; its outcome is `cancelled`, which its conversation takes at
    /// its next visit: no deadline tells of that. A write may have taken effect all the same. A frame that is leaving leaves
    /// whole, and a broadcast gets its turnaround; the outcome comes then.
    constexpr void cancel(instant now) noexcept
    {
        cancel(now, [](instant) {});
    }

    /// The same, only where it is this conversation's.
    constexpr void cancel(asker const& whose, instant now) noexcept
    {
        if (is_asked_by(whose)) {
            cancel(now);
        }
    }

    /// The same, as for `sent`.
    /// Internal.
    constexpr void cancel(instant now, auto judge) noexcept
    {
        if (detail::is_under_way(phase_now())) {
            keep_up(now, duration{}, judge);
        }
        transaction().cancel(now);
    }

    /// The frame for which the last request failed, with `wrong_length`, `crc_mismatch` and the like; nothing where it was
    /// no frame, or where more has arrived behind it. Valid until bytes are taken or the next request begins.
    [[nodiscard]] constexpr std::optional<detail::refused_frame> refused() const noexcept
    {
        return transaction().refused();
    }

    /// Sends no request of any conversation to a unit from here until `end`, at most 35 minutes away. A request that
    /// is leaving or waits for its response is not ended. The latest of several ends counts.
    constexpr void hold(unit_id unit, instant end) noexcept { transaction().keep_away(unit, end); }

    /// Whether no new request goes to a unit now: its response is outstanding, `hold` says so, or it was lost while it
    /// was ordered to run, and its own time-out has to stop it.
    [[nodiscard]] constexpr bool is_held(std::uint8_t unit) const noexcept
    {
        return is_barred(unit, detail::effect::none);
    }
    [[nodiscard]] constexpr bool is_held(unit_id unit) const noexcept { return is_held(unit.byte()); }

    // The motors.

    /// Which motors this client ordered to run.
    [[nodiscard]] constexpr Orders& motor_orders() noexcept { return orders_; }
    [[nodiscard]] constexpr Orders const& motor_orders() const noexcept { return orders_; }

    /// Ends the hold of a stop that was given up before its end: its unit can be commanded again; all units, where a
    /// stop of all units was given up. Where no stop holds a unit nothing changes.
    constexpr void release(unit_id unit) noexcept requires(Orders::is_kept) { orders_.release(unit.byte()); }
    constexpr void release_all() noexcept requires(Orders::is_kept) { orders_.release_all(); }

    // The visit of a conversation: it gets its outcome, says what it orders, and asks.

    /// One visit of a conversation: gives it its outcome, and takes its next request when it is its turn. After an
    /// outcome the next turn is that of the others that visited meanwhile. A request to a unit with an outstanding
    /// response stays with its conversation; a request that cannot be sent at all is refused at once. Of a conversation
    /// that had settled before this visit nothing is sent, and its outcome says `used_already` from here on: read it in
    /// the pass in which it settles. A conversation has a name, and lives until it has settled: of one that has none the
    /// response would be lost, so none is taken.
    template <conversation Conversation> constexpr void converse(Conversation& conversation, instant now) noexcept
    {
        client_options const& all = transaction().options();
        // The time is constructed anew: GCC would read a constant's copy from memory.
        converse(conversation, now,
                 {.response_timeout = duration{all.response_timeout.microseconds}, .retries = all.retries});
    }

    /// The same, with a `retry_policy` for this conversation's unit.
    template <conversation Conversation>
    constexpr void converse(Conversation& who, instant now, retry_policy const& with) noexcept
    {
        auto& conversation = detail::as_visited(who);
        constexpr bool may_come = may_visit<std::remove_reference_t<decltype(conversation)>>;
        static_assert(may_come, "this client does not keep whose motor it ordered to run: take drive_client<Units>, or "
                                "a bus");
        if constexpr (may_come) { // else a compiler tells, besides, of each part that a plain client lacks
            static_cast<void>(deliver(conversation, not conversation.settled(), now));
            advance_and_note(conversation, now);
            static_cast<void>(ask(conversation, now, with));
            if constexpr (Orders::is_kept and detail::timed_conversation<Conversation>) {
                orders_.wake_for(conversation.poll_deadline(), now);
            }
        }
    }

    /// A request by itself is taken in order to be refused in plain words.
    template <typename To, detail::pdu Request>
    constexpr result<typename Request::response> ask(To, Request const&) noexcept
    {
        static_assert(not detail::pdu<Request>,
                      "this client waits for no response: name a single_request{unit, request} "
                      "and give it to `converse` in each pass; a blocking_client waits");
        return errc::busy;
    }

    /// The first part of `converse`: the error of the outcome that the conversation was given (`none` for a response),
    /// if it was given one. `wants_turn` tells whether it has a request to send.
    template <conversation Conversation>
    constexpr std::optional<errc> deliver(Conversation& conversation, bool wants_turn, instant now) noexcept
    {
        if (was_never_advanced()) {
            transaction().end_never_advanced(now);
        }
        std::optional<errc> told;
        if (turns().was_dropped(conversation, not is_busy())) {
            told = reason_of_drop(conversation);
            conversation.accept(*told);
            wants_turn = wants_turn and not conversation.settled();
        } else {
            turns().meet(conversation, conversation.settled());
        }
        if (not claims_outcome(conversation, wants_turn, now)) { // the outcome may be another's
            return told;
        }
        turns().renew(conversation); // the marks of all others are void, its own stays valid
        conversation.forget();
        result<response> const outcome = take_and_note_outcome(now);
        conversation.accept(outcome);
        if (conversation.settled() and is_quiet()) {
            transaction().wake(now); // it may be begun anew behind its visit, and no silence ahead brings the next pass
        }
        return outcome.error();
    }

    /// The second part of `converse`: lets time pass for the conversation, and notes what a commander's user wants. A
    /// stop request gets the line first, unless it `may_ask` nothing in this pass, or a later stop has its unit: then it takes
    /// the line from nobody.
    template <conversation Conversation>
    constexpr void advance_and_note(Conversation& conversation, instant now, bool may_ask = true) noexcept
    {
        if constexpr (Orders::is_kept and detail::may_be_stop<Conversation>) {
            orders_.tell(conversation); // what it begins with depends on it
        }
        detail::advance_conversation(conversation, now);
        if constexpr (detail::stops_by_broadcast<Conversation>) {
            note_stop_of_all(conversation, now);
        } else if constexpr (detail::commanding_conversation<Conversation>) {
            bool const stops = conversation.begins_to_stop();
            note_commander(conversation, now);
            if (stops and not is_asked_by(conversation)) {
                note_way(schedule_.withdraw(conversation.unit().byte(), now), now); // its first request may be a read
            }
        }
        if constexpr (may_stop_motors<Conversation>) {
            bool const is_due = may_ask and detail::effect_of(conversation) == detail::effect::stopping;
            if (is_due and not is_asked_by(conversation) and
                check_order(conversation, detail::effect::stopping) == errc::none and not schedule_.is_free()) {
                note_way(schedule_.make_way_for(conversation, detail::unit_stopped_by(conversation),
                                                detail::may_cut(conversation, asked_unit()), now),
                         now);
            }
        }
    }

    /// The last part of `converse`. Where the request is refused, the conversation is given the error as its outcome.
    template <conversation Conversation>
    constexpr detail::turn_result ask(Conversation& conversation, instant now, retry_policy const& with) noexcept
    {
        static_assert(detail::has_what_it_declares<Conversation>());
        static_assert(detail::has_all_for<Needs, Conversation>());
        static_assert(
            Needs.has_only_unit or not detail::asks_only_unit<Conversation>(),
            "this client sends broadcasts to address 0, where the conversation asks a unit: on a line with one "
            "unit, give its client_needs has_only_unit");
        if (conversation.settled() and not turns().is_last(conversation)) { // the visit of the last opens others' turn
            return detail::turn_result::passed;
        }
        detail::effect const what = detail::effect_of(conversation);
        if (not has_turn(conversation, what, now)) {
            return detail::turn_result::waits;
        }
        if constexpr (detail::prompt_conversation<Conversation>) {
            if (errc const wrong = check_order(conversation, what); wrong != errc::none) {
                return refuse(conversation, wrong, now);
            }
            if (is_barred(conversation.unit().byte(), what)) {
                return schedule_.put_off(conversation);
            }
        }
        auto const request = conversation.next();
        if (not request) {
            return detail::turn_result::passed;
        }
        std::uint8_t const unit = request->frame().empty() ? std::uint8_t{0} : detail::to_u8(request->frame()[0]);
        if (is_barred(detail::asks_only_unit<Conversation>() ? detail::any_unit : unit, what)) {
            return schedule_.put_off(conversation);
        }
        transaction().expect(detail::asks_only_unit<Conversation>());
        errc const wrong = start(detail::as_declared<Conversation>(*request), now, unit, with,
                                 detail::timeout_of(conversation, with.response_timeout));
        if (wrong != errc::none) {
            return refuse(conversation, wrong, now);
        }
        if constexpr (Orders::is_kept and detail::may_write_meaning<Conversation>) {
            orders_.note_request(request->frame());
        }
        turns().renew(conversation);
        note_asked(conversation, what);
        return detail::turn_result::asked;
    }

    /// Whether the request has left and others wait already: visits change nothing but the marks of those.
    /// Internal.
    [[nodiscard]] constexpr bool needs_no_visit() const noexcept { return schedule_.needs_no_visit(); }

private:
    constexpr auto& transaction() noexcept { return schedule_.transaction(); }
    constexpr auto const& transaction() const noexcept { return schedule_.transaction(); }
    constexpr detail::turns& turns() noexcept { return schedule_.turns(); }
    constexpr detail::turns const& turns() const noexcept { return schedule_.turns(); }

    /// Whether a conversation of this type may visit: what commands a motor has to be kept.
    template <typename Conversation>
    static constexpr bool may_visit = Orders::is_kept or not(detail::commanding_conversation<Conversation> or
                                                             detail::stops_by_broadcast<Conversation>);

    /// Before a time limit begins: where the latest `advance` was more than a second ago, time passes first. Else the next
    /// one, behind a second pause, would judge the new limit from before the first. The latest `advance` may have been later
    /// than `now`, by `ahead`.
    constexpr void keep_up(instant now, duration ahead, auto judge) noexcept
    {
        constexpr duration longest_pass{std::uint32_t{1} << 20U};
        constexpr duration latency = milliseconds(100);
        std::uint32_t const most = 0U - (longest_pass + latency).microseconds - ahead.microseconds;
        if (seen_ != instant{0} and (now - seen_).microseconds - longest_pass.microseconds < most) {
            judge(advance_within_reach(now));
        }
    }

    /// Found out where misuse is.
    constexpr bool was_never_advanced() const noexcept { return detail::is_misuse_caught() and seen_ == instant{0}; }

    // Whose turn it is.

    /// A conversation visits, and claims the outcome. Returns whether it is there and its own. A request is dropped where the
    /// next in turn finds its asker missing twice, or where the asker itself has given it up.
    constexpr bool claims_outcome(asker& who, bool wants_turn, instant now) noexcept
    {
        detail::client_phase const at = phase_now();
        bool const is_own = is_asked_by(who);
        if (at == detail::client_phase::idle or not(is_own or wants_turn)) {
            return false;
        }
        detail::standing place = detail::standing::is_last;
        if (not is_own) {
            place = turns().mark(who);
        } else if (at == detail::client_phase::settled) {
            return true;
        } else if (at == detail::client_phase::waiting) {
            turns().renew(who);
        }
        if (transaction().awaits_asker(schedule_.is_for_stops())) {
            if (is_own) {
                transaction().get_ready(now);
            } else {
                replace_asker(place, now);
            }
        }
        return false;
    }

    /// Only the asker is missing, and another conversation visits: whether that one takes its place. Inlined: smaller.
    [[gnu::always_inline]] constexpr void replace_asker(detail::standing place, instant now) noexcept
    {
        transaction().wake(now);
        bool const takes_over = place == detail::standing::is_next and turns().misses_asker();
        if (takes_over or place == detail::standing::is_last) {
            transaction().drop(now);
            static_cast<void>(take_and_note_outcome(now));
        }
    }

    /// The outcome of the request. A missing response is noted, whatever becomes of the asker: a request that is
    /// not waited for has also fed its unit's watchdog.
    constexpr result<response> take_and_note_outcome(instant now) noexcept
    {
        orders_.note_outcome(transaction().held_unit(), transaction().heard_of_unit(), transaction().was_repeated(),
                             now);
        return transaction().take_outcome();
    }

    /// A stop has the line made free for it; `is_cut`: the request under way is given up for that. One that was given up
    /// ends, and its asker is told at its next visit. Not inlined: it is called for each kind of conversation.
    [[gnu::noinline]] constexpr void note_way(bool is_cut, instant now) noexcept
    {
        if (is_cut) {
            orders_.note_cut();
        }
        if (transaction().is_given_up()) {
            static_cast<void>(take_and_note_outcome(now));
            turns().void_marks(); // this visit counts once
        }
    }

    /// Whether a conversation may ask now: a stop request does not wait for its turn.
    template <typename Conversation>
    constexpr bool has_turn(Conversation& conversation, detail::effect what, instant now) noexcept
    {
        if constexpr (may_stop_motors<Conversation>) {
            if (what == detail::effect::stopping) {
                return schedule_.may_stop(conversation, detail::unit_stopped_by(conversation), now);
            }
        }
        constexpr bool is_prompt = detail::prompt_conversation<Conversation>;
        if (not is_prompt and was_never_advanced()) {
            return schedule_.may_ask_in_vain(conversation);
        }
        return schedule_.may_ask(conversation, is_prompt, now);
    }

    /// A request cannot be sent.
    template <typename Conversation>
    constexpr detail::turn_result refuse(Conversation& conversation, errc wrong, instant now) noexcept
    {
        conversation.accept(wrong);
        transaction().wake(now); // it may have another request, and no deadline shows that
        return detail::turn_result::passed;
    }

    /// Starts a request to a unit. To a lost unit each stop request is sent once.
    constexpr errc start(request_frame const& asked, instant now, std::uint8_t unit, retry_policy const& with,
                         duration timeout) noexcept
    {
        if constexpr (Orders::is_kept) {
            orders_.note_start(now);
            retry_policy own = with;
            own.response_timeout = timeout;
            own.retries = orders_.is_lost(unit) ? std::uint8_t{0} : with.retries;
            return transaction().start(asked, now, own);
        } else {
            return transaction().start(asked, now, with); // no commander visits
        }
    }

    // What commanders may do. For other conversations these functions do nothing.

    /// A commander of one unit visits.
    template <typename Conversation> constexpr void note_commander(Conversation& conversation, instant now) noexcept
    {
        if (orders_.take_note_of(conversation, now)) {
            conversation.note_loss();
        }
        if (not conversation.settled()) {
            orders_.note_under_way(conversation);
        }
        if constexpr (detail::may_be_stop<Conversation>) {
            if (conversation.take_other_family()) {
                orders_.leave_alone(conversation.unit().byte(), now);
            }
        }
    }

    /// A commander of all units visits, and with it its stops of one unit each.
    template <typename Conversation> constexpr void note_stop_of_all(Conversation& conversation, instant now) noexcept
    {
        orders_.take_note_of_all(conversation, now);
        for (auto& each : conversation.stops()) {
            static_assert(detail::commanding_conversation<std::remove_reference_t<decltype(each)>>,
                          "each stop of a conversation that stops all units commands one of them");
            note_commander(detail::as_visited(each), now);
        }
        if (conversation.is_urgent()) {
            orders_.lose_all_but_its_own(conversation, now);
        }
        orders_.note_ordered(conversation);
    }

    /// Whether a conversation's requests may be stop requests: these get the line first.
    template <typename Conversation>
    static constexpr bool may_stop_motors = detail::commanding_conversation<Conversation> or
                                            detail::stops_by_broadcast<Conversation> or
                                            (Orders::is_kept and detail::frees_all_units<Conversation>);

    template <typename Conversation>
    constexpr errc check_order(Conversation const& conversation, detail::effect what) const noexcept
    {
        if constexpr (detail::commanding_conversation<Conversation>) {
            return orders_.check(conversation, what);
        }
        return errc::none;
    }

    template <typename Conversation> constexpr void note_asked(Conversation& conversation, detail::effect what) noexcept
    {
        if constexpr (detail::commanding_conversation<Conversation>) {
            orders_.note_asked(conversation, what, conversation.drive_timeout(), conversation.tolerated_misses());
        } else if constexpr (detail::stops_by_broadcast<Conversation>) {
            for (auto& each : conversation.stops()) {
                if (each.unit().byte() == asked_unit()) {
                    note_asked(detail::as_visited(each), what);
                }
            }
        } else if constexpr (Orders::is_kept and detail::frees_all_units<Conversation>) {
            orders_.note_all_freed();
        }
    }

    /// Why a request was given up: a stop of its unit came before it, or it was cancelled.
    template <typename Conversation> constexpr errc reason_of_drop(Conversation const& conversation) const noexcept
    {
        if constexpr (detail::commanding_conversation<Conversation>) {
            return orders_.is_overruled(conversation) ? errc::overruled : errc::cancelled;
        }
        return errc::cancelled;
    }

    /// Whether a unit gets no request of this effect now. Stop requests do not wait for outstanding responses of their
    /// unit: none of these is the echo of a stop request.
    constexpr bool is_barred(std::uint8_t unit, detail::effect what) const noexcept
    {
        return orders_.is_silent(unit, what) or (what != detail::effect::stopping and transaction().is_kept_away(unit));
    }

    [[no_unique_address]] Schedule schedule_;
    instant seen_{0}; ///< the latest `advance`
    [[no_unique_address]] Orders orders_;
};

} // namespace RTUWIRE_BUILD
} // namespace rtuwire
