// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// A simulated RS-485 line in virtual time, bit by bit, with the faults of real ones. The same seed makes
// the same faults, so a run is named by one number. No heap, and a simulated second is some thousand
// steps.
#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <optional>

#include <rtuwire/core/bytes.hpp>
#include <rtuwire/core/time.hpp>
#include <rtuwire/core/version.hpp>
#include <rtuwire/rtu/line.hpp>
#include <rtuwire/sim/dice.hpp>
#include <rtuwire/sim/uart.hpp>
#include <rtuwire/sim/waveform.hpp>

namespace rtuwire::inline RTUWIRE_BUILD::sim {

/// How often something goes wrong, in a million.
struct line_faults {
    std::uint32_t bit_errors{0}; ///< bits that arrive as the other one
    std::uint32_t bursts{0};     ///< frames of which up to 16 neighbouring bits are disturbed
    std::uint32_t dropped{0};    ///< characters that nobody hears
    std::uint32_t added{0};      ///< characters after which another one follows
    std::uint32_t lost{0};       ///< frames that nobody hears
    std::uint32_t repeated{0};   ///< frames that are heard twice, the second right behind the first
    std::uint32_t delayed{0};    ///< frames that leave late, by up to `delay`
    std::uint32_t glitches{0};   ///< frames before which the line twitches
    duration delay{};
    bool is_cut{false}; ///< nothing arrives at all
};

/// A character as the receivers on the line get it.
struct sound {
    std::byte octet;
    bool is_damaged;       ///< by the receiver's word: parity or framing
    std::uint8_t speakers; ///< a bit for each of the talkers 0 to 7 that had a part in it
    instant at;            ///< the end of its last stop bit

    [[nodiscard]] constexpr bool is_from(unsigned talker) const noexcept
    {
        return ((speakers >> talker) & 1U) != 0;
    }
};

/// The line. `talk` puts frames on it, `listen` takes characters off it.
class line {
public:
    static constexpr unsigned talkers = 8;

    constexpr line(std::uint32_t bits_per_second, character_format format,
                   std::uint32_t seed) noexcept
        : dice_{seed}, bit_ns_{1'000'000'000U / bits_per_second}, format_{format}
    {}

    /// What goes wrong with what one of the talkers 0 to 7 sends.
    constexpr void set_faults(unsigned talker, line_faults const& faults) noexcept
    {
        faults_[talker % talkers] = faults;
    }

    /// The same for everybody.
    constexpr void set_faults(line_faults const& faults) noexcept { faults_.fill(faults); }

    /// One of the talkers 0 to 7 sends octets from `at` on, which is not before what was heard last.
    /// Returns when its last stop bit has left, as the talker sees it.
    constexpr instant talk(unsigned talker, byte_view octets, instant at) noexcept
    {
        if (cursor_ >= wave_.size()) {
            start_over(at);
        }
        line_faults const& faults = faults_[talker % talkers];
        std::size_t const bits = octets.size() * bits_per_character(format_);
        instant const end = at + time_of(bits);
        if (faults.is_cut or dice_.happens(faults.lost)) {
            return end;
        }
        std::size_t place = place_of(at);
        if (dice_.happens(faults.delayed)) {
            place += dice_.below(static_cast<std::uint32_t>(place_of(begin_ + faults.delay)));
        }
        if (dice_.happens(faults.glitches)) {
            place = twitch(place);
        }
        std::size_t after = lay(talker, octets, place);
        if (dice_.happens(faults.repeated)) {
            constexpr std::uint32_t longest_pause = 35; // below t3.5
            lay(talker, octets, after + dice_.below(longest_pause));
        }
        return end;
    }

    /// The next character that has ended by `now`.
    constexpr std::optional<sound> listen(instant now) noexcept
    {
        if (not find_start()) {
            return std::nullopt;
        }
        std::size_t const length = bits_per_character(format_);
        instant const end = begin_ + time_of(cursor_ + length);
        if (not reached(now, end)) {
            return std::nullopt;
        }
        received_octet const got = receive_character(format_, wave_.bits_from(cursor_));
        std::uint8_t const speakers = speakers_at(cursor_, cursor_ + length);
        cursor_ += length;
        return sound{got.octet, got.is_damaged, speakers, end};
    }

    /// When the next character has ended.
    [[nodiscard]] constexpr deadline poll_deadline() noexcept
    {
        if (not find_start()) {
            return std::nullopt;
        }
        return begin_ + time_of(cursor_ + bits_per_character(format_));
    }

private:
    /// A stretch of the signal that one talker had a part in.
    struct part {
        std::size_t begin{0};
        std::size_t end{0};
        std::uint8_t speaker{0};
    };

    constexpr void start_over(instant at) noexcept
    {
        wave_.clear();
        parts_ = {};
        next_part_ = 0;
        cursor_ = 0;
        begin_ = at;
    }

    /// Rounded up to whole microseconds, so that nothing is heard before it ended. Wraps as instants do,
    /// because a line that is never silent may run for longer than any duration.
    constexpr duration time_of(std::size_t bits) const noexcept
    {
        std::uint64_t const ns = std::uint64_t{bits} * bit_ns_;
        return duration{static_cast<std::uint32_t>((ns + 999) / 1'000)};
    }

    constexpr std::size_t place_of(instant at) const noexcept
    {
        std::uint64_t const ns = std::uint64_t{(at - begin_).microseconds} * 1'000U;
        return static_cast<std::size_t>((ns + bit_ns_ - 1) / bit_ns_);
    }

    /// A transceiver turns around: a short low before the frame.
    constexpr std::size_t twitch(std::size_t place) noexcept
    {
        constexpr std::uint32_t longest = 10;
        std::uint32_t const length = 1 + dice_.below(longest);
        wave_.lay(place, 0, length);
        return place + length + dice_.below(2 * longest);
    }

    constexpr std::size_t lay(unsigned talker, byte_view octets, std::size_t place) noexcept
    {
        line_faults const& faults = faults_[talker % talkers];
        std::size_t const begin = place;
        for (std::byte const octet : octets) {
            if (not dice_.happens(faults.dropped)) {
                wave_.lay(place, character_bits(format_, octet), bits_per_character(format_));
            }
            place += bits_per_character(format_);
            if (dice_.happens(faults.added)) {
                wave_.lay(place, character_bits(format_, to_byte(dice_.next())),
                          bits_per_character(format_));
                place += bits_per_character(format_);
            }
        }
        disturb(faults, begin, place);
        parts_[next_part_] = {begin, place, static_cast<std::uint8_t>(1U << talker)};
        next_part_ = (next_part_ + 1) % parts_.size();
        return place;
    }

    constexpr void disturb(line_faults const& faults, std::size_t begin, std::size_t end) noexcept
    {
        for (std::size_t at = begin; faults.bit_errors > 0 and at < end; ++at) {
            if (dice_.happens(faults.bit_errors)) {
                wave_.flip(at);
            }
        }
        if (dice_.happens(faults.bursts)) {
            constexpr std::uint32_t longest = 16;
            std::uint32_t const first = dice_.below(static_cast<std::uint32_t>(end - begin));
            std::uint32_t const pattern = dice_.next() | 1U;
            for (std::uint32_t i = 0; i <= dice_.below(longest); ++i) {
                if (((pattern >> i) & 1U) != 0) {
                    wave_.flip(begin + first + i);
                }
            }
        }
    }

    /// Moves to the next start bit; false where the line stays idle.
    constexpr bool find_start() noexcept
    {
        while (cursor_ < wave_.size()) {
            std::uint32_t const bits = wave_.bits_from(cursor_);
            auto const idle = static_cast<std::size_t>(std::countr_one(bits));
            constexpr std::size_t window = 16;
            if (idle < window) {
                cursor_ += idle;
                return cursor_ < wave_.size();
            }
            cursor_ += window;
        }
        return false;
    }

    constexpr std::uint8_t speakers_at(std::size_t begin, std::size_t end) const noexcept
    {
        std::uint8_t all = 0;
        for (part const& each : parts_) {
            if (each.begin < end and begin < each.end) {
                all = static_cast<std::uint8_t>(all | each.speaker);
            }
        }
        return all;
    }

    waveform wave_{};
    std::array<part, 8> parts_{};
    std::array<line_faults, talkers> faults_{};
    dice dice_;
    instant begin_{0};
    std::size_t cursor_{0};
    std::size_t next_part_{0};
    std::uint32_t bit_ns_;
    character_format format_;
};

} // namespace rtuwire::sim
