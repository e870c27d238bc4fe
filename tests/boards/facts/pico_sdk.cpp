// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// raspberrypi/pico-sdk 2.2.0.
#include <hardware/gpio.h>
#include <hardware/irq.h>
#include <hardware/uart.h>
#include <pico/stdlib.h>

#include "facts.hpp"

using std::size_t, std::uint32_t, std::uint64_t, std::uint8_t;

// src/common/pico_base_headers/include/pico/types.h
static_assert(std::is_same_v<uint, unsigned int>);
static_assert(std::is_same_v<absolute_time_t, uint64_t>);
// src/rp2_common/hardware_uart/include/hardware/uart.h
static_assert(std::is_same_v<decltype(uart1), uart_inst_t*> or std::is_same_v<decltype(uart1), uart_inst_t* const>);
DECLARES(uart_get_hw, uart_hw_t*(uart_inst_t*));
DECLARES(uart_init, uint(uart_inst_t*, uint));
DECLARES(uart_set_format, void(uart_inst_t*, uint, uint, uart_parity_t));
DECLARES(uart_set_fifo_enabled, void(uart_inst_t*, bool));
DECLARES(uart_set_irqs_enabled, void(uart_inst_t*, bool, bool));
DECLARES(uart_is_readable, bool(uart_inst_t*));
DECLARES(uart_write_blocking, void(uart_inst_t*, uint8_t const*, size_t));
DECLARES(uart_tx_wait_blocking, void(uart_inst_t*));
VALUE(UART_PARITY_NONE, 0);
VALUE(UART_PARITY_EVEN, 1);
VALUE(UART_PARITY_ODD, 2);
// src/rp2040/hardware_structs/include/hardware/structs/uart.h and hardware_regs/include/hardware/regs/uart.h
MEMBER(uart_hw_t, dr, uint32_t volatile);
VALUE(UART_UARTDR_FE_BITS, 0x100);
VALUE(UART_UARTDR_PE_BITS, 0x200);
VALUE(UART_UARTDR_BE_BITS, 0x400);
VALUE(UART_UARTDR_OE_BITS, 0x800);
// src/rp2040/hardware_regs/include/hardware/regs/intctrl.h; 34 of RP2350
static_assert(UART1_IRQ == 21 or UART1_IRQ == 34);
// src/rp2_common/hardware_irq/include/hardware/irq.h
static_assert(std::is_same_v<irq_handler_t, void (*)()>);
DECLARES(irq_set_exclusive_handler, void(uint, irq_handler_t));
DECLARES(irq_set_enabled, void(uint, bool));
// src/rp2_common/hardware_gpio/include/hardware/gpio.h
DECLARES(gpio_init, void(uint));
DECLARES(gpio_set_dir, void(uint, bool));
DECLARES(gpio_put, void(uint, bool));
DECLARES(gpio_set_function, void(uint, gpio_function_t));
VALUE(GPIO_FUNC_UART, 2);
// src/rp2_common/hardware_timer, src/common/pico_time
DECLARES(time_us_32, uint32_t());
DECLARES(make_timeout_time_us, absolute_time_t(uint64_t));
DECLARES(best_effort_wfe_or_timeout, bool(absolute_time_t));
