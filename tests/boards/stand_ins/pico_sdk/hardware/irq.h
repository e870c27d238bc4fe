// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Stands for the header of this name in raspberrypi/pico-sdk 2.2.0, of which it declares what the board's file calls.
// ../../../facts/pico_sdk.cpp holds it to that.
#pragma once

#include "../pico/types.h"

#define UART1_IRQ 21

typedef void (*irq_handler_t)();

extern "C" {
void irq_set_exclusive_handler(uint number, irq_handler_t handler);
void irq_set_enabled(uint number, bool enabled);
}
