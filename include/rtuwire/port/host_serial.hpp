// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// A serial device of this system, by one name on all.
#pragma once

#include <rtuwire/core/version.hpp>
#include <rtuwire/port/posix_serial.hpp>
#include <rtuwire/port/win32_serial.hpp>

namespace rtuwire {
inline namespace RTUWIRE_BUILD {

#ifdef _WIN32
using host_serial = win32_serial;
#else
using host_serial = posix_serial;
#endif

} // namespace RTUWIRE_BUILD
} // namespace rtuwire
