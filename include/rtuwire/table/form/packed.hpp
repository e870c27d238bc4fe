// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// One word that holds several small values, each at a place of its own: a mode in three bits, a gear in four. And an
// enumeration of which not every word is a value: a word in a hole is refused on reading.
#pragma once

#include <array>
#include <concepts>
#include <cstdint>
#include <limits>
#include <type_traits>

#include <rtuwire/core/result.hpp>
#include <rtuwire/core/version.hpp>
#include <rtuwire/table/enumeration.hpp>
#include <rtuwire/table/register.hpp>
#include <rtuwire/wire/errc.hpp>

namespace rtuwire {
inline namespace RTUWIRE_BUILD {

/// `reg<known<valve>>` holds only what `enumerators<valve>` lists: any other word is `value_without_meaning`, read or
/// written. `reg<valve>` shows on reading whatever the device sent.
template <register_enumeration Enum> struct known {
    static_assert(enumerators<Enum>.size() > 0, "this enumeration lists no values: specialise enumerators for it");

    using value_type = Enum;
    static constexpr std::uint16_t word_count = 1;
    using words = std::array<std::uint16_t, 1>;

    [[nodiscard]] static constexpr result<Enum> from_words(words const& from) noexcept
    {
        if (not detail::has_meaning(detail::listed_words<Enum>(), from[0])) {
            return errc::value_without_meaning;
        }
        return static_cast<Enum>(from[0]);
    }
    [[nodiscard]] static constexpr words to_words(Enum value) noexcept { return {static_cast<std::uint16_t>(value)}; }
};

namespace detail {

/// What a field of a word can hold: what a word can, `known` enumerators, or a bool.
template <typename T>
concept field_value = register_value<T> or register_form<T> or std::same_as<T, bool>;

} // namespace detail

/// A value in `Width` bits of a word, from bit `Place` (0 is the lowest) on. A signed number is in two's complement. A
/// constant that is passed by reference, as a register is: `inline constexpr field<count16, 0, 4> gear{};`
template <detail::field_value T, unsigned Place, unsigned Width> struct field {
    static_assert(Width > 0 and Place < 16 and Width <= 16 - Place, "a field lies within the 16 bits of its word");
    static_assert(Width == 1 or not std::same_as<T, bool>, "a bool has one bit: name an enumeration or a number");

    using form = T;
    using value_type = typename detail::held_by<T>::type;
    static constexpr std::uint16_t ones = static_cast<std::uint16_t>((std::uint32_t{1} << Width) - 1U);
    static constexpr std::uint16_t mask = static_cast<std::uint16_t>(std::uint32_t{ones} << Place);

    /// Whether its numbers have a sign.
    static constexpr bool has_sign = [] {
        if constexpr (detail::register_quantity<value_type>) {
            return std::is_signed_v<typename value_type::rep>;
        }
        return false;
    }();

    /// The bits of the field, as a word of their own.
    [[nodiscard]] static constexpr std::uint16_t own_word(std::uint16_t word) noexcept
    {
        std::uint32_t const own = (std::uint32_t{word} >> Place) & ones;
        constexpr std::uint32_t sign = std::uint32_t{1} << (Width - 1U);
        bool const is_negative = has_sign and (own & sign) != 0;
        return static_cast<std::uint16_t>(is_negative ? own | ~std::uint32_t{ones} : own);
    }
};

namespace detail {

/// Whether fields of one word have no bit in common.
template <auto const&... Fields> [[nodiscard]] consteval bool are_apart() noexcept
{
    std::uint32_t taken = 0;
    bool are = true;
    ((are = are and (taken & Fields.mask) == 0, taken |= Fields.mask), ...);
    return are;
}

} // namespace detail

/// A word of fields. Bits of no field stay as they are.
template <auto const&... Fields> struct packed {
    static_assert(detail::are_apart<Fields...>(), "two fields of this word share a bit");

    using is_bit_field = void;
    std::uint16_t bits{0};

    /// The value of a field. Of `known` enumerators a result: `value_without_meaning` where the bits are in a hole.
    template <auto const& Field> [[nodiscard]] constexpr auto get() const noexcept
    {
        static_assert(contains<Field>, "this word has no such field");
        using field = std::remove_cvref_t<decltype(Field)>;
        std::uint16_t const own = field::own_word(bits);
        if constexpr (std::same_as<typename field::form, bool>) {
            return own != 0;
        } else if constexpr (register_form<typename field::form>) {
            return field::form::from_words({own});
        } else {
            return detail::from_word<typename field::value_type>(own);
        }
    }

    /// The same word with another value in a field; `value_too_high` or `value_too_low` where its bits do not hold it,
    /// `value_without_meaning` for an enumerator that is not known.
    template <auto const& Field>
    [[nodiscard]] constexpr result<packed>
    with(typename std::remove_cvref_t<decltype(Field)>::value_type value) const noexcept
    {
        static_assert(contains<Field>, "this word has no such field");
        using field = std::remove_cvref_t<decltype(Field)>;
        std::uint16_t word = 0;
        if constexpr (std::same_as<typename field::form, bool>) {
            word = value ? field::mask : std::uint16_t{0};
        } else {
            if constexpr (register_form<typename field::form>) {
                if (auto const known = field::form::from_words({detail::to_word(value)}); not known) {
                    return known.error();
                }
            }
            word = static_cast<std::uint16_t>((std::uint32_t{detail::to_word(value)} * (field::mask / field::ones)) &
                                              field::mask);
            if (field::own_word(word) != detail::to_word(value)) {
                return detail::raw_count<typename field::value_type>(detail::to_word(value)) < 0 ? errc::value_too_low
                                                                                                 : errc::value_too_high;
            }
        }
        return packed{static_cast<std::uint16_t>((std::uint32_t{bits} & ~std::uint32_t{field::mask}) | word)};
    }

    friend constexpr bool operator==(packed, packed) noexcept = default;

private:
    template <auto const& Field> static constexpr bool contains = (detail::is_same_register<Field, Fields> or ...);
};

} // namespace RTUWIRE_BUILD
} // namespace rtuwire
