// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// The parameters of a drive that has a full map, by its name; each map is compiled in a file of its own.
#pragma once

#include <string_view>

#include <rtuwire/altivar/parameters/parameter_map.hpp>

struct maps_of {
    rtuwire::altivar::parameter_map const* parameters;
    rtuwire::altivar::parameter_map const* unverified; ///< null where the drive has none
};

maps_of maps_of_atv12();
maps_of maps_of_atv310();
maps_of maps_of_atv320();

/// Null where no drive of that name has a map.
maps_of const* maps_named(std::string_view drive);
