// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// Many conversations on one line, taking turns question by question. A unit that does not answer is asked
// again only now and then, each silent one in its turn, so that all of them together cost the others no more
// than a share of the line.
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
    /// How much of the line's time all silent units together may cost, in percent, 1 to 100; what lies outside
    /// counts as the nearer of the two.
    std::uint8_t silent_share{10};
    /// After how many questions without an answer a unit counts as silent; one that never answered, after one.
    std::uint8_t silent_after{2};
};

/// How a bus treats one unit.
struct slot_options {
    patience with{};
    /// From the end of a transaction with this unit to the next question to it.
    duration least_idle{};
    /// From one question to this unit to the next, at most; zero where it does not matter. A silent unit is asked
    /// only where its whole time-out ends before any such time of a unit that is not, and before two thirds of the time
    /// after which an ordered unit stops by itself. It does not speed up the conversation.
    duration longest_gap{};
};

/// A client for `Slots` conversations. In each pass call `receive`, `sent` and `advance` as for a
/// client; then `converse` once for every slot in use, in the same order; then send what `poll_transmit`
/// gives. Sleep no longer than `poll_deadline` says. For the lifetimes of conversations see `basic_client`; a
/// slot that nobody calls `converse` for any more costs the others nothing, or its time-out once.
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

    constexpr void receive(byte_view octets, instant now) noexcept { client_.receive(octets, now); }
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

    /// Hands a slot's conversation its outcome, and lets it ask when it is its turn.
    template <conversation Talk>
    constexpr void converse(std::size_t index, Talk& talk, instant now) noexcept
    {
        if (index >= Slots) {
            return;
        }
        slot& own = slots_[index];
        is_new_pass_ = true;
        own.is_here = true;
        own.is_present = not talk.settled();
        bool const wants_turn = not talk.settled() and not is_urgent_ and
                                not is_held_back(talk, index, now);
        if (errc const came = client_.deliver(talk, wants_turn, now); came != errc::pending) {
            note_health(own, came, now);
        }
        advance_talk(talk, now);
        client_.command(talk, now);
        own.order_gap = order_gap_of(talk);
        wake_at(own.wake, wake_of(talk), now);
        if (is_urgent_ or is_held_back(talk, index, now)) {
            return;
        }
        if (errc const asked = client_.ask(talk, now, own_patience(own)); asked != errc::none) {
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
            own.has_answered = false;
        }
        last_probed_ = is_silent(own) ? index : last_probed_;
    }

    /// The same for a conversation that comes before all slots: one that stops everyone. To be called before theirs; while
    /// it is not settled, or as long as it says that it is urgent, they ask nothing.
    template <conversation Talk> constexpr void converse_first(Talk& talk, instant now) noexcept
    {
        static_assert(not endless_conversation<Talk>, "this conversation never ends: no slot would ask behind it");
        static_cast<void>(client_.deliver(talk, not talk.settled(), now));
        advance_talk(talk, now);
        client_.command(talk, now);
        is_urgent_ = not talk.settled() and is_urgent(talk);
        wake_at(urgent_wake_, wake_of(talk), now);
        if (not talk.settled() and client_.ask(talk, now, slots_[0].options.with) == errc::none) {
            asked_at_ = now; // a slot may be told, where the conversation moved there
        }
    }

    /// As for a client.
    constexpr void cancel(instant now) noexcept { client_.cancel(now); }
    constexpr void cancel(asker const& whose, instant now) noexcept { client_.cancel(whose, now); }
    constexpr void hold(unit_id unit, instant end) noexcept { client_.hold(unit, end); }
    [[nodiscard]] constexpr bool is_held(unit_id unit) const noexcept { return client_.is_held(unit); }
    [[nodiscard]] constexpr byte_view poll_transmit() noexcept { return client_.poll_transmit(); }

    /// Whether this bus ordered a unit to run, and nobody has read since that it does not.
    [[nodiscard]] constexpr bool is_ordered(unit_id unit) const noexcept
    {
        return client_.motor_orders().is_ordered(unit.octet());
    }

    /// Lets a unit be commanded again that a stop holds which was given up before its end.
    constexpr void release(unit_id unit) noexcept { client_.release(unit); }
    /// The same for all units, where a stop of everyone was given up.
    constexpr void release_all() noexcept { client_.release_all(); }

    /// When the next pass has something to do.
    [[nodiscard]] constexpr deadline poll_deadline() const noexcept
    {
        earliest next;
        client_.add_to(next);
        for (slot const& each : slots_) {
            next.add(each.wake);
            // Also where nobody comes by any more: a time that `advance` does not see is ahead again when the clock
            // has gone half way round.
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
    [[nodiscard]] constexpr Statistics const& statistics() const noexcept
    {
        return client_.statistics();
    }

    /// Whether a slot's unit has not answered for some questions.
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
        duration order_gap{}; ///< from one question to the next while its unit is ordered; 0: none
        std::uint8_t unit{0}; ///< the one asked last; health is its
        std::uint8_t failures{0};
        bool is_resting{false};
        bool is_here{false};    ///< came by in this pass
        bool is_present{false}; ///< came by in this pass or the one before, not settled
        bool has_answered{false};
    };

    template <typename Talk> static constexpr deadline wake_of(Talk const& talk) noexcept
    {
        if constexpr (timed_conversation<Talk>) {
            return talk.poll_deadline();
        } else {
            return {};
        }
    }

    /// Whether a conversation's question is a word that stops: no rest and no probing holds it back.
    template <typename Talk> static constexpr bool stops_now(Talk const& talk) noexcept
    {
        return talk.intent() == effect::stopping and not talk.settled();
    }

    template <typename Talk> static constexpr bool is_urgent(Talk const& talk) noexcept
    {
        if constexpr (stops_everyone<Talk>) {
            return talk.is_urgent();
        } else {
            return true;
        }
    }

    /// Notes a time at which a conversation is to come by again; a time that has come needs no note, because it
    /// is here.
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
            return; // nobody answers a broadcast
        }
        if (error == errc::none or is_exception(error)) {
            own.failures = 0;
            own.has_answered = true;
        } else if (error != errc::cancelled) {
            own.failures = static_cast<std::uint8_t>(own.failures + (own.failures < 0xFF ? 1 : 0));
            charge(now - asked_at_, now);
        }
    }

    /// Puts the next question to a silent unit off by what the others get for this loss of time.
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
        return own.failures != 0 and (own.failures >= share_.silent_after or not own.has_answered);
    }

    /// A silent unit is asked without repetitions.
    constexpr patience own_patience(slot const& own) const noexcept
    {
        patience with = own.options.with;
        with.retries = is_silent(own) ? std::uint8_t{0} : with.retries;
        return with;
    }

    /// Whether a conversation must wait in its slot. A word that stops does not, and who commands a motor does not for
    /// the health of another unit, which was asked in this slot before.
    template <typename Talk>
    constexpr bool is_held_back(Talk const& talk, std::size_t index, instant now) noexcept
    {
        if constexpr (commanding_conversation<Talk>) {
            slot const& own = slots_[index];
            bool const is_new_here = talk.unit().octet() != own.unit and not own.is_resting;
            if (stops_now(talk) or is_new_here) {
                return false;
            }
        }
        return is_held_back(index, now);
    }

    /// Whether a slot must wait; its wake-up, or a time that `poll_deadline` knows, then says until when.
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
        // The other one may be settled behind this one in the same pass, or gone in the next.
        wake_at(own.wake, now + own.options.with.response_timeout, now);
        return true;
    }

    /// The silent slot whose turn it is: the first that somebody calls `converse` for, behind the last that was
    /// asked; `own` is one.
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
        return each.is_present and not each.is_resting and is_silent(each) and
               not client_.is_held(each.unit);
    }

    /// Whether the time-out of a silent unit is over before any other unit has to be asked. A silent one does not
    /// have to: two of them would wait for each other for ever.
    constexpr bool fits(std::size_t index, instant now) const noexcept
    {
        instant const end = now + slots_[index].options.with.response_timeout +
                            line().characters(2 * max_adu_size);
        for (std::size_t i = 0; i < Slots; ++i) {
            slot const& other = slots_[i];
            bool const matters = i != index and other.is_present and other.unit != 0 and
                                 not is_silent(other);
            if (matters and (is_before(other, other.options.longest_gap, end) or
                             is_before(other, other.order_gap, end))) {
                return false;
            }
        }
        return true;
    }

    /// Whether a unit has to be asked before `end`, where it may not wait for longer than this.
    static constexpr bool is_before(slot const& other, duration gap, instant end) noexcept
    {
        return gap != duration{} and not reached(other.last_asked + gap, end);
    }

    /// A third is left for the turns of others behind a probe.
    template <typename Talk> constexpr duration order_gap_of(Talk const& talk) const noexcept
    {
        if constexpr (commanding_conversation<Talk>) {
            bool const is_ordered = client_.motor_orders().is_ordered(talk.unit().octet());
            return is_ordered ? duration{talk.drive_timeout().microseconds / 3 * 2} : duration{};
        } else {
            return {};
        }
    }

    basic_client<Statistics, held<line_timing>, held<client_options>, quarantine<Slots>, shared_memory,
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
