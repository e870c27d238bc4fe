// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// Words of which a manual names the values or the bits: names for the values of an enumeration, for display, of which
// firmware that shows none contains none; and registers of named bits.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <type_traits>

#include <rtuwire/core/literal.hpp>
#include <rtuwire/core/version.hpp>

namespace rtuwire {
inline namespace RTUWIRE_BUILD {

/// A value and the mnemonic that the manual gives it.
struct named_value {
    std::uint16_t value;
    literal name;
};

/// One value of an enumeration, or one bit of a word by its number: the mnemonic that the manual gives it, and what it
/// means in words.
struct choice {
    std::uint16_t word;
    literal mnemonic;
    literal meaning{};
};

namespace detail {

/// The names of an enumeration that is made of choices, and names the list in a function beside it; else none.
template <typename Enum> [[nodiscard]] consteval auto names_in_choices(literal choice::*what) noexcept
{
    if constexpr (requires { choices_beside(Enum{}); }) {
        constexpr std::span<choice const> list = choices_beside(Enum{});
        std::array<named_value, list.size()> names{};
        for (std::size_t i = 0; i < list.size(); ++i) {
            names[i] = {list[i].word, list[i].*what};
        }
        return names;
    } else {
        static_cast<void>(what);
        return std::array<named_value, 0>{};
    }
}

} // namespace detail

/// The names of an enumeration's values; specialised next to each enumeration that has any.
template <typename Enum> inline constexpr auto enumerators = detail::names_in_choices<Enum>(&choice::mnemonic);

/// What an enumeration's values mean, in words; specialised beside `enumerators` where the manual's table has words.
template <typename Enum> inline constexpr auto meanings = detail::names_in_choices<Enum>(&choice::meaning);

namespace detail {

/// A list of names, for a specialisation of `enumerators` or `meanings`.
template <std::size_t Count>
[[nodiscard]] consteval std::array<named_value, Count> name_list(named_value const (&names)[Count]) noexcept
{
    std::array<named_value, Count> list{};
    for (std::size_t i = 0; i < Count; ++i) {
        list[i] = names[i];
    }
    return list;
}

/// The values of an enumeration that its names list; none where it has no names.
template <typename Enum>
inline constexpr auto listed_values = [] {
    std::array<std::uint16_t, enumerators<Enum>.size()> values{};
    for (std::size_t i = 0; i < values.size(); ++i) {
        values[i] = enumerators<Enum>[i].value;
    }
    return values;
}();

/// Whether a word means something, given the words that do; with an empty list, any word does.
[[nodiscard]] constexpr bool has_meaning(std::span<std::uint16_t const> listed, std::uint16_t word) noexcept
{
    bool is_listed = listed.empty();
    for (std::uint16_t const each : listed) {
        is_listed = is_listed or each == word;
    }
    return is_listed;
}

/// The same of a list of choices.
[[nodiscard]] constexpr bool has_meaning(std::span<choice const> listed, std::uint16_t word) noexcept
{
    bool is_listed = listed.empty();
    for (choice const& each : listed) {
        is_listed = is_listed or each.word == word;
    }
    return is_listed;
}

/// The name of a value in a list; empty where it has none.
[[nodiscard]] constexpr literal listed_name(std::span<named_value const> list, std::uint16_t value) noexcept
{
    for (named_value const& each : list) {
        if (each.value == value) {
            return each.name;
        }
    }
    return {};
}

} // namespace detail

/// The mnemonic of a value; empty where none is known.
template <typename Enum> [[nodiscard]] constexpr literal name_of(Enum value) noexcept
{
    return detail::listed_name(enumerators<Enum>, static_cast<std::uint16_t>(value));
}

/// One word whose bits are named by an enumeration of bit numbers 0..15.
template <typename Bit>
    requires std::is_enum_v<Bit>
struct flags {
    using bit_type = Bit;
    using is_bit_field = void;

    std::uint16_t bits{0};

    /// Whether a bit is 1.
    [[nodiscard]] constexpr bool has(Bit bit) const noexcept
    {
        return ((bits >> static_cast<unsigned>(bit)) & 1U) != 0;
    }

    /// The same word with a bit set.
    [[nodiscard]] constexpr flags with(Bit bit) const noexcept
    {
        return {static_cast<std::uint16_t>(bits | (1U << static_cast<unsigned>(bit)))};
    }

    /// The same word with a bit cleared.
    [[nodiscard]] constexpr flags without(Bit bit) const noexcept
    {
        return {static_cast<std::uint16_t>(bits & ~(1U << static_cast<unsigned>(bit)))};
    }

    friend constexpr bool operator==(flags, flags) noexcept = default;
};

namespace detail {

/// Bits that none of the available manuals explains.
enum class unnamed_bit : std::uint8_t {};

} // namespace detail

} // namespace RTUWIRE_BUILD
} // namespace rtuwire
