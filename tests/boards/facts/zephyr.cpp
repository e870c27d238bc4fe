// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// zephyrproject-rtos/zephyr 4, include/zephyr/drivers/uart.h (at 04247de), gpio.h and kernel.h. Read; not compiled with these.
#include <zephyr/drivers/gpio.h>
#include <zephyr/drivers/uart.h>
#include <zephyr/kernel.h>

#include "facts.hpp"

using std::int64_t, std::uint64_t, std::uint8_t, std::uint16_t, std::uint32_t;

static_assert(std::is_same_v<uart_irq_callback_user_data_t, void (*)(device const*, void*)>);
DECLARES(uart_err_check, int(device const*));
DECLARES(uart_fifo_fill, int(device const*, uint8_t const*, int));
DECLARES(uart_fifo_read, int(device const*, uint8_t*, int));
DECLARES(uart_irq_tx_enable, void(device const*));
DECLARES(uart_irq_tx_disable, void(device const*));
DECLARES(uart_irq_tx_ready, int(device const*));
DECLARES(uart_irq_rx_enable, void(device const*));
DECLARES(uart_irq_tx_complete, int(device const*));
DECLARES(uart_irq_rx_ready, int(device const*));
DECLARES(uart_irq_err_enable, void(device const*));
DECLARES(uart_irq_update, int(device const*));
DECLARES(uart_irq_callback_user_data_set, int(device const*, uart_irq_callback_user_data_t, void*));
DECLARES(gpio_pin_configure_dt, int(gpio_dt_spec const*, gpio_flags_t));
DECLARES(gpio_pin_set_dt, int(gpio_dt_spec const*, int));
MEMBER(gpio_dt_spec, port, device const*);
MEMBER(gpio_dt_spec, pin, uint8_t);
MEMBER(gpio_dt_spec, dt_flags, uint16_t);
static_assert(std::is_same_v<gpio_flags_t, uint32_t>);
VALUE(GPIO_OUTPUT_INACTIVE, 0x160000);
static_assert(std::is_same_v<decltype(K_USEC(1'000)), k_timeout_t>);
DECLARES(k_uptime_ticks, int64_t());
DECLARES(k_ticks_to_us_floor64, uint64_t(uint64_t));
DECLARES(k_sem_take, int(k_sem*, k_timeout_t));
DECLARES(k_sem_give, void(k_sem*));
