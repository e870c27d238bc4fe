// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
#include "catalog/catalog_drives.hpp"
#include "catalog/catalog_of.hpp"

#include <algorithm>
#include <tuple>

#include <rtuwire/altivar/atv28.hpp>

namespace tool {

namespace {

using atv28_device = rtuwire::altivar::atv28::device;
using rtuwire::altivar::parameter;

template <auto const&... Registers> std::vector<parameter> rows_of_table(rtuwire::table<Registers...>)
{
    auto const group = rtuwire::altivar::group_of<rtuwire::altivar::parameter_list<Registers...>>("all");
    return {group.rows.begin(), group.rows.end()};
}

bool is_command(parameter const& row)
{
    return row.address == atv28_device::layout.cmd or row.address == atv28_device::layout.cmi;
}

/// The rows of the table, what commands it first, then what is set, then what it shows, each by address.
std::vector<parameter> const& atv28_rows()
{
    static std::vector<parameter> const rows = [] {
        std::vector<parameter> all = rows_of_table(atv28_device::registers{});
        std::ranges::sort(all, {}, [](parameter const& each) {
            return std::tuple{not is_command(each), not each.is_writable(), each.address};
        });
        return all;
    }();
    return rows;
}

/// No public list has groups of this drive: three simple ones.
std::vector<rtuwire::altivar::parameter_group> atv28_groups()
{
    std::span<parameter const> const rows = atv28_rows();
    auto const first_setting = std::ranges::find_if_not(rows, is_command);
    auto const first_shown =
        std::find_if_not(first_setting, rows.end(), [](auto const& each) { return each.is_writable(); });
    return {{"command", {rows.begin(), first_setting}},
            {"settings", {first_setting, first_shown}},
            {"monitoring", {first_shown, rows.end()}}};
}

} // namespace

drive_catalog const& catalog_of_atv28() noexcept
{
    static auto const groups = atv28_groups();
    static std::vector<register_entry> const registers = [] {
        auto all = registers_of<atv28_device>(atv28_device::registers{});
        take_groups(all, groups);
        return all;
    }();
    static drive_catalog const catalog = catalog_of<atv28_device>(registers, groups);
    return catalog;
}

} // namespace tool
