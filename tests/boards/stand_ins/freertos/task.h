// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Stands for the header of this name in FreeRTOS/FreeRTOS-Kernel 10.4.3 and later.
#pragma once

#include "FreeRTOS.h"

struct tskTaskControlBlock;
typedef tskTaskControlBlock* TaskHandle_t;
#define vTaskNotifyGiveFromISR(task, is_due) vTaskGenericNotifyGiveFromISR((task), 0, (is_due))
#define ulTaskNotifyTake(clear, ticks) ulTaskGenericNotifyTake(0, (clear), (ticks))

extern "C" {
TaskHandle_t xTaskGetCurrentTaskHandle();
void vTaskGenericNotifyGiveFromISR(TaskHandle_t task, UBaseType_t index, BaseType_t* is_due);
uint32_t ulTaskGenericNotifyTake(UBaseType_t index, BaseType_t clear, TickType_t ticks);
}
