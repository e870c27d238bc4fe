// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Stands for the header of this name in raspberrypi/pico-sdk 2.2.0, of which it declares what the board's file calls.
// ../../../facts/pico_sdk.cpp holds it to that.
#pragma once

#include "../pico/types.h"

enum gpio_function_t { GPIO_FUNC_UART = 2 };

extern "C" {
void gpio_init(uint gpio);
void gpio_set_dir(uint gpio, bool out);
void gpio_put(uint gpio, bool value);
void gpio_set_function(uint gpio, gpio_function_t function);
}
