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

/// The names of an enumeration's values; specialised next to each enumeration that has any.
template <typename E> inline constexpr std::array<named_value, 0> enumerators{};

/// What an enumeration's values mean, in words; specialised beside `enumerators` where the manual's table has words.
template <typename E> inline constexpr std::array<named_value, 0> meanings{};

namespace detail {

/// A list of names, for a specialisation of `enumerators` or `meanings`.
template <typename E, std::size_t Count>
[[nodiscard]] consteval std::array<named_value, Count> name_list(named_value const (&names)[Count]) noexcept
{
    std::array<named_value, Count> list{};
    for (std::size_t i = 0; i < Count; ++i) {
        list[i] = names[i];
    }
    return list;
}

/// The values of an enumeration that its names list; none where it has no names.
template <typename E>
inline constexpr auto listed_values = [] {
    std::array<std::uint16_t, enumerators<E>.size()> values{};
    for (std::size_t i = 0; i < values.size(); ++i) {
        values[i] = enumerators<E>[i].value;
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
template <typename E> [[nodiscard]] constexpr literal name_of(E value) noexcept
{
    return detail::listed_name(enumerators<E>, static_cast<std::uint16_t>(value));
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
