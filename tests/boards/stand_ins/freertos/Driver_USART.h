// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Stands for the header of this name in ARM-software/CMSIS_5 5.9.0, of which it declares what the board's file calls.
// ../../facts/freertos.cpp holds it to that.
#pragma once

#include <stdint.h>

#define ARM_DRIVER_OK 0
#define ARM_DRIVER_ERROR_BUSY -2
#define ARM_USART_MODE_ASYNCHRONOUS 0x01UL
#define ARM_USART_CONTROL_TX 0x15UL
#define ARM_USART_CONTROL_RX 0x16UL
#define ARM_USART_DATA_BITS_8 0UL
#define ARM_USART_PARITY_EVEN (1UL << 12)
#define ARM_USART_STOP_BITS_1 0UL
#define ARM_USART_EVENT_SEND_COMPLETE (1UL << 0)
#define ARM_USART_EVENT_RECEIVE_COMPLETE (1UL << 1)
#define ARM_USART_EVENT_TX_COMPLETE (1UL << 3)
#define ARM_USART_EVENT_RX_OVERFLOW (1UL << 5)
#define ARM_USART_EVENT_RX_BREAK (1UL << 7)
#define ARM_USART_EVENT_RX_FRAMING_ERROR (1UL << 8)
#define ARM_USART_EVENT_RX_PARITY_ERROR (1UL << 9)

enum ARM_POWER_STATE { ARM_POWER_OFF, ARM_POWER_LOW, ARM_POWER_FULL };
struct ARM_USART_CAPABILITIES {
    uint32_t asynchronous : 1;
    uint32_t event_tx_complete : 1;
};
typedef void (*ARM_USART_SignalEvent_t)(uint32_t event);
typedef struct {
    ARM_USART_CAPABILITIES (*GetCapabilities)();
    int32_t (*Initialize)(ARM_USART_SignalEvent_t on_event);
    int32_t (*PowerControl)(ARM_POWER_STATE state);
    int32_t (*Send)(void const* data, uint32_t count);
    int32_t (*Receive)(void* data, uint32_t count);
    int32_t (*Control)(uint32_t control, uint32_t argument);
} const ARM_DRIVER_USART;
