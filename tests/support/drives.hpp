// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// The library's list of its drives, for tests that try all of them.
#pragma once

#include <string>
#include <type_traits>

#include "support/catch.hpp"
#include "support/type_list.hpp"

#include <rtuwire/altivar/all.hpp>

namespace rtuwire::test {

template <typename... Devices> struct drive_list : type_list<Devices...> {
    /// Calls `visit.operator()<Device>()` for each; a check that fails inside tells the name of its drive.
    template <typename F> static void for_each(F const& visit)
    {
        type_list<Devices...>::for_each([&]<typename Device>() {
            INFO(std::string(Device::name.begin(), Device::name.end()));
            visit.template operator()<Device>();
        });
    }
};

/// The drives of a list for which `Has<Device>::value` is true.
template <template <typename> typename Has, typename Found, typename... Devices> struct chosen {
    using type = Found;
};
template <template <typename> typename Has, typename... Found, typename First, typename... Rest>
struct chosen<Has, drive_list<Found...>, First, Rest...>
    : chosen<Has, std::conditional_t<Has<First>::value, drive_list<Found..., First>, drive_list<Found...>>, Rest...> {};

template <typename List> struct tested;
template <typename... Devices> struct tested<altivar::drive_list<Devices...>> {
    using all = drive_list<Devices...>;
    template <template <typename> typename Has> using that_have = typename chosen<Has, drive_list<>, Devices...>::type;
};

using all_drives = tested<altivar::all_drives>::all;

/// All but the ATV28: their channels, time-out and factory settings stand in registers of the same names.
template <typename Device> using has_channels = std::bool_constant<(Device::layout.safeguards.chcf != 0)>;
using later_drives = tested<altivar::all_drives>::that_have<has_channels>;

} // namespace rtuwire::test
