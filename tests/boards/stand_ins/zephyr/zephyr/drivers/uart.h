// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Stands for the header of this name in zephyrproject-rtos/zephyr 4, of which it declares what the board's file calls.
// ../../../../facts/zephyr.cpp holds it to that.
#pragma once

#include <stdint.h>

#include "../device.h"

typedef void (*uart_irq_callback_user_data_t)(device const* dev, void* user_data);

extern "C" {
int uart_err_check(device const* dev);
int uart_fifo_fill(device const* dev, uint8_t const* tx_data, int size);
int uart_fifo_read(device const* dev, uint8_t* rx_data, int size);
void uart_irq_tx_enable(device const* dev);
void uart_irq_tx_disable(device const* dev);
int uart_irq_tx_ready(device const* dev);
void uart_irq_rx_enable(device const* dev);
int uart_irq_tx_complete(device const* dev);
int uart_irq_rx_ready(device const* dev);
void uart_irq_err_enable(device const* dev);
int uart_irq_update(device const* dev);
int uart_irq_callback_user_data_set(device const* dev, uart_irq_callback_user_data_t callback, void* user_data);
}
