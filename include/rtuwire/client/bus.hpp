// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// Many conversations on one line, taking turns request by request. A unit that does not respond is sent a request only
// now and then, one such unit after the other, so that all of them together cost the others no more than a share of
// the line.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include <rtuwire/client/client.hpp>
#include <rtuwire/core/filled.hpp>
#include <rtuwire/core/version.hpp>

namespace rtuwire::inline RTUWIRE_BUILD {

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
    /// The least time from the end of a transaction with this unit to the next request to it.
    duration least_idle{};
    /// The longest time from one request to this unit to the next; zero where it does not matter. A silent unit is
    /// sent a request only where its whole time-out ends before any such time of a unit that is not silent, and before
    /// two thirds of the time after which an ordered unit stops by itself. This setting does not speed up the
    /// conversation.
    duration longest_gap{};
};

/// A client for `Slots` conversations. In each pass call `receive`, `sent` and `advance` as for a client; then
/// `converse` once for every slot in use, in the same order; then send what `poll_transmit` returns. Sleep no longer
/// than until `poll_deadline`. For the lifetimes of conversations see `basic_client`; a slot for which `converse` is
/// no longer called costs the others nothing, or its time-out once.
template <std::size_t Slots, typename Statistics = no_statistics> class bus {
    static_assert(Slots > 0 and Slots < 0xFF, "a bus has 1 to 254 slots");

public:
    explicit constexpr bus(line_timing const& line, client_options const& options = {},
                           bus_options const& share = {}) noexcept
        : client_{line, options}, share_{share}
    {
        constexpr std::uint8_t all = 100;
        std::uint8_t const wanted = share.silent_share;
        share_.silent_share = wanted == 0 ? std::uint8_t{1} : wanted < all ? wanted : all;
        for (slot& each : slots_) {
            each.options.with.response_timeout = options.response_timeout;
            each.options.with.retries = options.retries;
        }
    }

    /// Sets how one slot's unit is treated. Slots from `Slots` on are ignored.
    constexpr void set(std::size_t index, slot_options const& options) noexcept
    {
        if (index < Slots) {
            slots_[index].options = options;
        }
    }

    constexpr void receive(byte_view bytes, instant now) noexcept { client_.receive(bytes, now); }
    constexpr void receive_error(instant now) noexcept { client_.receive_error(now); }
    constexpr void sent(instant at) noexcept { client_.sent(at); }
    [[nodiscard]] constexpr line_timing const& line() const noexcept { return client_.line(); }

    /// Lets time pass.
    constexpr void advance(instant now) noexcept
    {
        for (slot& each : slots_) {
            each.is_resting = each.is_resting and not reached(now, each.not_before);
            each.is_present = each.is_present and (each.is_here or not is_new_pass_);
            each.is_here = each.is_here and not is_new_pass_;
            each.wake = {};
        }
        is_new_pass_ = false;
        is_probe_limited_ = is_probe_limited_ and not reached(now, probe_at_);
        is_urgent_ = false;
        urgent_wake_ = {};
        client_.advance(now);
    }

    /// Gives a slot's conversation its outcome, and takes its next request when it is its turn.
    template <conversation Conversation>
    constexpr void converse(std::size_t index, Conversation& conversation, instant now) noexcept
    {
        if (index >= Slots) {
            return;
        }
        slot& own = slots_[index];
        is_new_pass_ = true;
        own.is_here = true;
        own.is_present = not conversation.settled();
        bool const wants_turn =
            not conversation.settled() and not is_urgent_ and not is_held_back(conversation, index, now);
        if (errc const came = client_.deliver(conversation, wants_turn, now); came != errc::pending) {
            note_health(own, came, now);
        }
        advance_conversation(conversation, now);
        client_.command(conversation, now);
        own.order_gap = order_gap_of(conversation);
        wake_at(own.wake, wake_of(conversation), now);
        if (is_urgent_ or is_held_back(conversation, index, now)) {
            return;
        }
        if (errc const asked = client_.ask(conversation, now, own_retry_policy(own)); asked != errc::none) {
            if (asked != errc::busy) {
                last_probed_ = is_silent(own) ? index : last_probed_; // it had its turn
            }
            return;
        }
        own.last_asked = now;
        asked_at_ = now;
        if (std::uint8_t const unit = client_.asked_unit(); unit != own.unit and unit != 0) {
            own.unit = unit;
            own.failures = 0;
            own.has_responded = false;
        }
        last_probed_ = is_silent(own) ? index : last_probed_;
    }

    /// The same for a conversation that comes before all slots, such as a stop of all units. Call it before
    /// `converse`; while it is not settled, and for a `stops_by_broadcast` one while it `is_urgent`, the slots send
    /// nothing.
    template <conversation Conversation> constexpr void run_urgent(Conversation& conversation, instant now) noexcept
    {
        static_assert(not endless_conversation<Conversation>,
                      "this conversation never ends: no slot would ask behind it");
        static_cast<void>(client_.deliver(conversation, not conversation.settled(), now));
        advance_conversation(conversation, now);
        client_.command(conversation, now);
        is_urgent_ = not conversation.settled() and is_urgent(conversation);
        wake_at(urgent_wake_, wake_of(conversation), now);
        if (not conversation.settled() and client_.ask(conversation, now, slots_[0].options.with) == errc::none) {
            asked_at_ = now; // a slot may get its outcome, where the conversation moved there
        }
    }

    /// As for a client.
    constexpr void cancel(instant now) noexcept { client_.cancel(now); }
    constexpr void cancel(asker const& whose, instant now) noexcept { client_.cancel(whose, now); }
    constexpr void hold(unit_id unit, instant end) noexcept { client_.hold(unit, end); }
    [[nodiscard]] constexpr bool is_held(unit_id unit) const noexcept { return client_.is_held(unit); }
    [[nodiscard]] constexpr byte_view poll_transmit() noexcept { return client_.poll_transmit(); }

    /// Whether this bus ordered a unit to run, and no conversation has read since that its motor has no power.
    [[nodiscard]] constexpr bool is_ordered(unit_id unit) const noexcept
    {
        return client_.motor_orders().is_ordered(unit.byte());
    }

    /// Ends the hold of a stop that was given up before its end: its unit can be commanded again.
    constexpr void release(unit_id unit) noexcept { client_.release(unit); }
    /// The same for all units, where a stop of all units was given up.
    constexpr void release_all() noexcept { client_.release_all(); }

    /// When the next pass has something to do.
    [[nodiscard]] constexpr deadline poll_deadline() const noexcept
    {
        earliest next;
        client_.add_to(next);
        for (slot const& each : slots_) {
            next.add(each.wake);
            // Also where `converse` is no longer called: a time that `advance` does not see lies ahead again when the
            // clock has gone half way round.
            if (each.is_resting) {
                next.add(each.not_before);
            }
        }
        if (is_probe_limited_) {
            next.add(probe_at_);
        }
        next.add(urgent_wake_);
        return next;
    }

    /// What was counted, where counting was asked for.
    [[nodiscard]] constexpr Statistics const& statistics() const noexcept { return client_.statistics(); }

    /// Whether a slot's unit counts as silent: see `bus_options`.
    [[nodiscard]] constexpr bool is_silent(std::size_t index) const noexcept
    {
        return index < Slots and is_silent(slots_[index]);
    }

private:
    struct slot {
        slot_options options{};
        instant not_before{0}; ///< the end of the rest
        instant last_asked{0};
        deadline wake{};
        duration order_gap{}; ///< from one request to the next while its unit is ordered; 0: none
        std::uint8_t unit{0}; ///< of the last request; `failures` and `has_responded` are its
        std::uint8_t failures{0};
        bool is_resting{false};
        bool is_here{false};    ///< came by in this pass
        bool is_present{false}; ///< came by in this pass or the one before, not settled
        bool has_responded{false};
    };

    template <typename Conversation> static constexpr deadline wake_of(Conversation const& conversation) noexcept
    {
        if constexpr (timed_conversation<Conversation>) {
            return conversation.poll_deadline();
        } else {
            return {};
        }
    }

    /// Whether a conversation's request is a stop request: no rest and no probing holds it back.
    template <typename Conversation> static constexpr bool stops_now(Conversation const& conversation) noexcept
    {
        return conversation.intent() == effect::stopping and not conversation.settled();
    }

    template <typename Conversation> static constexpr bool is_urgent(Conversation const& conversation) noexcept
    {
        if constexpr (stops_by_broadcast<Conversation>) {
            return conversation.is_urgent();
        } else {
            return true;
        }
    }

    /// Notes a time at which `converse` is to be called again for a conversation; a time that has come needs no note,
    /// because this is that call.
    static constexpr void wake_at(deadline& wake, deadline const& next, instant now) noexcept
    {
        if (next and not reached(now, *next) and not(wake and reached(*next, *wake))) {
            wake = *next;
        }
    }

    constexpr void note_health(slot& own, errc error, instant now) noexcept
    {
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
        std::uint32_t const part = cost.microseconds / share_.silent_share + 1;
        std::uint32_t const rest = others == 0 or part <= longest_rest / others ? part * others : longest_rest;
        std::uint32_t const all = rest + (is_probe_limited_ ? (probe_at_ - asked_at_).microseconds : 0);
        probe_at_ = now + microseconds(all < longest ? all : longest);
        is_probe_limited_ = true;
    }

    constexpr bool is_silent(slot const& own) const noexcept
    {
        return own.failures != 0 and (own.failures >= share_.silent_after or not own.has_responded);
    }

    /// A request to a silent unit has no retries.
    constexpr retry_policy own_retry_policy(slot const& own) const noexcept
    {
        retry_policy with = own.options.with;
        with.retries = is_silent(own) ? std::uint8_t{0} : with.retries;
        return with;
    }

    /// Whether a conversation must wait in its slot. A stop request need not wait; a conversation that commands a
    /// motor does not wait because of another unit that was asked in this slot before.
    template <typename Conversation>
    constexpr bool is_held_back(Conversation const& conversation, std::size_t index, instant now) noexcept
    {
        if constexpr (commanding_conversation<Conversation>) {
            slot const& own = slots_[index];
            bool const is_new_here = conversation.unit().byte() != own.unit and not own.is_resting;
            if (stops_now(conversation) or is_new_here) {
                return false;
            }
        }
        return is_held_back(index, now);
    }

    /// Whether a slot must wait; its `wake`, or a time that `poll_deadline` knows, then says until when.
    constexpr bool is_held_back(std::size_t index, instant now) noexcept
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
        wake_at(own.wake, now + own.options.with.response_timeout, now);
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
        instant const end = now + slots_[index].options.with.response_timeout + line().characters(2 * max_adu_size);
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

    /// Whether a unit has to be asked before `end`, where it may wait no longer than `gap`.
    static constexpr bool is_before(slot const& other, duration gap, instant end) noexcept
    {
        return gap != duration{} and not reached(other.last_asked + gap, end);
    }

    /// A third of the drive's time-out is left for the turns of others after a probe.
    template <typename Conversation> constexpr duration order_gap_of(Conversation const& conversation) const noexcept
    {
        if constexpr (commanding_conversation<Conversation>) {
            bool const is_ordered = client_.motor_orders().is_ordered(conversation.unit().byte());
            return is_ordered ? duration{conversation.drive_timeout().microseconds / 3 * 2} : duration{};
        } else {
            return {};
        }
    }

    basic_client<Statistics, stored<line_timing>, stored<client_options>, quarantine<Slots>, shared_memory,
                 orders<Slots>>
        client_;
    bus_options share_;
    std::array<slot, Slots> slots_{filled<Slots>(slot{})};
    deadline urgent_wake_{};
    instant asked_at_{0};
    instant probe_at_{0};
    std::size_t last_probed_{Slots - 1};
    bool is_probe_limited_{false};
    bool is_urgent_{false};
    bool is_new_pass_{false}; ///< somebody came by since the last `advance`
};

} // namespace rtuwire
