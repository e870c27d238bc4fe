// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// Makes a drive's catalog of its registers.
#pragma once

#include <algorithm>
#include <array>
#include <string_view>
#include <utility>

#include <rtuwire/altivar/own_parameters.hpp>

#include "catalog/catalog.hpp"

namespace tool {

/// The identifier of an enumerator, as the compiler prints it; empty where the enumeration has none of this value.
template <auto Value> [[nodiscard]] consteval std::string_view enumerator_name() noexcept
{
    std::string_view const text = __PRETTY_FUNCTION__;
    std::size_t const first = text.find("Value = ") + 8;
    std::size_t const last = text.find_first_of(";]", first);
    std::string_view const value = text.substr(first, last - first);
    return value.starts_with('(') ? std::string_view{} : value.substr(value.rfind(':') + 1);
}

/// Its letters alone: a program that pointed into what the compiler prints would have all of that in it.
template <auto Value>
inline constexpr auto enumerator_letters = [] {
    constexpr std::string_view name = enumerator_name<Value>();
    std::array<char, name.size()> letters{};
    std::ranges::copy(name, letters.begin());
    return letters;
}();

/// The identifiers of a word's bits.
template <typename Bit>
inline constexpr std::array<std::string_view, 16> bit_names = []<std::size_t... At>(std::index_sequence<At...>)
{
    return std::array<std::string_view, 16>{std::string_view{enumerator_letters<static_cast<Bit>(At)>.data(),
                                                             enumerator_letters<static_cast<Bit>(At)>.size()}...};
}
(std::make_index_sequence<16>{});

inline constexpr std::array<std::string_view, 16> no_bit_names{};

/// What the rows of a type leave to the library: whether its texts have the meanings, and the identifiers of its bits.
struct type_names {
    rtuwire::parameter_type const* type;
    bool has_meanings{false};
    std::span<std::string_view const, 16> bits{no_bit_names};
};

template <typename T> [[nodiscard]] constexpr type_names names_in_type() noexcept
{
    if constexpr (rtuwire::bit_field<T>) {
        return {.type = &rtuwire::in<T>, .bits = bit_names<typename T::bit_type>};
    } else {
        return {.type = &rtuwire::in<T>, .has_meanings = rtuwire::meanings<T>.size() != 0};
    }
}

/// One register.
[[nodiscard]] constexpr register_entry entry_of(rtuwire::altivar::parameter const& from,
                                                type_names const& names) noexcept
{
    return {.code = from.code,
            .address = from.address,
            .row = nullptr,
            .name = from.name,
            .group = {},
            .menu = {},
            .is_for_driving = false,
            .mode = from.mode(),
            .kind = static_cast<register_kind>(from.type->kind),
            .unit = from.type->unit,
            .step = {from.type->step_numerator, from.type->step_denominator},
            .steps_set_by = from.steps_set_by,
            .min = from.min,
            .max = from.max,
            .gap_first = from.gap.first,
            .gap_last = from.gap.last,
            .factory = from.factory,
            .source = from.source(),
            .choices = from.choices(),
            .has_meanings = names.has_meanings,
            .bits = names.bits};
}

/// A drive's catalog. The registers and groups live as long.
template <typename Drive>
[[nodiscard]] constexpr drive_catalog catalog_of(std::span<register_entry const> registers,
                                                 std::span<rtuwire::altivar::parameter_group const> groups) noexcept
{
    return {.name = Drive::name,
            .reference = Drive::reference,
            .registers = registers,
            .map = rtuwire::altivar::parameter_map{groups},
            .limits = Drive::limits,
            .functions = Drive::functions,
            .units = Drive::units,
            .layout = Drive::layout,
            .speed_reference = Drive::speed_reference.address,
            .frequency_reference = Drive::frequency_reference.address};
}

} // namespace tool
