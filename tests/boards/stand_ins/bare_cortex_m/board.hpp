// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Stands for examples/firmware/board.hpp and a board's own header: a UART that tells when it has room and when it is idle, a pin,
// a clock whose interrupt comes each millisecond.
#pragma once

#include <cstddef>

#include <rtuwire/frames.hpp>

void on_line_interrupt();
void on_tick();

namespace board {

struct received {
    std::byte value;
    bool is_damaged;
    bool is_after_loss;
};
struct line_uart {
    static bool has_byte();
    static received take();
    static bool has_room();
    static void put(std::byte value);
    static bool is_idle();
    static void clear_interrupts();
    static void request_interrupt();
};
struct driver_enable {
    static void set(bool is_on);
};

rtuwire::instant now();
void wait();
inline void start_interrupts() {}
template <typename Value> void print(Value const&) {}
template <typename Line> void sleep(Line const& line)
{
    if (line.is_served()) {
        wait();
    }
}

} // namespace board
