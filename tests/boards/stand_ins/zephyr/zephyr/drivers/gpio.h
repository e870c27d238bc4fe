// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Stands for the header of this name in zephyrproject-rtos/zephyr 4, of which it declares what the board's file calls.
#pragma once

#include "../device.h"

typedef uint32_t gpio_flags_t;
typedef uint8_t gpio_pin_t;
typedef uint16_t gpio_dt_flags_t;
struct gpio_dt_spec {
    device const* port;
    gpio_pin_t pin;
    gpio_dt_flags_t dt_flags;
};
#define GPIO_OUTPUT_INACTIVE ((1U << 17) | (1U << 18) | (1U << 20))
#define GPIO_DT_SPEC_GET(node, property)                                                                               \
    {                                                                                                                  \
        nullptr, 3, 0                                                                                                  \
    }

extern "C" {
int gpio_pin_configure_dt(gpio_dt_spec const* spec, gpio_flags_t extra_flags);
int gpio_pin_set_dt(gpio_dt_spec const* spec, int value);
}
