// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// The one list of the drives that this library describes, with their registers. A program that wants one of them alone
// includes altivar/atv320.hpp or the like.
#pragma once

#include <cstddef>

#include <rtuwire/altivar/device/atv12.hpp>
#include <rtuwire/altivar/device/atv28.hpp>
#include <rtuwire/altivar/device/atv310.hpp>
#include <rtuwire/altivar/device/atv320.hpp>
#include <rtuwire/altivar/device/drive_type.hpp>
#include <rtuwire/core/version.hpp>

namespace rtuwire::inline RTUWIRE_BUILD::altivar {

/// Drives as types. Lists of one's own are made alike: `drive_list<pump_drive, altivar::atv320::device>`.
template <drive_type... Drives> struct drive_list {
    static constexpr std::size_t size = sizeof...(Drives);

    /// Calls `visit.template operator()<Drive>()` for each, in this order.
    template <typename Visit> static constexpr void for_each(Visit&& visit)
    {
        (visit.template operator()<Drives>(), ...);
    }
};

/// All drives of this library.
using all_drives = drive_list<atv12::device, atv28::device, atv310::device, atv310::device_2026, atv320::device>;

} // namespace rtuwire::altivar
