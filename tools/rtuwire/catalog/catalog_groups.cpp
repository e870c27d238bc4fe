// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
#include "catalog/catalog_groups.hpp"

#include <algorithm>

namespace tool {

void sort_by_address(std::vector<register_entry>& registers)
{
    std::ranges::sort(registers, {}, &register_entry::address);
}

std::vector<rtuwire::altivar::parameter_group>
groups_of(std::initializer_list<rtuwire::altivar::parameter_map const*> maps)
{
    std::vector<rtuwire::altivar::parameter_group> all;
    for (rtuwire::altivar::parameter_map const* const each : maps) {
        all.insert(all.end(), each->groups().begin(), each->groups().end());
    }
    return all;
}

void take_groups(std::vector<register_entry>& registers, std::vector<rtuwire::altivar::parameter_group> const& groups)
{
    rtuwire::altivar::parameter_map const map{groups};
    map.for_each([&](rtuwire::altivar::parameter const& row, rtuwire::altivar::parameter_group const& group) {
        auto const found = std::ranges::lower_bound(registers, row.address, {}, &register_entry::address);
        if (found != registers.end() and found->address == row.address) {
            found->row = &row;
            found->group = group.name;
        }
    });
}

} // namespace tool
