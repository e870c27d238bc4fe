// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// One interface to whatever a register holds: the forms of several words, and as forms the values of one word and of
// one bit.
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

namespace detail {

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
