// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// The few functions of ESP-IDF that the page calls, with a simulated drive behind them.
#pragma once

#include <cstddef>

#include "far_drive.hpp"

using TickType_t = std::uint32_t;
enum uart_port_t { UART_NUM_1 };
enum { UART_DATA_8_BITS, UART_PARITY_EVEN, UART_STOP_BITS_1, UART_MODE_RS485_HALF_DUPLEX, UART_PIN_NO_CHANGE };
struct uart_config_t {
    int baud_rate, data_bits, parity, stop_bits;
};
inline constexpr TickType_t portMAX_DELAY = ~TickType_t{0};

inline void uart_driver_install(uart_port_t, int, int, int, void*, int) {}
inline void uart_param_config(uart_port_t, uart_config_t const*) {}
inline void uart_set_pin(uart_port_t, int, int, int, int) {}
inline void uart_set_mode(uart_port_t, int) {}
inline void uart_set_rx_full_threshold(uart_port_t, int) {}
inline std::int64_t esp_timer_get_time() { return stand_in::line.now().microseconds; }
inline void uart_wait_tx_done(uart_port_t, TickType_t) {}
inline void uart_write_bytes(uart_port_t, void const* bytes, std::size_t size)
{
    stand_in::line.send({static_cast<std::byte const*>(bytes), size});
}
inline int uart_read_bytes(uart_port_t, void* place, std::uint32_t size, TickType_t ticks)
{
    stand_in::line.wait(rtuwire::milliseconds(10 * ticks));
    auto* const out = static_cast<std::byte*>(place);
    int count = 0;
    while (stand_in::line.has_byte() and count < static_cast<int>(size)) {
        out[count++] = stand_in::line.take();
    }
    return count;
}

using stand_in::show; // what the page leaves to its reader
