// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
#include "catalog/catalog_drives.hpp"
#include "catalog/catalog_of.hpp"

#include <rtuwire/altivar/atv320_parameters.hpp>

namespace tool {

namespace atv320_map = rtuwire::altivar::atv320;

drive_catalog const& catalog_of_atv320() noexcept
{
    static auto const groups = groups_of({&atv320_map::parameters, &atv320_map::unverified_parameters});
    static std::vector<register_entry> const registers = [] {
        auto all = registers_of<atv320_map::device>(atv320_map::full_device::registers{});
        take_groups(all, groups);
        return all;
    }();
    static drive_catalog const catalog = catalog_of<atv320_map::device>(registers, groups);
    return catalog;
}

} // namespace tool
