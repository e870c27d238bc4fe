// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// A two-wire line, character by character, in 64-bit time: what each sender puts on it, what of that is
// spoiled because two sent at once, and when each character ends.
#pragma once

#include <algorithm>
#include <array>
#include <vector>

#include <rtuwire/sim/line/line_faults.hpp>

#include "frames.hpp"

namespace rtuwire::simulation {

/// What a frame on the line is, for whoever judges it later.
struct frame_origin {
    std::uint32_t transmission{0}; ///< the transmission that it is, or answers
    moment could_begin{0};         ///< a response: when its unit could begin with it
    std::uint32_t chain{0};        ///< the transmission with which its unit's queue began
    bool is_late_chain{false};     ///< a response before it in its unit's queue took too long
};

/// A frame on the line.
struct passing {
    unsigned sender{0};
    moment start{0};
    moment end{0};
    frame content{};
    frame_origin origin{};
    bool is_lost{false};             ///< nobody hears it
    std::uint8_t damaged_at{0};      ///< the character with wrong bits
    std::uint8_t damage{0};          ///< these bits
    bool is_reported{false};         ///< the receivers see the damage
    moment spoiled_from{never};      ///< two senders at once from then
    moment spoiled_until{0};         ///< to then
    std::size_t next{0};             ///< the next character to end
    std::uint32_t deaf_listeners{0}; ///< a bit for each listener that misses it

    bool is_whole() const { return not is_lost and damage == 0 and spoiled_from == never; }
};

/// A character as a listener gets it.
struct character {
    std::byte value{};
    bool is_damaged{false};
};

/// The times of a line by the standard (SL 2.5.1), reckoned apart from the library.
struct line_times {
    std::uint64_t character_ns{0};
    moment t3_5{0};

    line_times(std::uint32_t bits_per_second, unsigned bits)
        : character_ns{bits * 1'000'000'000ULL / bits_per_second}, t3_5{bits_per_second > 19'200
                                                                            ? 1'750
                                                                            : character_ns * 7 / 2'000}
    {}
    moment characters(std::size_t count) const { return (count * character_ns + 999) / 1'000; }
};

/// The line. `transmit` puts a frame on it; `advance` gives each character at its end, then the frame.
class shared_line {
public:
    shared_line(line_times const& times, std::uint32_t seed) : times_{times}, random_{seed} {}

    /// Sends from `now` on; the end of the last stop bit.
    moment transmit(passing const& sent, moment now)
    {
        passing& own = frames_.emplace_back(sent);
        own.start = now;
        own.end = now + times_.characters(own.content.size());
        own.next = 0;
        last_end_ = own.is_lost ? last_end_ : std::max(last_end_, own.end);
        for (std::size_t i = 0; i + 1 < frames_.size(); ++i) {
            passing& other = frames_[i];
            if (other.end <= now or other.is_lost or own.is_lost) {
                continue;
            }
            other.spoiled_from = std::min(other.spoiled_from, now);
            other.spoiled_until = std::max(other.spoiled_until, own.end);
            own.spoiled_from = now;
            own.spoiled_until = std::max(own.spoiled_until, other.end);
        }
        plan();
        return own.end;
    }

    /// When the next character ends.
    moment next() const { return next_; }

    /// When the last character on the line ends, or ended.
    moment last_end() const { return last_end_; }

    /// Gives the characters that have ended to `hear(frame, character, its start)`, and each frame
    /// whose last character that was to `end(frame)`.
    template <typename Hear, typename End> void advance(moment now, Hear hear, End end)
    {
        while (next_ <= now) {
            passing& one = frames_[next_frame_];
            moment const begin = one.start + times_.characters(one.next);
            if (not one.is_lost) {
                hear(one, heard(one, begin), begin);
            }
            ++one.next;
            if (one.next == one.content.size()) {
                passing const ended = one;
                frames_.erase(frames_.begin() + static_cast<std::ptrdiff_t>(next_frame_));
                plan();
                end(ended);
            } else {
                plan();
            }
        }
    }

private:
    character heard(passing const& one, moment begin)
    {
        character got{static_cast<std::byte>(one.content[one.next]), false};
        if (one.damage != 0 and one.damaged_at == one.next) {
            got = {got.value ^ static_cast<std::byte>(one.damage), one.is_reported};
        }
        if (begin < one.spoiled_until and begin + times_.characters(1) > one.spoiled_from) {
            got = {static_cast<std::byte>(random_.next()), random_.below(2) == 0};
        }
        return got;
    }

    void plan()
    {
        next_ = never;
        for (std::size_t i = 0; i < frames_.size(); ++i) {
            moment const at = frames_[i].start + times_.characters(frames_[i].next + 1);
            if (at < next_) {
                next_ = at;
                next_frame_ = i;
            }
        }
    }

    line_times times_;
    detail::random_source random_;
    std::vector<passing> frames_{};
    moment next_{never};
    moment last_end_{0};
    std::size_t next_frame_{0};
};

} // namespace rtuwire::simulation
