// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// FreeRTOS/FreeRTOS-Kernel at 4269c69 (behind V11) with its port for GCC and Cortex-M3; ARM-software/CMSIS_5 5.9.0.
#include <Driver_USART.h>
#include <FreeRTOS.h>
#include <task.h>

#include "facts.hpp"

using std::int32_t, std::uint32_t;

// include/task.h
DECLARES(xTaskGetCurrentTaskHandle, TaskHandle_t());
DECLARES(vTaskGenericNotifyGiveFromISR, void(TaskHandle_t, UBaseType_t, BaseType_t*));
DECLARES(ulTaskGenericNotifyTake, uint32_t(UBaseType_t, BaseType_t, TickType_t));
// portable/GCC/ARM_CM3/portmacro.h, include/projdefs.h
static_assert(std::is_same_v<BaseType_t, long> and std::is_same_v<UBaseType_t, unsigned long>);
static_assert(std::is_same_v<TickType_t, uint32_t>);
VALUE(pdFALSE, 0);
VALUE(pdTRUE, 1);
// CMSIS/Driver/Include/Driver_USART.h and Driver_Common.h
static_assert(std::is_const_v<ARM_DRIVER_USART>);
static_assert(std::is_same_v<ARM_USART_SignalEvent_t, void (*)(uint32_t)>);
MEMBER(ARM_DRIVER_USART, GetCapabilities, ARM_USART_CAPABILITIES (*)());
MEMBER(ARM_DRIVER_USART, Initialize, int32_t (*)(ARM_USART_SignalEvent_t));
MEMBER(ARM_DRIVER_USART, PowerControl, int32_t (*)(ARM_POWER_STATE));
MEMBER(ARM_DRIVER_USART, Send, int32_t (*)(void const*, uint32_t));
MEMBER(ARM_DRIVER_USART, Receive, int32_t (*)(void*, uint32_t));
MEMBER(ARM_DRIVER_USART, Control, int32_t (*)(uint32_t, uint32_t));
static_assert(ARM_USART_CAPABILITIES{}.event_tx_complete == 0);
VALUE(ARM_POWER_FULL, 2);
VALUE(ARM_DRIVER_OK, 0);
VALUE(ARM_DRIVER_ERROR_BUSY, -2);
VALUE(ARM_USART_MODE_ASYNCHRONOUS, 1);
VALUE(ARM_USART_CONTROL_TX, 0x15);
VALUE(ARM_USART_CONTROL_RX, 0x16);
VALUE(ARM_USART_DATA_BITS_8, 0);
VALUE(ARM_USART_PARITY_EVEN, 0x1000);
VALUE(ARM_USART_STOP_BITS_1, 0);
VALUE(ARM_USART_EVENT_SEND_COMPLETE, 1);
VALUE(ARM_USART_EVENT_RECEIVE_COMPLETE, 2);
VALUE(ARM_USART_EVENT_TX_COMPLETE, 8);
VALUE(ARM_USART_EVENT_RX_OVERFLOW, 0x20);
VALUE(ARM_USART_EVENT_RX_BREAK, 0x80);
VALUE(ARM_USART_EVENT_RX_FRAMING_ERROR, 0x100);
VALUE(ARM_USART_EVENT_RX_PARITY_ERROR, 0x200);
