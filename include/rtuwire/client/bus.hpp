// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// Many conversations on one line, taking turns request by request. A unit that does not respond is sent a request only
// now and then, one such unit after the other, so that all of them together cost the others no more than a share of
// the line.
#pragma once

#include <array>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <optional>

#include <rtuwire/ask/commander.hpp>
#include <rtuwire/ask/conversation.hpp>
#include <rtuwire/client/client.hpp>
#include <rtuwire/client/needs.hpp>
#include <rtuwire/core/bytes.hpp>
#include <rtuwire/core/time.hpp>
#include <rtuwire/core/version.hpp>
#include <rtuwire/trace/observer.hpp>
#include <rtuwire/trace/traced_frame.hpp>
#include <rtuwire/wire/errc.hpp>
#include <rtuwire/wire/function.hpp>
#include <rtuwire/wire/unit_id.hpp>

namespace rtuwire {
inline namespace RTUWIRE_BUILD {

/// How a bus treats units that do not answer.
struct bus_options {
    /// How much of the line's time all silent units together may cost, in percent, 1 to 100; a value outside counts as
    /// the nearer limit.
    std::uint8_t silent_share{10};
    /// After how many requests without a response a unit counts as silent; a unit that never responded, after one.
    std::uint8_t silent_after{2};
};

/// How a bus treats one unit.
struct slot_options {
    retry_policy with{};
    /// The least time from the outcome of this slot's request to its next one, which sets how often it asks. A unit that
    /// misses what comes too soon has the `pause` of its `retry_policy`, which holds for repetitions, too.
    duration least_idle{};
    /// The longest time from one request to this unit to the next; zero where it does not matter. A silent unit is
    /// sent a request only where its whole time-out ends before any such time of a unit that is not silent, and before
    /// two thirds of the time after which an ordered unit stops by itself. This setting does not speed up the
    /// conversation.
    duration longest_gap{};
};

namespace detail {

/// How far the visits of a bus are since the request left.
enum class visit_stage : std::uint8_t {
    changing, ///< no request is under way, or it has not left
    settling, ///< all slots visit once in a pass that began with the request under way
    settled,  ///< they did, and what is known of silent slots and rests is theirs
};

/// What the client of a bus needs: a place for each slot, wherever one may be needed.
template <std::size_t Slots, auto const& Needs>
inline constexpr auto needs_of_bus = told_by<Needs>::template with<typename told_by<Needs>::observer>(Slots, Slots);

} // namespace detail

/// A client for `Slots` conversations. In each pass call `receive`, `sent` and `advance` as for a client; then
/// `converse` once for every slot in use, in the same order; then send what `poll_transmit` returns. Sleep no longer
/// than until `poll_deadline`. For the lifetimes of conversations see `basic_client`; a slot for which `converse` is
/// no longer called costs the others nothing, or its time-out once.
/// `Needs` is as for `basic_client`; a bus keeps orders and the quarantine of as many units as it has slots.
template <std::size_t Slots, auto const& Needs = usual_needs> class bus {
    static_assert(Slots > 0 and Slots < 0xFF, "a bus has 1 to 254 slots");
    using needed = detail::told_by<Needs>;
    using stage = detail::visit_stage;

public:
    /// The same, of which a sink takes the frames as they pass, from `trace_to(sink)` on.
    template <typename Sink> using traced_by = bus<Slots, detail::traced_needs<Needs, Sink>>;
    /// The same that counts: `bus<30>::observed_by<unit_statistics<30>>`.
    template <typename Counts> using observed_by = bus<Slots, detail::observed_needs<Needs, Counts>>;

    /// With these times and options, which are copied.
    explicit constexpr bus(line_timing const& its_line, client_options const& its_options = {},
                           bus_options const& share = {}) noexcept requires(not needed::is_fixed)
        : client_{its_line, its_options}
    {
        begin(its_options, share);
    }

    /// For needs with a `timing`.
    explicit constexpr bus(bus_options const& share = {}) noexcept requires(needed::is_fixed)
    {
        begin(Needs.options, share);
    }

    /// Sets how one slot's unit is treated. Slots from `Slots` on are ignored.
    constexpr void set(std::size_t index, slot_options const& options) noexcept
    {
        if (index < Slots) {
            slots_[index].options = options;
        }
    }

    /// As for a client.
    constexpr void receive(byte_view bytes, instant now) noexcept
    {
        client_.receive(bytes, now);
        is_idle_ = false;
    }
    constexpr void receive(std::same_as<std::byte> auto byte, instant now) noexcept
    {
        client_.receive(byte, now);
        is_idle_ = false;
    }
    constexpr void receive_error(instant now) noexcept
    {
        client_.receive_error(now);
        is_idle_ = false;
    }
    constexpr void sent(instant at) noexcept
    {
        client_.sent(at, [this](instant judged) { advance_slots(judged); });
        is_idle_ = false;
    }
    [[nodiscard]] constexpr line_timing const& line() const noexcept { return client_.line(); }

    constexpr void cancel(instant now) noexcept
    {
        client_.cancel(now, [this](instant judged) { advance_slots(judged); });
        is_idle_ = false;
    }
    constexpr void cancel(asker const& whose, instant now) noexcept
    {
        if (client_.is_asked_by(whose)) {
            cancel(now);
        }
    }
    constexpr void hold(unit_id unit, instant end) noexcept { client_.hold(unit, end); }
    [[nodiscard]] constexpr bool is_held(unit_id unit) const noexcept { return client_.is_held(unit); }
    [[nodiscard]] constexpr instant judged_at(instant now) const noexcept { return client_.judged_at(now); }
    [[nodiscard]] constexpr bool has_seen_echo() const noexcept { return client_.has_seen_echo(); }
    [[nodiscard]] constexpr byte_view poll_transmit() noexcept { return client_.poll_transmit(); }
    template <typename Sink>
        requires detail::is_traced_by<typename needed::observer, Sink>
    constexpr void trace_to(Sink& frames) noexcept { client_.trace_to(frames); }
    [[nodiscard]] constexpr std::optional<detail::refused_frame> refused() const noexcept { return client_.refused(); }

    /// Lets time pass.
    constexpr void advance(instant now) noexcept
    {
        is_urgent_ = false;
        advance_slots(client_.advance_within_reach(now));
    }

    /// Gives a slot's conversation its outcome, and takes its next request when it is its turn. While nobody
    /// `has_turn` it does nothing, except for a conversation that commands a motor or has a `poll_deadline`. One that had
    /// settled before says `used_already` from here on, as on a client.
    template <conversation Conversation>
    constexpr void converse(std::size_t index, Conversation& conversation, instant now) noexcept
    {
        if constexpr (not stays_awake<Conversation>) {
            if (is_idle_) {
                return;
            }
        }
        if (index < Slots) {
            visit_slot(index, detail::as_visited(conversation), now);
        }
    }

    /// Whether `converse` has anything to do in this pass, after `advance`. It has not while a response is awaited, all
    /// have visited since its request left, and none has a time of its own: then the loop may leave out the calls of
    /// `converse`. Those for a conversation that commands a motor, or has a `poll_deadline`, belong to every pass all
    /// the same; while one of them visits, this is always true.
    [[nodiscard]] constexpr bool has_turn() const noexcept { return not is_idle_; }

    /// The same for a conversation that comes before all slots, such as a stop of all units. Call it before
    /// `converse`; while it is not settled, and for a `stops_by_broadcast` one while it `is_urgent`, the slots send
    /// nothing.
    template <conversation Conversation> constexpr void run_urgent(Conversation& who, instant now) noexcept
    {
        static_assert(not detail::endless_conversation<Conversation>,
                      "this conversation never ends: no slot would ask behind it");
        auto& conversation = detail::as_visited(who);
        is_idle_ = false;
        stays_awake_ = stays_awake_ or stays_awake<Conversation> or not conversation.settled();
        static_cast<void>(client_.deliver(conversation, not conversation.settled(), now));
        client_.advance_and_note(conversation, now);
        is_urgent_ = is_urgent_ or (not conversation.settled() and is_urgent(conversation));
        wake_at(wake_of(conversation), now);
        if (not conversation.settled() and
            client_.ask(conversation, now, slots_[0].options.with) == detail::turn_result::asked) {
            asked_at_ = now; // a slot may get its outcome, where the conversation moved there
        }
    }

    /// Whether this bus ordered a unit to run, and no conversation that commands it has read since
    /// that its motor has no power. What a `watch` reads does not count.
    [[nodiscard]] constexpr bool is_ordered(unit_id unit) const noexcept
    {
        return client_.motor_orders().is_ordered(unit.byte());
    }

    /// Ends the hold of a stop that was given up before its end: its unit can be commanded again. Where none holds it
    /// nothing changes.
    constexpr void release(unit_id unit) noexcept { client_.release(unit); }
    /// The same for all units, where a stop of all units was given up.
    constexpr void release_all() noexcept { client_.release_all(); }

    /// When the next pass has something to do.
    [[nodiscard]] constexpr deadline poll_deadline() const noexcept
    {
        detail::earliest next;
        add_to(next);
        return next;
    }

    /// What was counted, where counting was asked for.
    [[nodiscard]] constexpr auto const& statistics() const noexcept { return client_.statistics(); }

    /// Whether a slot's unit counts as silent: see `bus_options`.
    [[nodiscard]] constexpr bool is_silent(std::size_t index) const noexcept
    {
        return index < Slots and is_silent(slots_[index]);
    }

private:
    struct slot {
        // Small processors reach bytes with short instructions only where they are near.
        std::uint8_t unit{0}; ///< of the last request; `failures` and `has_responded` are its
        std::uint8_t failures{0};
        bool is_resting{false};
        bool is_here{false};    ///< came by in this pass
        bool is_present{false}; ///< came by in this pass or the one before, not settled
        bool has_responded{false};
        instant not_before{0}; ///< the end of the rest
        instant last_asked{0};
        duration order_gap{}; ///< from one request to the next while its unit is ordered; 0: none
        slot_options options{};
    };

    constexpr void begin(client_options const& its_options, bus_options const& share) noexcept
    {
        constexpr std::uint8_t all = 100;
        std::uint8_t const wanted = share.silent_share;
        share_ = share;
        share_.silent_share = wanted == 0 ? std::uint8_t{1} : wanted < all ? wanted : all;
        for (slot& each : slots_) {
            each.options.with.response_timeout = its_options.response_timeout;
            each.options.with.retries = its_options.retries;
        }
    }

    // The visit of a slot.

    /// One visit of a conversation. Not inlined: a loop over slots has two instructions for each in an idle pass.
    template <typename Conversation>
    [[gnu::noinline]] constexpr void visit_slot(std::size_t index, Conversation& conversation, instant now) noexcept
    {
        slot& own = note_arrival(index, stays_awake<Conversation>, conversation.settled());
        bool const wants_turn = not conversation.settled() and not must_wait(conversation, index, now);
        if (auto const came = client_.deliver(conversation, wants_turn, now)) {
            note_health(own, *came, now);
        }
        client_.advance_and_note(conversation, now, not is_urgent_);
        own.order_gap = order_gap_of(conversation);
        wake_at(wake_of(conversation), now);
        detail::turn_result turn = detail::turn_result::waits;
        if (not must_wait(conversation, index, now)) {
            turn = client_.ask(conversation, now, own_retry_policy(own));
        }
        note_visit(index, turn, now);
    }

    [[gnu::noinline]] constexpr slot& note_arrival(std::size_t index, bool stays, bool is_settled) noexcept
    {
        slot& own = slots_[index];
        stays_awake_ = stays_awake_ or stays;
        own.is_here = true;
        own.is_present = not is_settled;
        return own;
    }

    /// Whether a conversation's request is a stop request: no rest and no probing holds it back.
    template <typename Conversation> static constexpr bool stops_now(Conversation const& conversation) noexcept
    {
        return conversation.intent() == detail::effect::stopping and not conversation.settled();
    }

    template <typename Conversation> static constexpr bool is_urgent(Conversation const& conversation) noexcept
    {
        if constexpr (detail::stops_by_broadcast<Conversation>) {
            return conversation.is_urgent();
        } else {
            return true;
        }
    }

    /// Whether a conversation must wait in its slot. A stop request need not wait, nor a broadcast that takes the power; a
    /// conversation that commands a motor does not wait because of another unit that was asked in this slot before.
    template <typename Conversation>
    constexpr bool must_wait(Conversation const& conversation, std::size_t index, instant now) noexcept
    {
        if (is_urgent_) {
            return true;
        }
        if constexpr (detail::commanding_conversation<Conversation>) {
            slot const& own = slots_[index];
            bool const is_new_here = conversation.unit().byte() != own.unit and not own.is_resting;
            if (stops_now(conversation) or is_new_here) {
                return false;
            }
        }
        return not detail::frees_all_units<Conversation> and must_wait(index, now);
    }

    /// A third of the drive's time-out is left for the turns of others after a probe.
    template <typename Conversation> constexpr duration order_gap_of(Conversation const& conversation) const noexcept
    {
        if constexpr (detail::commanding_conversation<Conversation>) {
            bool const is_ordered = client_.motor_orders().is_ordered(conversation.unit().byte());
            return is_ordered ? duration{detail::third_of(conversation.drive_timeout()).microseconds * 2} : duration{};
        } else {
            return {};
        }
    }

    // The passes: what the line does between them, and which of them are idle, so that no slot has to visit (rule 42 of
    // docs/engine-rules.md).

    /// Conversations that visit in every pass: their stops and their own times wait for nothing.
    template <typename Conversation>
    static constexpr bool stays_awake =
        detail::timed_conversation<Conversation> or std::derived_from<Conversation, detail::commander>;

    /// Lets time pass for the slots, after the client. Not inlined: GCC would keep `is_idle_` in a register from here on,
    /// one instruction more for each slot of an idle pass.
    [[gnu::noinline]] constexpr void advance_slots(instant now) noexcept
    {
        is_probe_limited_ = is_probe_limited_ and not reached(now, probe_at_);
        is_idle_ = may_idle(now);
        wake_ = {};
        if (is_idle_) {
            return;
        }
        for (slot& each : slots_) {
            each.is_resting = each.is_resting and not reached(now, each.not_before);
            each.is_present = each.is_present and (each.is_here or not is_new_pass_);
            each.is_here = each.is_here and not is_new_pass_;
        }
        is_new_pass_ = false;
        stays_awake_ = false;
    }

    /// A conversation of a slot has visited, and this became of its turn. Not inlined: it is called for each kind of
    /// conversation.
    [[gnu::noinline]] constexpr void note_visit(std::size_t index, detail::turn_result turn, instant now) noexcept
    {
        slot& own = slots_[index];
        if (turn == detail::turn_result::asked) {
            own.last_asked = now;
            asked_at_ = now;
            if (std::uint8_t const unit = client_.asked_unit(); unit != own.unit and unit != 0) {
                own.unit = unit;
                own.failures = 0;
                own.has_responded = false;
            }
        }
        if (turn != detail::turn_result::waits and is_silent(own)) {
            last_probed_ = index; // it had its turn
        }
        is_new_pass_ = true;
        is_idle_ = false;
        if (stage_ != stage::changing) {
            stage_ = client_.needs_no_visit() ? stage::settling : stage::changing;
        }
    }

    /// Adds the times of the slots.
    constexpr void add_to(detail::earliest& next) const noexcept
    {
        client_.add_to(next);
        next.add(wake_);
        if (is_probe_limited_) {
            next.add(probe_at_);
        }
        if (is_idle_) {
            next.add(rest_end_);
            return;
        }
        next.add(end_of_rests());
    }

    /// Whether the pass is idle: visits could change nothing but the marks of those that wait already (rule 42).
    constexpr bool may_idle(instant now) noexcept
    {
        if (not client_.needs_no_visit()) {
            stage_ = stage::changing;
            return false;
        }
        if (stage_ == stage::changing or not is_new_pass_ or stays_awake_ or wake_) {
            stage_ = stage::settling;
            return false;
        }
        if (stage_ == stage::settling) {
            has_silent_ = false;
            for (slot const& each : slots_) {
                has_silent_ = has_silent_ or is_silent(each);
            }
            rest_end_ = end_of_rests();
        }
        bool const is_due = (rest_end_ and reached(now, *rest_end_)) or (has_silent_ and not is_probe_limited_);
        stage_ = is_due ? stage::settling : stage::settled;
        return not is_due;
    }

    /// When the first of the slots that rest has rested. Also where `converse` is no longer called: a time that
    /// `advance` does not see lies ahead again when the clock has gone half way round.
    constexpr deadline end_of_rests() const noexcept
    {
        detail::earliest end;
        for (slot const& each : slots_) {
            if (each.is_resting) {
                end.add(each.not_before);
            }
        }
        return end;
    }

    // Silent units: which one is probed next, and what a probe costs the others.

    /// When a conversation has something to do by itself.
    template <typename Conversation> static constexpr deadline wake_of(Conversation const& conversation) noexcept
    {
        if constexpr (detail::timed_conversation<Conversation>) {
            return conversation.poll_deadline();
        } else {
            return {};
        }
    }

    /// Notes a time at which `converse` is to be called again for a conversation. One place is enough: `advance` ends all of
    /// these times, and those who visit then name theirs again.
    constexpr void wake_at(deadline const& next, instant now) noexcept { detail::keep_earlier(wake_, next, now); }

    constexpr void note_health(slot& own, errc error, instant now) noexcept
    {
        stage_ = stage::changing; // what it ended says so at its next visit
        own.not_before = now + own.options.least_idle;
        own.is_resting = own.options.least_idle.microseconds != 0;
        if (client_.asked_unit() == 0) {
            return; // no unit responds to a broadcast
        }
        if (error == errc::none or is_exception(error)) {
            own.failures = 0;
            own.has_responded = true;
        } else if (error != errc::cancelled) {
            own.failures = static_cast<std::uint8_t>(own.failures + (own.failures < 0xFF ? 1 : 0));
            charge(now - asked_at_, now);
        }
    }

    /// Delays the next request to a silent unit by the share of time that the others get for this loss of time.
    constexpr void charge(duration cost, instant now) noexcept
    {
        constexpr std::uint32_t longest_rest = 600'000'000;
        constexpr std::uint32_t longest = 1'800'000'000;
        std::uint32_t const others = 100U - share_.silent_share;
        std::uint32_t const part = detail::quotient(cost.microseconds, share_.silent_share) + 1;
        std::uint32_t rest = 0;
        for (std::uint32_t i = 0; i < others and rest < longest_rest; ++i) {
            rest = part < longest_rest - rest ? rest + part : longest_rest;
        }
        std::uint32_t const all = rest + (is_probe_limited_ ? (probe_at_ - asked_at_).microseconds : 0);
        probe_at_ = now + microseconds(all < longest ? all : longest);
        is_probe_limited_ = true;
    }

    constexpr bool is_silent(slot const& own) const noexcept
    {
        return own.failures != 0 and (own.failures >= share_.silent_after or not own.has_responded);
    }

    /// A request to a silent unit has no retries.
    [[gnu::noinline]] constexpr retry_policy own_retry_policy(slot const& own) const noexcept
    {
        retry_policy with = own.options.with;
        with.retries = is_silent(own) ? std::uint8_t{0} : with.retries;
        return with;
    }

    /// Whether a slot must wait; `wake_`, or a time that `poll_deadline` knows, then says until when.
    constexpr bool must_wait(std::size_t index, instant now) noexcept
    {
        slot& own = slots_[index];
        if (own.is_resting) {
            return true;
        }
        if (not is_silent(own)) {
            return false;
        }
        if (is_probe_limited_) {
            return true;
        }
        if (next_to_probe(index) == index and fits(index, now)) {
            return false;
        }
        // The other slot's conversation may settle later in this pass, or be gone in the next.
        wake_at(now + own.options.with.response_timeout, now);
        return true;
    }

    /// The silent slot whose turn it is: after the last one that was asked, the first for which `converse` is called;
    /// `own` is one of these.
    constexpr std::size_t next_to_probe(std::size_t own) const noexcept
    {
        std::size_t at = last_probed_;
        do {
            at = at + 1 == Slots ? 0 : at + 1;
        } while (at != own and not is_candidate(slots_[at]));
        return at;
    }

    constexpr bool is_candidate(slot const& each) const noexcept
    {
        return each.is_present and not each.is_resting and is_silent(each) and not client_.is_held(each.unit);
    }

    /// Whether the time-out of a silent unit ends before any other unit has to be asked. Other silent units do not
    /// count: two of them would wait for each other for ever.
    constexpr bool fits(std::size_t index, instant now) const noexcept
    {
        instant const end =
            now + slots_[index].options.with.response_timeout + client_.line().characters(2 * max_adu_size);
        for (std::size_t i = 0; i < Slots; ++i) {
            slot const& other = slots_[i];
            bool const matters = i != index and other.is_present and other.unit != 0 and not is_silent(other);
            if (matters and
                (is_before(other, other.options.longest_gap, end) or is_before(other, other.order_gap, end))) {
                return false;
            }
        }
        return true;
    }

    /// Whether a unit has to be asked before `end`, where it may wait no longer than `gap`. It may have been asked an
    /// hour ago.
    static constexpr bool is_before(slot const& other, duration gap, instant end) noexcept
    {
        return gap != duration{} and end - other.last_asked > gap;
    }

    // What is its own stands in front of the client: small processors reach near members with short instructions.
    bool is_idle_{false};          ///< nobody has a turn in this pass
    bool is_new_pass_{false};      ///< a slot's conversation visited since the latest pass that is not idle began
    bool stays_awake_{false};      ///< one that no pass leaves out visited since then
    bool has_silent_{false};       ///< in an idle pass: a slot is silent
    bool is_probe_limited_{false}; ///< silent slots wait until `probe_at_`
    bool is_urgent_{false};        ///< one of `run_urgent` keeps the slots from asking, in this pass
    detail::visit_stage stage_{detail::visit_stage::changing};
    instant asked_at_{0};
    instant probe_at_{0};
    deadline wake_{};     ///< the first of the conversations' times
    deadline rest_end_{}; ///< in an idle pass: of the slots that rest
    bus_options share_{};
    std::size_t last_probed_{Slots - 1};
    std::array<slot, Slots> slots_{detail::filled<Slots>(slot{})};
    basic_client<detail::needs_of_bus<Slots, Needs>> client_;
};

} // namespace RTUWIRE_BUILD
} // namespace rtuwire
