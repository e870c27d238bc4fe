// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// The order in which a number of 32 or 64 bits stands in registers. The specification does not say it, so each
// manufacturer has chosen one of four.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <type_traits>

#include <rtuwire/core/version.hpp>

namespace rtuwire {
inline namespace RTUWIRE_BUILD {

/// Where the bytes of a number stand; A is its most significant byte. Of 64 bits, the same goes on: ABCDEFGH,
/// GHEFCDAB, BADCFEHG, HGFEDCBA.
enum class word_order : std::uint8_t {
    high_first,               ///< ABCD: the registers of most devices
    low_first,                ///< CDAB: the word with the low bits first
    high_first_bytes_swapped, ///< BADC: the two bytes of each word change places
    low_first_bytes_swapped,  ///< DCBA: least significant byte first
};

namespace detail {

/// Internal.
[[nodiscard]] constexpr bool is_low_first(word_order order) noexcept
{
    return order == word_order::low_first or order == word_order::low_first_bytes_swapped;
}

[[nodiscard]] constexpr bool swaps_bytes(word_order order) noexcept
{
    return order == word_order::high_first_bytes_swapped or order == word_order::low_first_bytes_swapped;
}

/// A word as it travels in an order, from one with the high byte first, and back.
template <word_order Order> [[nodiscard]] constexpr std::uint16_t swapped_for(std::uint16_t word) noexcept
{
    return swaps_bytes(Order) ? static_cast<std::uint16_t>(std::uint32_t{word} << 8U | std::uint32_t{word} >> 8U)
                              : word;
}

/// The bits of so many words.
template <std::size_t Words> using bits_of = std::conditional_t<Words == 2, std::uint32_t, std::uint64_t>;

/// The number in 2 or 4 words.
template <word_order Order, std::size_t Words>
[[nodiscard]] constexpr bits_of<Words> joined(std::array<std::uint16_t, Words> const& words) noexcept
{
    static_assert(Words == 2 or Words == 4, "a number of several registers has two or four of them");
    bits_of<Words> bits = 0;
    for (std::size_t i = 0; i < Words; ++i) {
        bits = static_cast<bits_of<Words>>(bits << 16U) |
               swapped_for<Order>(words[is_low_first(Order) ? Words - 1 - i : i]);
    }
    return bits;
}

/// The 2 or 4 words of a number.
template <word_order Order, std::size_t Words>
[[nodiscard]] constexpr std::array<std::uint16_t, Words> separated(bits_of<Words> bits) noexcept
{
    std::array<std::uint16_t, Words> words{};
    for (std::size_t i = 0; i < Words; ++i) {
        words[is_low_first(Order) ? i : Words - 1 - i] = swapped_for<Order>(static_cast<std::uint16_t>(bits & 0xFFFFU));
        bits = static_cast<bits_of<Words>>(bits >> 16U);
    }
    return words;
}

} // namespace detail

} // namespace RTUWIRE_BUILD
} // namespace rtuwire
