// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// One parameter of a drive as a plain row, for a program that walks all of them. The compiler makes it of the register's
// descriptor, so nothing is written down twice.
#pragma once

#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <type_traits>

#include <rtuwire/core/literal.hpp>
#include <rtuwire/core/version.hpp>
#include <rtuwire/table/enumeration.hpp>
#include <rtuwire/table/register.hpp>

namespace rtuwire {
inline namespace RTUWIRE_BUILD {
namespace altivar {

/// What the word of a parameter is.
enum class parameter_kind : std::uint8_t { number, signed_number, bits, enumeration };

/// What the type of a parameter's values tells, once for all parameters of that type.
struct parameter_type {
    parameter_kind kind;
    literal unit{};                 ///< symbol of what is measured, "Hz"; empty where nothing is
    std::int32_t step_numerator{1}; ///< one count is this fraction of the unit
    std::int32_t step_denominator{1};
    std::span<named_value const> mnemonics{}; ///< of an enumeration: what the display shows for each value
    std::span<std::uint16_t const> listed{};  ///< of an enumeration: the values alone
    std::span<named_value const> meanings{};  ///< in words: of an enumeration's values, of the bits of a word by number
};

/// What the values of an enumeration, or the bits of a word, mean; specialised where the list for driving has no words.
/// Internal.
template <typename E> inline constexpr auto const& words_of = meanings<E>;

/// Internal.
template <detail::register_value T> [[nodiscard]] consteval parameter_type type_of() noexcept
{
    if constexpr (bit_field<T>) {
        return {.kind = parameter_kind::bits, .meanings = words_of<typename T::bit_type>};
    } else if constexpr (register_enumeration<T>) {
        return {.kind = parameter_kind::enumeration,
                .mnemonics = enumerators<T>,
                .listed = detail::listed_words<T>(),
                .meanings = words_of<T>};
    } else {
        return {.kind = std::is_signed_v<typename T::rep> ? parameter_kind::signed_number : parameter_kind::number,
                .unit = T::dimension::symbol,
                .step_numerator = T::scale::num,
                .step_denominator = T::scale::den};
    }
}
/// Internal.
template <detail::register_value T> inline constexpr parameter_type type_facts = type_of<T>();

/// One parameter.
struct parameter {
    literal code; ///< the mnemonic, in upper case
    literal name; ///< for display
    std::uint16_t address;
    access mode;
    provenance source;
    parameter_type const* type;
    bound min;                           ///< in raw counts, or by another register
    bound max;                           ///< in raw counts, or by another register
    std::optional<std::int32_t> factory; ///< in raw counts, where known
    literal steps_set_by;                ///< the register that sets the size of a step; empty where none does
    detail::count_range gap;             ///< raw counts inside the limits that are never written

    /// Whether it can be written at all.
    [[nodiscard]] constexpr bool is_writable() const noexcept { return mode != access::read_only; }

    /// The count that a word on the wire stands for: below zero only in a register of signed numbers.
    [[nodiscard]] constexpr std::int32_t count_of(std::uint16_t word) const noexcept
    {
        return type->kind == parameter_kind::signed_number ? std::int32_t{static_cast<std::int16_t>(word)}
                                                           : std::int32_t{word};
    }

    /// Whether a count lies within the limits, as far as they do not depend on another register, and not in the gap, and is
    /// one of the values that the enumeration lists.
    [[nodiscard]] constexpr bool takes(std::int32_t count) const noexcept
    {
        bool const is_signed = type->kind == parameter_kind::signed_number;
        std::int64_t const lowest = min.is_number() ? min.raw() : is_signed ? -32'768 : 0;
        std::int64_t const highest = max.is_number() ? max.raw() : is_signed ? 32'767 : 65'535;
        return count >= lowest and count <= highest and not gap.contains(count) and
               (type->mnemonics.empty() or
                detail::listed_name(type->mnemonics, static_cast<std::uint16_t>(count)).size() != 0);
    }
};

/// A register as a row. A template for each type of values, not for each register.
/// Internal.
template <detail::register_value T> [[nodiscard]] constexpr parameter parameter_of(reg<T> const& from) noexcept
{
    return {.code = from.code,
            .name = from.name,
            .address = from.address,
            .mode = from.mode,
            .source = from.source,
            .type = &type_facts<T>,
            .min = from.min,
            .max = from.max,
            .factory = from.factory,
            .steps_set_by = from.steps_set_by,
            .gap = from.gap};
}

} // namespace altivar
} // namespace RTUWIRE_BUILD
} // namespace rtuwire
