// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// What is done with the registers of a catalog once they are there: compiled once, not for each drive.
#pragma once

#include <initializer_list>
#include <vector>

#include <rtuwire/altivar/own_parameters.hpp>

#include "catalog/catalog.hpp"

namespace tool {

void sort_by_address(std::vector<register_entry>& registers);

/// The groups of several maps as those of one.
[[nodiscard]] std::vector<rtuwire::altivar::parameter_group>
groups_of(std::initializer_list<rtuwire::altivar::parameter_map const*> maps);

/// Gives each register its row of a map, and the group that the map has it in.
void take_groups(std::vector<register_entry>& registers, std::vector<rtuwire::altivar::parameter_group> const& groups);

} // namespace tool
