// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Stands for the header of this name in FreeRTOS/FreeRTOS-Kernel 10.4.3 and later, and what a port brings with it, of which it
// declares what the board's file calls. ../../facts/freertos.cpp holds it to that.
#pragma once

#include <stdint.h>

typedef long BaseType_t;
typedef unsigned long UBaseType_t;
typedef uint32_t TickType_t;
#define pdFALSE ((BaseType_t)0)
#define pdTRUE ((BaseType_t)1)
void stand_in_assert(bool is_so);
void stand_in_yield(BaseType_t is_due);
#define configASSERT(x) stand_in_assert(x)
#define portYIELD_FROM_ISR(x) stand_in_yield(x)
