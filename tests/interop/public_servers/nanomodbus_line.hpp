// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// What nanoMODBUS leaves to the application of a serial line.
#pragma once

#include <cstddef>
#include <cstdint>

#include <nanomodbus.h>
#include <poll.h>
#include <unistd.h>

#include "serial_line.hpp"

/// As the README wants it: until all have come, or one does not come in time.
inline std::int32_t read_bytes(std::uint8_t* to, std::uint16_t count, std::int32_t timeout_ms, void* device)
{
    std::int32_t got = 0;
    while (got < count) {
        pollfd waiting{*static_cast<int*>(device), POLLIN, 0};
        ssize_t const some =
            poll(&waiting, 1, timeout_ms) > 0 ? read(waiting.fd, to + got, static_cast<std::size_t>(count - got)) : 0;
        if (some <= 0) {
            break;
        }
        got += static_cast<std::int32_t>(some);
    }
    return got;
}

inline std::int32_t write_bytes(std::uint8_t const* from, std::uint16_t count, std::int32_t, void* device)
{
    return static_cast<std::int32_t>(write(*static_cast<int*>(device), from, count));
}

/// `device` has to outlive what is created with it.
inline nmbs_platform_conf nanomodbus_line(int& device)
{
    nmbs_platform_conf platform;
    nmbs_platform_conf_create(&platform);
    platform.transport = NMBS_TRANSPORT_RTU;
    platform.read = read_bytes;
    platform.write = write_bytes;
    platform.arg = &device;
    return platform;
}
