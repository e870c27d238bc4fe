// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// What nanoMODBUS is given of the board: two functions that wait for bytes and send them.
#pragma once

#include "../images/board.hpp"

#include <nanomodbus.h>

/// Up to `count` bytes, each at most so much later than the one before; without waiting where that is 0.
inline std::int32_t read_bytes(std::uint8_t* to, std::uint16_t count, std::int32_t timeout_ms, void*)
{
    std::uint32_t const timeout = static_cast<std::uint32_t>(timeout_ms) * 1'000U;
    std::uint32_t since = board::now().microseconds;
    std::uint16_t got = 0;
    while (got < count) {
        if (board::has_byte()) {
            to[got++] = static_cast<std::uint8_t>(board::byte());
            since = board::now().microseconds;
        } else if (board::now().microseconds - since >= timeout) {
            break;
        }
    }
    return got;
}

inline std::int32_t write_bytes(std::uint8_t const* from, std::uint16_t count, std::int32_t, void*)
{
    board::put({reinterpret_cast<std::byte const*>(from), count});
    return count;
}

inline nmbs_platform_conf board_platform()
{
    nmbs_platform_conf platform;
    nmbs_platform_conf_create(&platform);
    platform.transport = NMBS_TRANSPORT_RTU;
    platform.read = read_bytes;
    platform.write = write_bytes;
    return platform;
}

inline void set_timeouts(nmbs_t& link)
{
    nmbs_set_byte_timeout(&link, 10);
    nmbs_set_read_timeout(&link, 1'000);
}
