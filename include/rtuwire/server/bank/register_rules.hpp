// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// What a typed bank has to know of each of its registers when a request names it. Made by type, not by register: the
// compiler makes a thousand of them by one function.
// Internal: may change with any version.
#pragma once

#include <array>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <span>
#include <type_traits>

#include <rtuwire/core/version.hpp>
#include <rtuwire/table/enumeration.hpp>
#include <rtuwire/table/form/form.hpp>
#include <rtuwire/table/register.hpp>
#include <rtuwire/table/setting.hpp>
#include <rtuwire/wire/errc.hpp>
#include <rtuwire/wire/register_view.hpp>

namespace rtuwire::inline RTUWIRE_BUILD {

/// The words of a register as delivered; 0 where its factory value is not known.
template <typename T, register_space Space> [[nodiscard]] constexpr auto factory_words(reg<T, Space> const& of) noexcept
{
    using form = typename as_form<T>::type;
    using value_type = typename reg<T, Space>::value_type;
    if constexpr (register_value<value_type>) {
        return std::array{static_cast<std::uint16_t>(of.factory.value_or(0))};
    } else if constexpr (requires { typename form::count_type; }) {
        return form::to_words(value_type{static_cast<typename form::count_type>(of.factory.value_or(0))});
    } else if constexpr (std::same_as<value_type, bool>) {
        return form::to_words(of.factory.value_or(0) != 0);
    } else {
        return form::to_words(value_type{});
    }
}

/// What holds for a holding register of one word.
struct word_rule {
    std::uint16_t address;
    bool is_writable;
    bool is_signed;
    std::int32_t lowest;
    std::int32_t highest;
    std::span<std::uint16_t const> listed;
    count_range gap;

    /// Of a register; nothing of one that is not such a register.
    template <typename T, register_space Space> [[nodiscard]] static constexpr word_rule of(reg<T, Space> const& from)
    {
        if constexpr (reg<T, Space>::is_plain) {
            std::int32_t const least = lowest_count<T>(from.min);
            return {from.address, from.mode != access::read_only, least < 0,
                    least,        highest_count<T>(from.max),     listed_words<T>(),
                    from.gap};
        } else {
            return {};
        }
    }

    static constexpr std::size_t word_count = 1;
    [[nodiscard]] static constexpr std::size_t first_word(std::size_t place) noexcept { return place; }
    static constexpr void put_at(std::size_t) noexcept {}
    [[nodiscard]] constexpr bool takes(register_view values, std::size_t at) const noexcept
    {
        std::uint16_t const word = values[at];
        std::int32_t const raw = is_signed ? std::int32_t{static_cast<std::int16_t>(word)} : std::int32_t{word};
        return raw >= lowest and raw <= highest and not gap.contains(raw) and has_meaning(listed, word);
    }
};

/// The limits of a register of any form. A number, or none.
struct value_limits {
    std::int64_t min;
    std::int64_t max;
    count_range gap;
    bool has_min;
    bool has_max;
};

/// Whether a register of a type takes the words of a request, from the one at `at` on; `IsOpen` where it has no limits.
template <typename T, bool IsOpen>
[[nodiscard]] constexpr bool takes_words(register_view values, std::size_t at,
                                         [[maybe_unused]] value_limits const& limits) noexcept
{
    using form = typename as_form<T>::type;
    using value_type = typename form::value_type;
    std::array<std::uint16_t, form::word_count> words{};
    for (std::size_t i = 0; i < words.size(); ++i) {
        words[i] = values[at + i];
    }
    auto const value = form::from_words(words);
    if (not value) {
        return false;
    }
    if constexpr (register_value<value_type>) {
        std::int32_t const raw = raw_count<value_type>(to_word(*value));
        return raw >= limits.min and raw <= limits.max and not limits.gap.contains(raw) and
               has_meaning(listed_words<value_type>(), to_word(*value));
    } else if constexpr (IsOpen) {
        return form::refusal(*value, bound{}, bound{}, count_range{}) == errc::none;
    } else {
        bound const min = limits.has_min ? bound{limits.min} : bound{};
        bound const max = limits.has_max ? bound{limits.max} : bound{};
        return form::refusal(*value, min, max, limits.gap) == errc::none;
    }
}

/// What holds for any register of words.
struct value_rule {
    std::uint16_t address;
    std::uint16_t word_count;
    std::uint16_t first; ///< where its first word is stored
    bool is_writable;
    bool (*check)(register_view, std::size_t, value_limits const&); ///< null where no client writes it
    value_limits limits;

    template <typename T, register_space Space> [[nodiscard]] static constexpr value_rule of(reg<T, Space> const& from)
    {
        using value_type = typename reg<T, Space>::value_type;
        value_rule rule{from.address,
                        reg<T, Space>::word_count,
                        0,
                        from.mode != access::read_only,
                        nullptr,
                        {from.min.raw(), from.max.raw(), from.gap, from.min.is_number(), from.max.is_number()}};
        if constexpr (register_value<value_type>) {
            rule.limits.min = lowest_count<value_type>(from.min);
            rule.limits.max = highest_count<value_type>(from.max);
        }
        // A form without limits needs no arithmetic for them, and one that nobody writes no check at all.
        bool const is_open = not from.min.is_number() and not from.max.is_number() and from.gap.last < from.gap.first;
        if constexpr (not scaled_form<T>) {
            if (rule.is_writable) {
                rule.check = is_open and not register_value<value_type> ? takes_words<T, true> : takes_words<T, false>;
            }
        }
        return rule;
    }

    [[nodiscard]] constexpr std::size_t first_word(std::size_t) const noexcept { return first; }
    constexpr void put_at(std::size_t word) noexcept { first = static_cast<std::uint16_t>(word); }
    [[nodiscard]] constexpr bool takes(register_view values, std::size_t at) const noexcept
    {
        return check(values, at, limits);
    }
};

/// What holds for a coil or a discrete input.
struct bit_rule {
    std::uint16_t address;
    bool is_writable;

    template <typename T, register_space Space> [[nodiscard]] static constexpr bit_rule of(reg<T, Space> const& from)
    {
        return {from.address, from.mode != access::read_only};
    }

    static constexpr std::size_t word_count = 1;
    [[nodiscard]] static constexpr std::size_t first_word(std::size_t place) noexcept { return place; }
    static constexpr void put_at(std::size_t) noexcept {}
};

} // namespace rtuwire
