// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Stands for the header of this name in raspberrypi/pico-sdk 2.2.0, of which it declares what the board's file calls.
// ../../../facts/pico_sdk.cpp holds it to that.
#pragma once

#include "../pico/types.h"

#define UART_UARTDR_FE_BITS 0x00000100
#define UART_UARTDR_PE_BITS 0x00000200
#define UART_UARTDR_BE_BITS 0x00000400
#define UART_UARTDR_OE_BITS 0x00000800

struct uart_inst_t;
struct uart_hw_t {
    uint32_t volatile dr;
};
enum uart_parity_t { UART_PARITY_NONE, UART_PARITY_EVEN, UART_PARITY_ODD };

extern "C" {
extern uart_inst_t* const stand_in_uart1;
#define uart1 stand_in_uart1
uart_hw_t* uart_get_hw(uart_inst_t* uart);
uint uart_init(uart_inst_t* uart, uint baudrate);
void uart_set_format(uart_inst_t* uart, uint data_bits, uint stop_bits, uart_parity_t parity);
void uart_set_fifo_enabled(uart_inst_t* uart, bool enabled);
void uart_set_irqs_enabled(uart_inst_t* uart, bool rx_has_data, bool tx_needs_data);
bool uart_is_readable(uart_inst_t* uart);
void uart_write_blocking(uart_inst_t* uart, uint8_t const* src, size_t len);
void uart_tx_wait_blocking(uart_inst_t* uart);
}
