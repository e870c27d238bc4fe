// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// A call of an open device's driver. What makes such calls takes any callable of this form, so that tests have drivers.
#pragma once

#include <sys/ioctl.h>

#include <rtuwire/core/version.hpp>

namespace rtuwire {
inline namespace RTUWIRE_BUILD {

namespace detail {

/// Gets or sets what the driver of an open device has; errno says why where it does not.
struct driver_call {
    int device;
    template <typename Settings> bool operator()(unsigned long request, Settings& settings) const noexcept
    {
        return ::ioctl(device, request, &settings) == 0;
    }
};

} // namespace detail

} // namespace RTUWIRE_BUILD
} // namespace rtuwire
