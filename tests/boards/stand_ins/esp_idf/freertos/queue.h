// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Stands for the header of this name in espressif/esp-idf 6.0.2, of which it declares what the board's file calls.
#pragma once

#include "FreeRTOS.h"

struct QueueDefinition;
typedef QueueDefinition* QueueHandle_t;

extern "C" {
BaseType_t xQueueReceive(QueueHandle_t queue, void* buffer, TickType_t ticks);
BaseType_t xQueuePeek(QueueHandle_t queue, void* buffer, TickType_t ticks);
}
