// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// What a program that must not go on still sends: one frame, made when compiling, straight to the UART. It uses
// no client, no queue and no interrupt, whose state may be wrong.
#pragma once

#include "board.hpp"

#include <rtuwire/frames.hpp>

namespace board {

/// So long, by SysTick's flag, which counts while interrupts are masked, too.
inline void wait_milliseconds(unsigned count)
{
    while (count > 0) {
        count -= at(0xE000'E010) >> 16U & 1U;
    }
}

/// Sends a frame twice, for one may meet what is still on the line: each time whatever was asked before had time to
/// be answered. Interrupts stay masked.
inline void send_last(rtuwire::byte_view frame)
{
    asm volatile("cpsid i" : : : "memory");
    for (int i = 0; i < 2; ++i) {
        driver_enable::set(false);
        wait_milliseconds(400);
        driver_enable::set(true);
        for (std::byte const each : frame) {
            while (not line_uart::has_room()) {
            }
            line_uart::put(each);
        }
        while (not line_uart::is_idle()) {
        }
        wait_milliseconds(2); // the last stop bit
    }
    driver_enable::set(false);
}

} // namespace board
