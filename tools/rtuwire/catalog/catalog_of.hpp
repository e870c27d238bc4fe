// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// Makes a drive's catalog of its registers. Included by one file a drive, so that no file compiles for long.
#pragma once

#include <algorithm>
#include <array>
#include <iterator>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include <rtuwire/altivar/own_parameters.hpp>

#include "catalog/catalog.hpp"
#include "catalog/catalog_groups.hpp"

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

/// What the type of a register's values tells. Made once for each type, not for each register.
struct value_traits {
    register_kind kind;
    std::string_view unit{};
    step_size step{};
    std::span<rtuwire::named_value const> names{};
    std::span<rtuwire::named_value const> meanings{};
    std::span<std::string_view const, 16> bits{no_bit_names};
};

template <typename T> [[nodiscard]] consteval value_traits traits_of() noexcept
{
    if constexpr (rtuwire::bit_field<T>) {
        return {.kind = register_kind::bits, .bits = bit_names<typename T::bit_type>};
    } else if constexpr (rtuwire::register_enumeration<T>) {
        return {.kind = register_kind::enumeration, .names = rtuwire::enumerators<T>, .meanings = rtuwire::meanings<T>};
    } else {
        bool const has_sign = std::is_signed_v<typename T::rep>;
        return {.kind = has_sign ? register_kind::signed_number : register_kind::number,
                .unit = T::dimension::symbol,
                .step = {T::scale::num, T::scale::den}};
    }
}
template <typename T> inline constexpr value_traits traits = traits_of<T>();

/// One register. A template for each type of values, because the descriptor is an argument.
template <typename T> [[nodiscard]] constexpr register_entry entry_of(rtuwire::reg<T> const& from) noexcept
{
    value_traits const& type = traits<T>;
    return {.code = from.code,
            .address = from.address,
            .row = nullptr,
            .name = from.name,
            .group = {},
            .menu = {},
            .is_for_driving = false,
            .mode = from.mode,
            .kind = type.kind,
            .unit = type.unit,
            .step = type.step,
            .steps_set_by = from.steps_set_by,
            .min = from.min,
            .max = from.max,
            .gap_first = from.gap.first,
            .gap_last = from.gap.last,
            .factory = from.factory,
            .source = from.source,
            .names = type.names,
            .meanings = type.meanings,
            .bits = type.bits};
}

/// Adds the registers of a list, as they stand there. The list is a constant: a thousand of them cost the compiler little.
template <auto const&... Registers> void add_all_of(std::vector<register_entry>& to)
{
    static constexpr register_entry list[]{entry_of(Registers)...};
    to.insert(to.end(), std::begin(list), std::end(list));
}

template <auto const&... Registers> void add(std::vector<register_entry>& to, rtuwire::table<Registers...>)
{
    add_all_of<Registers...>(to);
}

template <auto const&... Registers>
void add(std::vector<register_entry>& to, rtuwire::altivar::parameter_list<Registers...>)
{
    add_all_of<Registers...>(to);
}

template <typename... Groups> void add(std::vector<register_entry>& to, rtuwire::altivar::grouped_table<Groups...>)
{
    (add(to, Groups{}), ...);
}

/// The registers of a table or a map, in the order of addresses; those of the drive's own table are marked.
template <typename Drive, typename Registers>
[[nodiscard]] std::vector<register_entry> registers_of(Registers registers)
{
    std::vector<register_entry> all;
    add(all, registers);
    for (register_entry& each : all) {
        each.is_for_driving = Drive::registers::has_address(each.address);
    }
    sort_by_address(all);
    return all;
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
