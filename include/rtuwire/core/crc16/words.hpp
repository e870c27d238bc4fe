// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// CRC-16/MODBUS of many bytes on 64-bit processors: up to eight words of the message side by side, which do not wait
// for each other, are moved by shifts alone, and the last word by tables. The polynomial is (x + 1) T with
// T = x^15 + x + 1. Modulo T a high power is the sum of two low ones, x^16 = x^2 + x, and squaring keeps that so:
// x^(64 k) is two shifts for each k that is a power of 2. Modulo x + 1 the message is its parity. Of the two remainders
// modulo T that fit 16 bits, r and r + T, the CRC is the one with the parity of the message. All words are reflected:
// bit 0 is the highest power.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>

#include <rtuwire/core/bytes.hpp>
#include <rtuwire/core/crc16/tables.hpp>
#include <rtuwire/core/version.hpp>

namespace rtuwire {
inline namespace RTUWIRE_BUILD {
namespace crc16_words {

/// Whether a word has an odd number of bits set: 1 or 0.
[[nodiscard]] constexpr std::uint32_t parity_of(std::uint32_t word) noexcept
{
    word ^= word >> 16U;
    word ^= word >> 8U;
    word ^= word >> 4U;
    return (0x6996U >> (word & 0xFU)) & 1U;
}

/// The CRC of a message that was folded into one word: its remainder modulo T whose parity is that of the message.
[[nodiscard]] constexpr std::uint16_t finish(std::uint64_t word, std::uint64_t parity) noexcept
{
    constexpr std::uint32_t t = 0xC001;
    std::uint32_t const remainder = crc16_tables::of_word(word);
    return static_cast<std::uint16_t>(
        remainder ^ (t & (0U - parity_of(remainder ^ static_cast<std::uint32_t>(parity >> 32U ^ parity)))));
}

/// Several words side by side, the first of the message first.
template <std::size_t Count> using lanes = std::array<std::uint64_t, Count>;

/// x^(64 Count) as two shifts: the part that stays in a word, and the part carried into the one before.
template <std::size_t Count> struct power {
    static constexpr int low = static_cast<int>(4 * Count);
    static constexpr int high = static_cast<int>(8 * Count);

    [[nodiscard]] static constexpr std::uint64_t staying(std::uint64_t word) noexcept
    {
        return word >> low ^ (high < 64 ? word >> (high % 64) : 0U);
    }
    [[nodiscard]] static constexpr std::uint64_t leaving(std::uint64_t word) noexcept
    {
        return word << (64 - low) ^ word << (64 - high);
    }
};

/// Lanes times x^(64 Count), and the words that follow in the message.
template <std::size_t Count, std::size_t... I>
[[nodiscard]] constexpr lanes<Count> fold(lanes<Count> left, lanes<Count> const& next,
                                          std::index_sequence<I...>) noexcept
{
    left[Count - 1] ^= power<Count>::leaving(left[0]);
    return {(next[I] ^ power<Count>::staying(left[I]) ^
             (I + 1 < Count ? power<Count>::leaving(left[(I + 1) % Count]) : 0U))...};
}
template <std::size_t Count>
[[nodiscard]] constexpr lanes<Count> fold(lanes<Count> const& left, lanes<Count> const& next) noexcept
{
    return fold<Count>(left, next, std::make_index_sequence<Count>{});
}

/// The first half folded onto the second.
template <std::size_t Half, std::size_t... I>
[[nodiscard]] constexpr lanes<Half> halved(lanes<2 * Half> const& whole, std::index_sequence<I...>) noexcept
{
    return fold<Half>(lanes<Half>{whole[I]...}, lanes<Half>{whole[Half + I]...});
}
template <std::size_t Half> [[nodiscard]] constexpr lanes<Half> halved(lanes<2 * Half> const& whole) noexcept
{
    return halved<Half>(whole, std::make_index_sequence<Half>{});
}

/// The same words with zeros before them, which change no remainder.
template <std::size_t Count, std::size_t... I>
[[nodiscard]] constexpr lanes<2 * Count> doubled(lanes<Count> const& words, std::index_sequence<I...>) noexcept
{
    return {(I < Count ? 0U : words[I % Count])...};
}
template <std::size_t Count> [[nodiscard]] constexpr lanes<2 * Count> doubled(lanes<Count> const& words) noexcept
{
    return doubled<Count>(words, std::make_index_sequence<2 * Count>{});
}

/// The words of a message, from its front.
class words {
public:
    /// Of at least 8 bytes. The odd ones at the front are `head()`, the rest comes in whole words.
    constexpr explicit words(byte_view bytes) noexcept : at_{bytes.data()}, count_{bytes.size() / 8}
    {
        // The CRC starts from FFFF: that is, with its first two bytes inverted.
        if (std::size_t const odd = bytes.size() % 8; odd != 0) {
            std::size_t const shift = 8 * (8 - odd);
            head_ = (detail::word_at(at_) ^ 0xFFFFU) << shift;
            start_ = odd == 1 ? 0xFFU : 0U;
            at_ += odd;
            parity_ = head_;
        }
    }

    [[nodiscard]] constexpr std::uint64_t head() const noexcept { return head_; }
    [[nodiscard]] constexpr std::size_t count() const noexcept { return count_; }
    [[nodiscard]] constexpr std::uint64_t parity() const noexcept { return parity_; }

    template <std::size_t Count> [[nodiscard]] constexpr lanes<Count> take() noexcept
    {
        return take<Count>(std::make_index_sequence<Count>{});
    }

private:
    template <std::size_t Count, std::size_t... I> constexpr lanes<Count> take(std::index_sequence<I...>) noexcept
    {
        lanes<Count> next{detail::word_at(at_ + 8 * I)...};
        next[0] ^= start_;
        start_ = 0;
        at_ += 8 * Count;
        ((parity_ ^= next[I]), ...);
        return next;
    }

    std::byte const* at_;
    std::size_t count_;
    std::uint64_t head_{0};
    std::uint64_t start_{0xFFFF};
    std::uint64_t parity_{0};
};

/// The CRC of at least 8 bytes, in up to eight lanes.
[[nodiscard]] constexpr std::uint16_t of_words(byte_view bytes) noexcept
{
    words message{bytes};
    lanes<1> one{message.head()};
    if ((message.count() & 1U) != 0) {
        one = fold(one, message.take<1>());
    }
    lanes<2> two = doubled(one);
    if ((message.count() & 2U) != 0) {
        two = fold(two, message.take<2>());
    }
    lanes<4> four = doubled(two);
    if ((message.count() & 4U) != 0) {
        four = fold(four, message.take<4>());
    }
    if (std::size_t blocks = message.count() / 8; blocks > 0) {
        lanes<8> eight = fold(doubled(four), message.take<8>());
        while (--blocks > 0) {
            eight = fold(eight, message.take<8>());
        }
        four = halved<4>(eight);
    }
    return finish(halved<1>(halved<2>(four))[0], message.parity());
}

} // namespace crc16_words
} // namespace RTUWIRE_BUILD
} // namespace rtuwire
