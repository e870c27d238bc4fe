// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// Internal: the states of a framer and what silence does to them: when the line was last active, whether it has been
// silent long enough to send since, and when silence ends a frame. Knows no byte of it. The table is in rtu/frame_cutter.hpp.
#pragma once

#include <cstddef>
#include <cstdint>

#include <rtuwire/core/time.hpp>
#include <rtuwire/core/version.hpp>
#include <rtuwire/rtu/line.hpp>
#include <rtuwire/wire/frame_length.hpp>
#include <rtuwire/wire/limits.hpp>

namespace rtuwire::inline RTUWIRE_BUILD::detail {

/// Internal: the base of the frame cutter. `Holder` derives from both and holds the line's times, `line_`.
template <typename Holder, direction Way> class line_silence {
public:
    /// Takes note of `bytes` bytes, one at least, that had arrived by `now`. Returns whether the silence before them
    /// ended a frame, whole or damaged, which must be polled before the first byte is taken.
    constexpr bool begin_chunk(std::size_t bytes, instant now) noexcept
    {
        // An unread frame is discarded, so receiving never stalls.
        if (state_ == state::done) {
            state_ = state::idle;
        }
        // The first byte of a chunk arrived earlier than the chunk was handed over.
        instant const at = within_reach_of_line(now);
        if (activity_ != activity::unknown and reached(at, last_ + end_silence() + line().characters(bytes))) {
            on_silence();
        }
        keep_activity(now, at);
        return state_ == state::done;
    }

    /// Applies the silence up to `now`. Must be called before the clock has run 35 minutes past a deadline.
    constexpr void advance(instant now) noexcept
    {
        if (activity_ == activity::unknown) {
            note_activity(now);
        }
        instant const at = within_reach_of_line(now);
        if (reached(at, last_ + line().silence())) {
            activity_ = activity::quiet;
        }
        if (ends_by_silence() and reached(at, last_ + end_silence())) {
            on_silence();
        }
    }

    /// The time by which what was in force at the latest activity is judged `now`: that may be the end of a frame that is
    /// being sent.
    [[nodiscard]] constexpr instant within_reach_of_line(instant now) const noexcept
    {
        constexpr duration latency = milliseconds(100); // of what sends it
        return within_reach(last_, now, line().characters(max_adu_size) + latency);
    }

    /// Adds the time when `advance` has something to do to the earliest of several. `awaits_bytes` leaves the silence
    /// before sending out: nothing is to be sent before more has arrived, or a time limit is over.
    constexpr void add_to(earliest& next, bool awaits_bytes = false) const noexcept
    {
        if (activity_ == activity::busy and not awaits_bytes) {
            next.add(last_ + line().silence());
        }
        if (activity_ != activity::unknown and ends_by_silence()) {
            next.add(last_ + end_silence());
        }
    }

    /// The same for a receiver that has nothing to send: when silence ends the frame being received, or the bytes
    /// being ignored; between frames, when the line counts as quiet. A separate plain form, which is smaller
    /// (docs/size-notes.md).
    [[nodiscard]] constexpr deadline poll_end_deadline() const noexcept
    {
        if (activity_ == activity::unknown or not(waits_for_silence() or activity_ == activity::busy)) {
            return {};
        }
        return last_ + (waits_for_silence() ? end_silence() : line().silence());
    }

    /// Whether a frame ended, whole or damaged, once.
    [[nodiscard]] constexpr bool poll_end() noexcept
    {
        bool const is_end = state_ == state::done;
        if (is_end) {
            state_ = state::idle;
        }
        return is_end;
    }

    /// Drops what is being received where silence does not end it.
    constexpr void drop_unended() noexcept
    {
        state_ = waits_for_silence() and not ends_by_silence() ? state::idle : state_;
    }

    /// Drops what is being received: the next byte is the first of a frame.
    constexpr void drop_begun() noexcept { state_ = state::idle; }

    /// A frame that has ended by its length goes on: nothing but silence ends it.
    constexpr void go_on() noexcept { state_ = state_ == state::done ? state::receiving : state_; }

    /// Drops what is being received and takes the next byte as the first of a frame: for a line that the
    /// caller knows to be silent, because its own transmission just ended.
    constexpr void restart(instant now) noexcept
    {
        note_activity(now);
        state_ = state::idle;
    }

    /// Ignores everything until the line has been silent.
    constexpr void resynchronise() noexcept { state_ = state::synchronising; }

    /// When the last byte arrived, or the time of a later `note_activity`.
    [[nodiscard]] constexpr instant last_activity() const noexcept { return last_; }

    /// Records that the line was not silent at `now`, and leaves the frame alone. While the line is busy, a time
    /// before the latest recorded one changes nothing.
    constexpr void note_activity(instant now) noexcept { keep_activity(now, now); }

    /// Whether the silence before sending has passed.
    [[nodiscard]] constexpr bool is_quiet() const noexcept { return activity_ == activity::quiet; }

    /// Whether nothing has come for t3.5, or for the silence before sending where that is shorter.
    [[nodiscard]] constexpr bool is_at_rest(instant now) const noexcept
    {
        return is_quiet() or reached(now, last_ + line().t3_5());
    }

    /// Whether the next byte would be the first of a frame.
    [[nodiscard]] constexpr bool is_at_start() const noexcept { return not waits_for_silence(); }

    /// Whether bytes are ignored until the line has been silent.
    [[nodiscard]] constexpr bool ignores_bytes() const noexcept { return state_ == state::synchronising; }

    [[nodiscard]] constexpr line_timing const& line() const noexcept
    {
        return static_cast<Holder const&>(*this).line_.get();
    }

protected:
    enum class state : std::uint8_t { synchronising, receiving, open_end, idle, done };

    /// Always false in a receiver of responses.
    constexpr bool is_open_end() const noexcept { return Way == direction::request and state_ == state::open_end; }

private:
    /// What the line did last; unknown before the first time is given.
    enum class activity : std::uint8_t { unknown, busy, quiet };

    constexpr bool waits_for_silence() const noexcept { return state_ < state::idle; }

    /// The silence that ends what is being received.
    constexpr duration end_silence() const noexcept { return is_open_end() ? line().t3_5() : line().frame_end(); }

    /// Whether silence ends what is being received. On a host, where no wire may lose bytes, it does not while its holder
    /// awaits the rest.
    constexpr bool ends_by_silence() const noexcept
    {
        if constexpr (has_system) {
            if (not line().has_wire() and static_cast<Holder const&>(*this).awaits_rest()) {
                return false;
            }
        }
        return waits_for_silence();
    }

    /// `at`: the time by which the latest activity is judged, which is `within_reach_of_line` of bytes that have come now.
    constexpr void keep_activity(instant now, instant at) noexcept
    {
        if (activity_ != activity::busy or reached(at, last_)) {
            last_ = now;
        }
        activity_ = activity::busy;
    }

    constexpr void on_silence() noexcept
    {
        if (ends_by_silence()) {
            state_ = state_ == state::synchronising ? state::idle : state::done;
        }
    }

    instant last_{0};
    activity activity_{activity::unknown};

protected:
    state state_{state::synchronising};
};

} // namespace rtuwire::detail
