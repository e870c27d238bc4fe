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
#include <rtuwire/client/slot/bus_slots.hpp>
#include <rtuwire/core/time.hpp>
#include <rtuwire/core/version.hpp>

namespace rtuwire::inline RTUWIRE_BUILD {

/// A client for `Slots` conversations. In each pass call `receive`, `sent` and `advance` as for a client; then
/// `converse` once for every slot in use, in the same order; then send what `poll_transmit` returns. Sleep no longer
/// than until `poll_deadline`. For the lifetimes of conversations see `basic_client`; a slot for which `converse` is
/// no longer called costs the others nothing, or its time-out once.
template <std::size_t Slots, typename Statistics = no_statistics> class bus : bus_slots<Slots, Statistics> {
    static_assert(Slots > 0 and Slots < 0xFF, "a bus has 1 to 254 slots");
    using places = bus_slots<Slots, Statistics>;
    using places::asked_at_;
    using places::client_;
    using places::is_probe_limited_;
    using places::last_probed_;
    using places::probe_at_;
    using places::slots_;
    using places::wake_at;
    using typename places::slot;

public:
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

    constexpr void receive(byte_view bytes, instant now) noexcept { client_.receive(bytes, now); }
    constexpr void receive(std::same_as<std::byte> auto byte, instant now) noexcept { client_.receive(byte, now); }
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
        if (auto const came = client_.deliver(conversation, wants_turn, now)) {
            places::note_health(own, *came, now);
        }
        advance_conversation(conversation, now);
        client_.command(conversation, now);
        own.order_gap = order_gap_of(conversation);
        wake_at(own.wake, places::wake_of(conversation), now);
        if (is_urgent_ or is_held_back(conversation, index, now)) {
            return;
        }
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
        wake_at(urgent_wake_, places::wake_of(conversation), now);
        if (not conversation.settled() and
            client_.ask(conversation, now, slots_[0].options.with) == turn_result::asked) {
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
        return index < Slots and places::is_silent(slots_[index]);
    }

private:
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
    bool is_new_pass_{false}; ///< somebody came by since the last `advance`
    deadline urgent_wake_{};
};

} // namespace rtuwire
