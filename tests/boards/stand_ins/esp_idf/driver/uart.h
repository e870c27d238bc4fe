// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Stands for the header of this name in espressif/esp-idf 6.0.2, of which it declares what the board's file calls.
// ../../../facts/esp_idf.cpp holds it to that.
#pragma once

#include <stddef.h>
#include <stdint.h>

#include "../esp_err.h"
#include "../freertos/queue.h"

#define UART_PIN_NO_CHANGE (-1)

enum uart_port_t { UART_NUM_0, UART_NUM_1 };
enum uart_mode_t { UART_MODE_UART = 0, UART_MODE_RS485_HALF_DUPLEX = 1 };
enum uart_word_length_t { UART_DATA_8_BITS = 3 };
enum uart_stop_bits_t { UART_STOP_BITS_1 = 1 };
enum uart_parity_t { UART_PARITY_DISABLE = 0, UART_PARITY_EVEN = 2, UART_PARITY_ODD = 3 };
enum uart_event_type_t { UART_DATA, UART_BREAK, UART_BUFFER_FULL, UART_FIFO_OVF, UART_FRAME_ERR, UART_PARITY_ERR };
struct uart_config_t {
    int baud_rate;
    uart_word_length_t data_bits;
    uart_parity_t parity;
    uart_stop_bits_t stop_bits;
};
struct uart_event_t {
    uart_event_type_t type;
    size_t size;
    bool timeout_flag;
};

extern "C" {
esp_err_t uart_driver_install(uart_port_t port, int rx_size, int tx_size, int queue_size, QueueHandle_t* queue,
                              int flags);
esp_err_t uart_param_config(uart_port_t port, uart_config_t const* config);
esp_err_t uart_set_pin(uart_port_t port, int tx, int rx, int rts, int cts);
esp_err_t uart_set_mode(uart_port_t port, uart_mode_t mode);
esp_err_t uart_set_rx_full_threshold(uart_port_t port, int threshold);
int uart_read_bytes(uart_port_t port, void* place, uint32_t length, uint32_t ticks);
int uart_write_bytes(uart_port_t port, void const* bytes, size_t size);
esp_err_t uart_wait_tx_done(uart_port_t port, uint32_t ticks);
}
