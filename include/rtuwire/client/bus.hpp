// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// Many conversations on one line, taking turns request by request. A unit that does not respond is sent a request only
// now and then, one such unit after the other, so that all of them together cost the others no more than a share of
// the line.
#pragma once

#include <concepts>
#include <cstddef>
#include <cstdint>

#include <rtuwire/ask/commander.hpp>
#include <rtuwire/client/slot/bus_options.hpp>
#include <rtuwire/client/slot/bus_passes.hpp>
#include <rtuwire/core/time.hpp>
#include <rtuwire/core/version.hpp>
#include <rtuwire/trace/tracing.hpp>

namespace rtuwire::inline RTUWIRE_BUILD {

/// A client for `Slots` conversations. In each pass call `receive`, `sent` and `advance` as for a client; then
/// `converse` once for every slot in use, in the same order; then send what `poll_transmit` returns. Sleep no longer
/// than until `poll_deadline`. For the lifetimes of conversations see `basic_client`; a slot for which `converse` is
/// no longer called costs the others nothing, or its time-out once.
template <std::size_t Slots, typename Statistics = no_statistics> class bus : bus_passes<Slots, Statistics> {
    static_assert(Slots > 0 and Slots < 0xFF, "a bus has 1 to 254 slots");
    using places = bus_passes<Slots, Statistics>;
    using places::asked_at_;
    using places::client_;
    using places::is_idle_;
    using places::last_probed_;
    using places::slots_;
    using places::stays_awake_;
    using places::wake_at;
    using typename places::slot;

public:
    /// The same, of which a sink takes the frames as they pass, from `trace_to(sink)` on.
    template <frame_sink Sink> using traced_by = bus<Slots, tracing<Sink, Statistics>>;

    explicit constexpr bus(line_timing const& its_line, client_options const& its_options = {},
                           bus_options const& share = {}) noexcept
        : places{its_line, its_options, share}
    {}

    /// Sets how one slot's unit is treated. Slots from `Slots` on are ignored.
    constexpr void set(std::size_t index, slot_options const& options) noexcept
    {
        if (index < Slots) {
            slots_[index].options = options;
        }
    }

    /// As for a client.
    using places::cancel, places::has_seen_echo, places::hold, places::is_held, places::line, places::poll_transmit,
        places::receive, places::receive_error, places::refused, places::sent, places::trace_to;

    /// Lets time pass.
    constexpr void advance(instant now) noexcept
    {
        is_urgent_ = false;
        places::advance_slots(client_.advance_within_reach(now));
    }

    /// Gives a slot's conversation its outcome, and takes its next request when it is its turn. While nobody
    /// `has_turn` it does nothing, except for a conversation that commands a motor or has a `poll_deadline`. One that had
    /// settled before says `used_already` from here on, as on a client.
    template <conversation Conversation>
    constexpr void converse(std::size_t index, Conversation& conversation, instant now) noexcept
    {
        if constexpr (not places::template stays_awake<Conversation>) {
            if (is_idle_) {
                return;
            }
        }
        if (index < Slots) {
            visit(index, conversation, now);
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
    template <conversation Conversation> constexpr void run_urgent(Conversation& conversation, instant now) noexcept
    {
        static_assert(not endless_conversation<Conversation>,
                      "this conversation never ends: no slot would ask behind it");
        is_idle_ = false;
        stays_awake_ = stays_awake_ or places::template stays_awake<Conversation> or not conversation.settled();
        static_cast<void>(client_.deliver(conversation, not conversation.settled(), now));
        client_.command(conversation, now);
        is_urgent_ = not conversation.settled() and is_urgent(conversation);
        wake_at(places::wake_of(conversation), now);
        if (not conversation.settled() and
            client_.ask(conversation, now, slots_[0].options.with) == turn_result::asked) {
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
        earliest next;
        places::add_to(next);
        return next;
    }

    /// What was counted, where counting was asked for.
    [[nodiscard]] constexpr counted_by<Statistics> const& statistics() const noexcept { return client_.statistics(); }

    /// Whether a slot's unit counts as silent: see `bus_options`.
    [[nodiscard]] constexpr bool is_silent(std::size_t index) const noexcept
    {
        return index < Slots and places::is_silent(slots_[index]);
    }

private:
    /// One visit of a conversation. Not inlined: a loop over slots has two instructions for each in an idle pass.
    template <typename Conversation>
    [[gnu::noinline]] constexpr void visit(std::size_t index, Conversation& conversation, instant now) noexcept
    {
        slot& own = slots_[index];
        stays_awake_ = stays_awake_ or places::template stays_awake<Conversation>;
        own.is_here = true;
        own.is_present = not conversation.settled();
        bool const wants_turn =
            not conversation.settled() and not is_urgent_ and not is_held_back(conversation, index, now);
        if (auto const came = client_.deliver(conversation, wants_turn, now)) {
            places::note_health(own, *came, now);
        }
        client_.command(conversation, now, not is_urgent_);
        own.order_gap = order_gap_of(conversation);
        wake_at(places::wake_of(conversation), now);
        if (not is_urgent_ and not is_held_back(conversation, index, now)) {
            ask(index, conversation, now);
        }
        places::note_visit();
    }

    template <typename Conversation>
    constexpr void ask(std::size_t index, Conversation& conversation, instant now) noexcept
    {
        slot& own = slots_[index];
        turn_result const turn = client_.ask(conversation, now, places::own_retry_policy(own));
        if (turn != turn_result::asked) {
            if (turn != turn_result::waits) {
                last_probed_ = places::is_silent(own) ? index : last_probed_; // it had its turn
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
        last_probed_ = places::is_silent(own) ? index : last_probed_;
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
        return places::is_held_back(index, now);
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

    bool is_urgent_{false};
};

} // namespace rtuwire
