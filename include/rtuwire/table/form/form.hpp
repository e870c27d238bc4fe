// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// One interface to whatever a register holds: the forms of several words, and as forms the values of one word and of
// one bit. And the order in which a number of 32 or 64 bits stands in registers: the specification does not say it, so each
// manufacturer has chosen one of four.
#pragma once

#include <array>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <type_traits>

#include <rtuwire/core/result.hpp>
#include <rtuwire/core/version.hpp>
#include <rtuwire/table/register.hpp>
#include <rtuwire/wire/errc.hpp>

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

/// A value of one word: every word is one.
template <register_value T> struct word_form {
    using value_type = T;
    static constexpr std::uint16_t word_count = 1;
    static constexpr bool is_total = true;
    using words = std::array<std::uint16_t, 1>;

    [[nodiscard]] static constexpr result<T> from_words(words const& from) noexcept { return from_word<T>(from[0]); }
    [[nodiscard]] static constexpr words to_words(T value) noexcept { return {to_word(value)}; }
};

/// A coil or a discrete input, kept as the word 1 or 0.
struct bit_form {
    using value_type = bool;
    static constexpr std::uint16_t word_count = 1;
    static constexpr bool is_total = true;
    using words = std::array<std::uint16_t, 1>;

    [[nodiscard]] static constexpr result<bool> from_words(words const& from) noexcept { return from[0] != 0; }
    [[nodiscard]] static constexpr words to_words(bool value) noexcept { return {std::uint16_t{value}}; }

    template <typename Value> static constexpr bool takes = std::same_as<Value, bool>;
    [[nodiscard]] static constexpr result<bool> convert(bool value) noexcept { return value; }
    [[nodiscard]] static constexpr errc refusal(bool, bound const&, bound const&, count_range) noexcept
    {
        return errc::none;
    }
};

} // namespace detail

/// The form of what a register holds.
template <typename T> struct as_form;
template <detail::register_value T> struct as_form<T> {
    using type = detail::word_form<T>;
};
template <> struct as_form<bool> {
    using type = detail::bit_form;
};
template <register_form T> struct as_form<T> {
    using type = T;
};

namespace detail {

template <auto const& R>
using register_form_of = typename as_form<typename std::remove_cvref_t<decltype(R)>::form>::type;

/// Whether all words of a register are a value of it; a form says so by `is_total`.
template <auto const& R> inline constexpr bool is_always_a_value = requires { requires register_form_of<R>::is_total; };

/// The value of a register whose first word stands at `place` in a list of words, and that of its scale register, where
/// it has one, at `scale`.
template <auto const& R, typename Words>
[[nodiscard]] constexpr result<value_of<R>> value_in(Words const& words, std::size_t place, std::size_t scale) noexcept
{
    using form = register_form_of<R>;
    std::array<std::uint16_t, form::word_count> own{};
    for (std::size_t i = 0; i < own.size(); ++i) {
        own[i] = words[place + i];
    }
    if constexpr (has_scale_register<R>) {
        return form::from_words(own, words[scale]);
    } else {
        return form::from_words(own);
    }
}

} // namespace detail

} // namespace RTUWIRE_BUILD
} // namespace rtuwire
