// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// The one list of the drives that this library describes. They are only named here, so that a program with one drive
// does not read the registers of all: those of one come with altivar/atv320.hpp or the like, all with altivar/all.hpp.
#pragma once

#include <cstddef>

#include <rtuwire/altivar/device/drive_type.hpp>
#include <rtuwire/core/version.hpp>

namespace rtuwire {
inline namespace RTUWIRE_BUILD {
namespace altivar {

namespace atv12 {
struct device;
}
namespace atv28 {
struct device;
}
namespace atv310 {
struct device;
struct device_2026;
} // namespace atv310
namespace atv320 {
struct device;
}

/// Whether a type is more than a name.
/// Internal.
template <typename T>
concept is_described = sizeof(T) > 0;

/// Drives as types. Lists of one's own are made alike: `drive_list<pump_drive, altivar::atv320::device>`.
template <typename... Drives> struct drive_list {
    static constexpr std::size_t size = sizeof...(Drives);

    /// Calls `visit.template operator()<Drive>()` for each, in this order.
    template <typename Visit> static constexpr void for_each(Visit&& visit)
    {
        static_assert((is_described<Drives> and ...), "the registers of a drive in this list are not included: include "
                                                      "rtuwire/altivar/all.hpp");
        if constexpr ((is_described<Drives> and ...)) {
            static_assert((drive_check<Drives>::passed and ...));
            (visit.template operator()<Drives>(), ...);
        }
    }
};

/// All drives of this library.
using all_drives = drive_list<atv12::device, atv28::device, atv310::device, atv310::device_2026, atv320::device>;

} // namespace altivar
} // namespace RTUWIRE_BUILD
} // namespace rtuwire
