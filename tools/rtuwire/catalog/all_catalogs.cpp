// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
#include "catalog/catalog.hpp"
#include "catalog/catalog_of.hpp"

#include <algorithm>
#include <deque>
#include <vector>

#include <rtuwire/altivar/all.hpp>

#include "catalog/rows_atv28.hpp"
#include "port/whole_drive.hpp"

namespace tool {

namespace {

namespace atv310 = rtuwire::altivar::atv310;
using rtuwire::altivar::parameter_group;
using rtuwire::altivar::parameter_map;

/// The groups of a drive with all its parameters.
template <typename Drive> std::vector<parameter_group> groups_of()
{
    std::vector<parameter_group> all;
    if constexpr (has_all_parameters<Drive>) {
        whole_drive<Drive>::type::registers::for_each_list(
            [&all](parameter_map const& each) { all.insert(all.end(), each.groups().begin(), each.groups().end()); });
    } else {
        all.assign(rows_of_atv28().begin(), rows_of_atv28().end());
    }
    return all;
}

/// The numbers of a drive's menu.
template <typename Drive> std::string_view menu_number(rtuwire::literal code)
{
    if constexpr (std::is_same_v<Drive, atv310::device>) {
        return atv310::menu_2014.number_of(code);
    } else if constexpr (std::is_same_v<Drive, atv310::device_2026>) {
        return atv310::menu_2026.number_of(code);
    } else {
        return {};
    }
}

template <auto const&... Registers> std::vector<type_names> names_of_types(rtuwire::table<Registers...>)
{
    return {names_in_type<rtuwire::value_of<Registers>>()...};
}

/// The identifiers of bits that a row lists.
std::span<std::string_view const, 16> listed_bits(std::span<rtuwire::choice const> bits)
{
    static std::deque<std::array<std::string_view, 16>> all;
    auto& names = all.emplace_back();
    for (rtuwire::choice const& each : bits) {
        names[each.word] = each.mnemonic;
    }
    return names;
}

/// A row as an entry. What the type of its values has in the drive's own table comes from there.
register_entry entry_of_row(rtuwire::altivar::parameter const& row, std::vector<type_names> const& types)
{
    auto const* const type = row.type.operator->();
    auto const found = std::ranges::find(types, type, &type_names::type);
    if (found != types.end()) {
        return entry_of(row, *found);
    }
    bool const is_of_bits = type->kind == rtuwire::parameter_kind::bits;
    return entry_of(
        row, {.type = type,
              .has_meanings = true,
              .bits = is_of_bits ? listed_bits(row.choices()) : std::span<std::string_view const, 16>{no_bit_names}});
}

template <typename Drive> std::vector<register_entry> registers_in(std::span<parameter_group const> groups)
{
    std::vector<type_names> const types = names_of_types(typename Drive::registers{});
    std::vector<register_entry> all;
    parameter_map{groups}.for_each([&](rtuwire::altivar::parameter const& row, parameter_group const& group) {
        register_entry& entry = all.emplace_back(entry_of_row(row, types));
        entry.row = &row;
        entry.group = group.name;
        entry.menu = menu_number<Drive>(row.code);
        entry.is_for_driving = Drive::registers::has_address(row.address);
    });
    std::ranges::sort(all, {}, &register_entry::address);
    return all;
}

template <typename Drive> drive_catalog const& catalog_with_rows()
{
    static auto const groups = groups_of<Drive>();
    static auto const registers = registers_in<Drive>(groups);
    static drive_catalog const catalog = catalog_of<Drive>(registers, groups);
    return catalog;
}

} // namespace

std::span<drive_catalog const* const> all_catalogs() noexcept
{
    static std::vector<drive_catalog const*> const all = [] {
        std::vector<drive_catalog const*> catalogs;
        rtuwire::altivar::all_drives::for_each(
            [&]<typename Drive>() { catalogs.push_back(&catalog_with_rows<Drive>()); });
        return catalogs;
    }();
    return all;
}

} // namespace tool
