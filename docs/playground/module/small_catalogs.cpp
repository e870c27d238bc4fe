// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// The catalogs that frames are explained by, of the registers that the page's drives have. With all parameters of the command line
// tool's catalogs the module would be twice as large.
#include "catalog/catalog_of.hpp"

#include <algorithm>
#include <array>

#include <rtuwire/altivar/atv12.hpp>
#include <rtuwire/altivar/atv28.hpp>
#include <rtuwire/altivar/atv310.hpp>
#include <rtuwire/altivar/atv320.hpp>

namespace tool {

namespace {

/// The registers of a table, sorted by the compiler: the module has no code for that. What no text about a frame needs of
/// them would be a twentieth of the module.
template <auto const&... Registers> constexpr auto sorted(rtuwire::table<Registers...>)
{
    std::array<register_entry, sizeof...(Registers)> all{
        entry_of(rtuwire::altivar::row_of(Registers, rtuwire::altivar::roles::ordinary),
                 names_in_type<rtuwire::value_of<Registers>>())...};
    for (register_entry& each : all) {
        each.name = {};
        each.mode = {};
        each.min = each.max = {};
        each.factory.reset();
        each.source = {};
    }
    std::ranges::sort(all, {}, &register_entry::address);
    return all;
}

template <typename Drive> constexpr auto registers_of_drive = sorted(typename Drive::registers{});

template <typename Drive> drive_catalog const& small_catalog()
{
    static constexpr drive_catalog catalog = catalog_of<Drive>(registers_of_drive<Drive>, {});
    return catalog;
}

} // namespace

std::span<drive_catalog const* const> all_catalogs() noexcept
{
    static drive_catalog const* const all[]{
        &small_catalog<rtuwire::altivar::atv12::device>(), &small_catalog<rtuwire::altivar::atv28::device>(),
        &small_catalog<rtuwire::altivar::atv310::device>(), &small_catalog<rtuwire::altivar::atv310::device_2026>(),
        &small_catalog<rtuwire::altivar::atv320::device>()};
    return all;
}

} // namespace tool
