// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// The one list of the drives, for tests that try all of them.
#pragma once

#include <string>

#include "support/catch.hpp"
#include "support/type_list.hpp"

#include <rtuwire/altivar/atv12.hpp>
#include <rtuwire/altivar/atv28.hpp>
#include <rtuwire/altivar/atv310.hpp>
#include <rtuwire/altivar/atv320.hpp>

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

using all_drives = drive_list<altivar::atv12::device, altivar::atv28::device, altivar::atv310::device,
                              altivar::atv310::device_2026, altivar::atv320::device>;

/// All but the ATV28: their channels, time-out and factory settings stand in registers of the same names.
using later_drives =
    drive_list<altivar::atv12::device, altivar::atv310::device, altivar::atv310::device_2026, altivar::atv320::device>;

} // namespace rtuwire::test
