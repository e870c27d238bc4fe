// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// espressif/esp-idf v6.0.2 and v5.1.6.
#include <driver/uart.h>
#include <esp_err.h>
#include <esp_timer.h>
#include <freertos/FreeRTOS.h>
#include <freertos/queue.h>

#include "facts.hpp"

using std::int64_t, std::size_t, std::uint32_t;

// components/esp_driver_uart/include/driver/uart.h
DECLARES(uart_driver_install, esp_err_t(uart_port_t, int, int, int, QueueHandle_t*, int));
DECLARES(uart_param_config, esp_err_t(uart_port_t, uart_config_t const*));
#ifndef uart_set_pin // a macro since 6.0, which takes two more pins, too
DECLARES(uart_set_pin, esp_err_t(uart_port_t, int, int, int, int));
#endif
DECLARES(uart_set_mode, esp_err_t(uart_port_t, uart_mode_t));
DECLARES(uart_set_rx_full_threshold, esp_err_t(uart_port_t, int));
DECLARES(uart_read_bytes, int(uart_port_t, void*, uint32_t, uint32_t));
DECLARES(uart_write_bytes, int(uart_port_t, void const*, size_t));
DECLARES(uart_wait_tx_done, esp_err_t(uart_port_t, uint32_t));
MEMBER(uart_config_t, baud_rate, int);
MEMBER(uart_config_t, data_bits, uart_word_length_t);
MEMBER(uart_config_t, parity, uart_parity_t);
MEMBER(uart_config_t, stop_bits, uart_stop_bits_t);
MEMBER(uart_event_t, type, uart_event_type_t);
MEMBER(uart_event_t, size, size_t);
MEMBER(uart_event_t, timeout_flag, bool);
VALUE(UART_DATA, 0);
VALUE(UART_BREAK, 1);
VALUE(UART_BUFFER_FULL, 2);
VALUE(UART_FIFO_OVF, 3);
VALUE(UART_FRAME_ERR, 4);
VALUE(UART_PARITY_ERR, 5);
VALUE(UART_PIN_NO_CHANGE, -1);
// components/esp_hal_uart/include/hal/uart_types.h
VALUE(UART_NUM_1, 1);
VALUE(UART_MODE_UART, 0);
VALUE(UART_MODE_RS485_HALF_DUPLEX, 1);
VALUE(UART_DATA_8_BITS, 3);
VALUE(UART_STOP_BITS_1, 1);
VALUE(UART_PARITY_DISABLE, 0);
VALUE(UART_PARITY_EVEN, 2);
VALUE(UART_PARITY_ODD, 3);
// components/esp_timer/include/esp_timer.h, components/esp_common/include/esp_err.h
DECLARES(esp_timer_get_time, int64_t());
static_assert(std::is_same_v<esp_err_t, int>);
VALUE(ESP_OK, 0);
// components/freertos/FreeRTOS-Kernel/include/freertos/queue.h
DECLARES(xQueueReceive, BaseType_t(QueueHandle_t, void*, TickType_t));
DECLARES(xQueuePeek, BaseType_t(QueueHandle_t, void*, TickType_t));
static_assert(std::is_same_v<TickType_t, uint32_t>);
VALUE(portMAX_DELAY, 0xFFFF'FFFF);
VALUE(pdTRUE, 1);
