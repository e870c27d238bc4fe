// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// The CRC alone, in the form that RTUWIRE_CRC_FORM names.
#include "board.hpp"

#include <array>

#include <rtuwire/core/crc16.hpp>

int main()
{
    std::array<std::byte, 8> frame;
    for (;;) {
        for (std::byte& each : frame) {
            each = board::byte();
        }
        board::put(static_cast<std::byte>(rtuwire::crc16(frame) & 0xFFU));
    }
}
