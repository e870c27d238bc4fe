// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// A simulated RS-485 line in virtual time, bit by bit, with the faults of real ones. The same seed makes the same faults,
// so a run is named by one number. No heap, and a simulated second is some thousand steps.
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
#include <rtuwire/sim/line/line_faults.hpp>

namespace rtuwire {
inline namespace RTUWIRE_BUILD {
namespace detail {

// One character on a wire: start bit, data, parity, stop. Bit 0 of a pattern comes first; idle is 1.

/// A character as a receiver decodes it.
struct received_byte {
    std::byte byte;
    bool is_damaged; ///< parity or framing error
};

/// The parity bit of a byte, 0 or 1; nothing where the format has none.
[[nodiscard]] constexpr std::optional<std::uint32_t> parity_of(character_format format, std::uint8_t byte) noexcept
{
    std::uint32_t const even = static_cast<std::uint32_t>(std::popcount(byte)) & 1U;
    switch (format) {
    case character_format::even_8_1:
    case character_format::even_8_2: return even;
    case character_format::odd_8_1:
    case character_format::odd_8_2: return even ^ 1U;
    case character_format::none_8_1:
    case character_format::none_8_2: break;
    }
    return std::nullopt;
}

/// The bits of a byte, `bits_per_character` of them.
[[nodiscard]] constexpr std::uint32_t character_bits(character_format format, std::byte byte) noexcept
{
    constexpr std::uint32_t stop_bits = 0b11;
    std::uint32_t const data = to_u8(byte);
    std::uint32_t const parity = parity_of(format, to_u8(byte)).value_or(1); // without parity the stop bit is there
    return data << 1U | parity << 9U | stop_bits << 10U;
}

/// Decodes the bits that begin with a start bit, as a receiver does: it looks at the first stop bit only.
[[nodiscard]] constexpr received_byte receive_character(character_format format, std::uint32_t bits) noexcept
{
    auto const byte = static_cast<std::uint8_t>(bits >> 1U);
    auto const parity = parity_of(format, byte);
    bool const is_parity_right = not parity or *parity == ((bits >> 9U) & 1U);
    std::uint32_t const stop_at = parity ? 10 : 9;
    bool const has_stop = ((bits >> stop_at) & 1U) != 0;
    return {to_byte(byte), not is_parity_right or not has_stop};
}

/// The signal of one busy period, bit by bit: idle high, pulled low by any sender. Bits beyond its end are idle.
class waveform {
public:
    static constexpr std::size_t capacity = 16'384;

    constexpr waveform() noexcept { words_.fill(idle); }

    /// The number of bits up to the last one written.
    [[nodiscard]] constexpr std::size_t size() const noexcept { return size_; }

    /// Writes `count` bits, at most 16, over those already there: low wins.
    constexpr void lay(std::size_t at, std::uint32_t bits, std::size_t count) noexcept
    {
        if (at + count > capacity) {
            return;
        }
        std::uint64_t const lows = ~std::uint64_t{bits} & ((std::uint64_t{1} << count) - 1);
        std::size_t const word = at / word_bits;
        std::size_t const shift = at % word_bits;
        words_[word] &= ~(lows << shift);
        if (shift + count > word_bits) {
            words_[word + 1] &= ~(lows >> (word_bits - shift));
        }
        touch(at + count);
    }

    /// Inverts a bit.
    constexpr void flip(std::size_t at) noexcept
    {
        if (at < capacity) {
            words_[at / word_bits] ^= std::uint64_t{1} << (at % word_bits);
            touch(at + 1);
        }
    }

    /// The 16 bits from a place on.
    [[nodiscard]] constexpr std::uint32_t bits_from(std::size_t at) const noexcept
    {
        std::size_t const word = at / word_bits;
        std::size_t const shift = at % word_bits;
        std::uint64_t const low = word < words_.size() ? words_[word] : idle;
        std::uint64_t const high = word + 1 < words_.size() ? words_[word + 1] : idle;
        std::uint64_t const both = shift == 0 ? low : low >> shift | high << (word_bits - shift);
        return static_cast<std::uint32_t>(both & 0xFFFFU);
    }

    /// All idle again.
    constexpr void clear() noexcept
    {
        for (std::size_t word = 0; word * word_bits < size_; ++word) {
            words_[word] = idle;
        }
        size_ = 0;
    }

private:
    static constexpr std::size_t word_bits = 64;
    static constexpr std::uint64_t idle = ~std::uint64_t{0};

    constexpr void touch(std::size_t end) noexcept
    {
        end = end < capacity ? end : capacity;
        size_ = end > size_ ? end : size_;
    }

    std::array<std::uint64_t, capacity / word_bits> words_{};
    std::size_t size_{0};
};

/// A character as the receivers on the line get it.
struct character {
    std::byte byte;
    bool is_damaged;      ///< a parity or framing error in the receiver
    std::uint8_t senders; ///< a bit for each of the senders 0 to 7 that contributed to it
    instant at;           ///< the end of its last stop bit

    [[nodiscard]] constexpr bool is_from(unsigned sender) const noexcept { return ((senders >> sender) & 1U) != 0; }
};

} // namespace detail

namespace sim {

/// The line. `transmit` puts frames on it, `receive` takes characters off it.
class line {
public:
    static constexpr unsigned max_senders = 8;

    /// At this rate and format; the same seed gives the same faults.
    constexpr line(std::uint32_t bits_per_second, character_format format, std::uint32_t seed) noexcept
        : random_{seed}, bit_ns_{1'000'000'000U / bits_per_second}, format_{format}
    {}

    /// A line whose characters have a parity bit and take the time that `timing` gives.
    constexpr line(line_timing const& timing, std::uint32_t seed) noexcept
        : random_{seed}, bit_ns_{timing.characters(1).microseconds * 1'000U /
                                 detail::bits_per_character(character_format::even_8_1)},
          format_{character_format::even_8_1}
    {}

    /// Sets the faults of what one of the senders 0 to 7 transmits.
    constexpr void set_faults(unsigned sender, line_faults const& faults) noexcept
    {
        faults_[sender % max_senders] = faults;
    }

    /// The same for all senders.
    constexpr void set_faults(line_faults const& faults) noexcept { faults_.fill(faults); }

    /// One of the senders 0 to 7 transmits bytes from `at` on, which is not before the character received last.
    /// Returns when its last stop bit was sent, as the sender sees it.
    constexpr instant transmit(unsigned sender, byte_view bytes, instant at) noexcept
    {
        if (cursor_ >= wave_.size()) {
            start_over(at);
        }
        line_faults const& faults = faults_[sender % max_senders];
        std::size_t const bits = bytes.size() * detail::bits_per_character(format_);
        instant const end = at + time_of(bits);
        frame_fate const fate = fate_of(faults, random_);
        if (fate.is_lost) {
            return end;
        }
        std::size_t place = place_of(at);
        if (fate.is_delayed) {
            place += random_.below(static_cast<std::uint32_t>(place_of(begin_ + faults.delay)));
        }
        if (fate.has_glitch) {
            place = glitch(place);
        }
        if (fate.has_foreign) {
            place = lay_foreign(sender, bytes, place);
        }
        if (fate.is_babble) {
            lay_babble(sender, place);
            return end;
        }
        std::size_t after = lay(sender, bytes, place);
        if (fate.is_repeated) {
            constexpr std::uint32_t longest_pause = 35; // below t3.5
            lay(sender, bytes, after + random_.below(longest_pause));
        }
        return end;
    }

    /// The next character that has ended by `now`.
    constexpr std::optional<detail::character> receive(instant now) noexcept
    {
        if (not find_start()) {
            return std::nullopt;
        }
        std::size_t const length = detail::bits_per_character(format_);
        instant const end = begin_ + time_of(cursor_ + length);
        if (not reached(now, end)) {
            return std::nullopt;
        }
        detail::received_byte const got = detail::receive_character(format_, wave_.bits_from(cursor_));
        std::uint8_t const senders = senders_at(cursor_, cursor_ + length);
        cursor_ += length;
        return detail::character{got.byte, got.is_damaged, senders, end};
    }

    /// When the next character has ended.
    [[nodiscard]] constexpr deadline poll_deadline() noexcept
    {
        if (not find_start()) {
            return std::nullopt;
        }
        return begin_ + time_of(cursor_ + detail::bits_per_character(format_));
    }

private:
    /// A section of the signal to which one sender contributed.
    struct part {
        std::size_t begin{0};
        std::size_t end{0};
        std::uint8_t sender{0};
    };

    constexpr void start_over(instant at) noexcept
    {
        wave_.clear();
        parts_ = {};
        next_part_ = 0;
        cursor_ = 0;
        begin_ = at;
    }

    /// Rounded up to whole microseconds, so that nothing is received before it ended. Wraps as instants do, because a
    /// line that is never silent may run for longer than any duration.
    constexpr duration time_of(std::size_t bits) const noexcept
    {
        std::uint64_t const ns = std::uint64_t{bits} * bit_ns_;
        return duration{static_cast<std::uint32_t>((ns + 999) / 1'000)};
    }

    constexpr std::size_t place_of(instant at) const noexcept
    {
        std::uint64_t const ns = std::uint64_t{(at - begin_).microseconds} * 1'000U;
        return static_cast<std::uint32_t>((ns + bit_ns_ - 1) / bit_ns_);
    }

    /// A transceiver switches its direction: a short low before the frame.
    constexpr std::size_t glitch(std::size_t place) noexcept
    {
        constexpr std::uint32_t longest = 10;
        std::uint32_t const length = 1 + random_.below(longest);
        wave_.lay(place, 0, length);
        return place + length + random_.below(2 * longest);
    }

    constexpr std::size_t lay(unsigned sender, byte_view bytes, std::size_t place) noexcept
    {
        line_faults const& faults = faults_[sender % max_senders];
        std::size_t const begin = place;
        for (std::byte const byte : bytes) {
            if (not random_.happens(faults.dropped)) {
                wave_.lay(place, detail::character_bits(format_, byte), detail::bits_per_character(format_));
            }
            place += detail::bits_per_character(format_);
            if (random_.happens(faults.added)) {
                wave_.lay(place, detail::character_bits(format_, detail::to_byte(random_.next())),
                          detail::bits_per_character(format_));
                place += detail::bits_per_character(format_);
            }
        }
        disturb(faults, begin, place);
        parts_[next_part_] = {begin, place, static_cast<std::uint8_t>(1U << sender)};
        next_part_ = (next_part_ + 1) % parts_.size();
        return place;
    }

    /// Another unit's answer, and the silence behind it.
    constexpr std::size_t lay_foreign(unsigned sender, byte_view bytes, std::size_t place) noexcept
    {
        constexpr std::size_t silence = 40; // t3.5
        std::array<std::byte, max_adu_size> room{};
        if (bytes.size() > room.size()) {
            return place;
        }
        return lay(sender, foreign_answer(bytes, room, random_), place) + silence;
    }

    constexpr void lay_babble(unsigned sender, std::size_t place) noexcept
    {
        std::array<std::byte, 300> bytes{}; // longer than any frame
        fill_babble(bytes, random_);
        lay(sender, bytes, place);
    }

    constexpr void disturb(line_faults const& faults, std::size_t begin, std::size_t end) noexcept
    {
        for (std::size_t at = begin; faults.bit_errors > 0 and at < end; ++at) {
            if (random_.happens(faults.bit_errors)) {
                wave_.flip(at);
            }
        }
        if (random_.happens(faults.bursts)) {
            disturb_bits(end - begin, random_, [&](std::size_t at) { wave_.flip(begin + at); });
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

    constexpr std::uint8_t senders_at(std::size_t begin, std::size_t end) const noexcept
    {
        std::uint8_t all = 0;
        for (part const& each : parts_) {
            if (each.begin < end and begin < each.end) {
                all = static_cast<std::uint8_t>(all | each.sender);
            }
        }
        return all;
    }

    detail::waveform wave_{};
    std::array<part, 8> parts_{};
    std::array<line_faults, max_senders> faults_{};
    detail::random_source random_;
    instant begin_{0};
    std::size_t cursor_{0};
    std::size_t next_part_{0};
    std::uint32_t bit_ns_;
    character_format format_;
};

} // namespace sim
} // namespace RTUWIRE_BUILD
} // namespace rtuwire
