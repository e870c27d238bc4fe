// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// The passes of a bus: what the line does between them, and which of them are idle, so that no slot has to visit (rule 42 of
// docs/engine-rules.md).
// Internal: may change with any version.
#pragma once

#include <concepts>
#include <cstddef>
#include <cstdint>
#include <optional>

#include <rtuwire/ask/commander.hpp>
#include <rtuwire/client/slot/bus_slots.hpp>
#include <rtuwire/core/bytes.hpp>
#include <rtuwire/core/time.hpp>
#include <rtuwire/core/version.hpp>
#include <rtuwire/trace/tracing.hpp>
#include <rtuwire/wire/unit_id.hpp>

namespace rtuwire::inline RTUWIRE_BUILD {

/// The line of a bus and the time that passes; the base of `bus`.
template <std::size_t Slots, typename Statistics> class bus_passes : protected bus_slots<Slots, Statistics> {
protected:
    using places = bus_slots<Slots, Statistics>;
    using bus_state::has_silent_;
    using bus_state::is_idle_;
    using bus_state::is_new_pass_;
    using bus_state::is_probe_limited_;
    using bus_state::probe_at_;
    using bus_state::rest_end_;
    using stage = visit_stage;
    using bus_state::stage_;
    using bus_state::stays_awake_;
    using bus_state::wake_;
    using places::client_;
    using places::slots_;
    using typename places::slot;

public:
    using places::places;

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
        client_.sent(at);
        is_idle_ = false;
    }
    [[nodiscard]] constexpr line_timing const& line() const noexcept { return client_.line(); }

    constexpr void cancel(instant now) noexcept
    {
        client_.cancel(now);
        is_idle_ = false;
    }
    constexpr void cancel(asker const& whose, instant now) noexcept
    {
        client_.cancel(whose, now);
        is_idle_ = false;
    }
    constexpr void hold(unit_id unit, instant end) noexcept { client_.hold(unit, end); }
    [[nodiscard]] constexpr bool is_held(unit_id unit) const noexcept { return client_.is_held(unit); }
    [[nodiscard]] constexpr bool has_seen_echo() const noexcept { return client_.has_seen_echo(); }
    [[nodiscard]] constexpr byte_view poll_transmit() noexcept { return client_.poll_transmit(); }
    template <typename Sink>
        requires is_traced_by<Statistics, Sink>
    constexpr void trace_to(Sink& frames) noexcept { client_.trace_to(frames); }
    [[nodiscard]] constexpr std::optional<refused_frame> refused() const noexcept { return client_.refused(); }

protected:
    /// Conversations that visit in every pass: their stops and their own times wait for nothing.
    template <typename Conversation>
    static constexpr bool stays_awake = timed_conversation<Conversation> or std::derived_from<Conversation, commander>;

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

    /// A conversation of a slot has visited: it may rest from here on, or have asked. Not inlined: it is called for each
    /// kind of conversation.
    [[gnu::noinline]] constexpr void note_visit() noexcept
    {
        is_new_pass_ = true;
        is_idle_ = false;
        if (stage_ != stage::changing) {
            stage_ = client_.needs_no_visit() ? stage::settling : stage::changing;
        }
    }

    /// Adds the times of the slots.
    constexpr void add_to(earliest& next) const noexcept
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

private:
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
                has_silent_ = has_silent_ or places::is_silent(each);
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
        earliest end;
        for (slot const& each : slots_) {
            if (each.is_resting) {
                end.add(each.not_before);
            }
        }
        return end;
    }
};

} // namespace rtuwire
