// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
#include "catalog/catalog_drives.hpp"
#include "catalog/catalog_of.hpp"

#include <rtuwire/altivar/atv310_parameters.hpp>

namespace tool {

namespace atv310_map = rtuwire::altivar::atv310;

namespace {

/// The registers of a revision, with the numbers of its menu.
template <typename Device, typename FullDevice>
std::vector<register_entry> registers_of_revision(rtuwire::altivar::menu_numbers const& menu,
                                                  std::vector<rtuwire::altivar::parameter_group> const& groups)
{
    auto all = registers_of<Device>(typename FullDevice::registers{});
    take_groups(all, groups);
    for (register_entry& each : all) {
        each.menu = menu.number_of(each.code);
    }
    return all;
}

} // namespace

drive_catalog const& catalog_of_atv310() noexcept
{
    static auto const groups = groups_of({&atv310_map::parameters_2014});
    static auto const registers =
        registers_of_revision<atv310_map::device, atv310_map::full_device_2014>(atv310_map::menu_2014, groups);
    static drive_catalog const catalog = catalog_of<atv310_map::device>(registers, groups);
    return catalog;
}

drive_catalog const& catalog_of_atv310_2026() noexcept
{
    static auto const groups = groups_of({&atv310_map::parameters});
    static auto const registers =
        registers_of_revision<atv310_map::device_2026, atv310_map::full_device>(atv310_map::menu_2026, groups);
    static drive_catalog const catalog = catalog_of<atv310_map::device_2026>(registers, groups);
    return catalog;
}

} // namespace tool
