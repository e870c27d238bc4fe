// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Drives by the names that a person gives them: "atv320".
#pragma once

#include <cstdint>
#include <string>
#include <type_traits>

#include <rtuwire/altivar/all.hpp>
#include <rtuwire/drives.hpp>

#include "usage_error.hpp"

namespace tool {

/// The names of all drives, as a usage line has them.
inline std::string drive_names()
{
    std::string names;
    rtuwire::altivar::all_drives::for_each([&names]<typename Drive>() {
        names += (names.empty() ? "" : "|") + std::string(Drive::name.begin(), Drive::name.end());
    });
    return names;
}

/// Calls `use` with the device of that name, as a `std::type_identity`. Refuses the name of none.
template <typename Use> void with_drive(std::string const& name, Use use)
{
    bool is_found = false;
    rtuwire::altivar::all_drives::for_each([&]<typename Drive>() {
        if (name == std::string(Drive::name.begin(), Drive::name.end())) {
            is_found = true;
            use(std::type_identity<Drive>{});
        }
    });
    if (not is_found) {
        throw usage_error{"there is no drive " + name + ", only " + drive_names()};
    }
}

/// The drive of that kind at a unit address. Refuses one out of the device's range.
template <rtuwire::device_type Device> rtuwire::station<Device> station_at(std::uint32_t unit, std::string const& name)
{
    auto const found = rtuwire::station<Device>::checked(unit);
    if (not found) {
        throw usage_error{"unit " + std::to_string(unit) + " is out of range: an " + name + " has one from " +
                          std::to_string(Device::units.first) + " to " + std::to_string(Device::units.last)};
    }
    return *found;
}

} // namespace tool
