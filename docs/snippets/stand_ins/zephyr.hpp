// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// The few functions of Zephyr that the page calls, with a simulated drive behind them.
#pragma once

#include "far_drive.hpp"

struct device {};
struct gpio_dt_spec {};
using uart_callback = void (*)(device const*, void*);

namespace stand_in {
inline device uart;
inline uart_callback on_uart{nullptr};
} // namespace stand_in

#define DT_NODELABEL(name) 0
#define DEVICE_DT_GET(node) (&stand_in::uart)
#define K_USEC(count) rtuwire::microseconds(count)

// Ticks of 100 us; the board has been on for so long that 32 bits of microseconds wrap in 7 ms.
inline std::int64_t k_uptime_ticks() { return 42'949'600 + stand_in::line.now().microseconds / 100; }
inline std::uint64_t k_ticks_to_us_floor64(std::uint64_t ticks) { return ticks * 100; }
inline int gpio_pin_set_dt(gpio_dt_spec const*, int) { return 0; }
inline int uart_irq_callback_user_data_set(device const*, uart_callback call, void*)
{
    stand_in::on_uart = call;
    return 0;
}
inline void uart_irq_rx_enable(device const*) {}
inline int uart_irq_update(device const*) { return 1; }
inline int uart_irq_rx_ready(device const*) { return stand_in::line.has_byte() ? 1 : 0; }
inline int uart_err_check(device const*) { return 0; }
inline int uart_fifo_read(device const*, std::uint8_t* place, int)
{
    if (not stand_in::line.has_byte()) {
        return 0;
    }
    *place = std::to_integer<std::uint8_t>(stand_in::line.take());
    return 1;
}
inline void uart_poll_out(device const*, unsigned char byte)
{
    static std::array<std::byte, 256> frame{};
    static std::size_t size = 0;
    frame[size++] = static_cast<std::byte>(byte);
    if (size == 8) { // the requests of this page have so many
        stand_in::line.send(rtuwire::byte_view{frame}.first(size));
        size = 0;
    }
}
inline int uart_irq_tx_complete(device const*) { return 1; }
inline void k_sleep(rtuwire::duration length)
{
    stand_in::line.wait(length);
    stand_in::on_uart(&stand_in::uart, nullptr);
}

using stand_in::show; // what the page leaves to its reader
