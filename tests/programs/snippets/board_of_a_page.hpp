// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// What the pages call the reader's own: a board.
#pragma once

#include <rtuwire/client.hpp>

namespace board {
rtuwire::instant now();
void sleep_until(rtuwire::deadline due);
void motor_off();
} // namespace board

struct transmitter {
    void set(bool is_on);
};
struct serial {
    bool is_damaged();
    void drop();
    bool has_byte();
    std::byte take();
    bool last_stop_bit_has_left();
    void send(rtuwire::byte_view frame);
};
struct display {
    template <typename Value> void show(Value const& value);
};
inline transmitter driver_enable;
inline serial uart;
inline display screen;
