// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Stands for CubeMX's main.h and the HAL that it brings, of which it declares what the board's file calls, as
// STMicroelectronics/stm32f4xx-hal-driver 1.8.5 and cmsis_device_f4 2.6.9 do (and stm32g0xx-hal-driver 1.4.7). Values and
// types are held to them by ../../facts/stm32_hal.cpp.
#pragma once

#include <stdint.h>

typedef struct {
    uint32_t volatile SR, DR;
} USART_TypeDef;
typedef struct {
    uint32_t volatile CR1, CNT;
} TIM_TypeDef;
typedef struct {
    uint32_t volatile ODR;
} GPIO_TypeDef;

typedef enum { HAL_OK = 0, HAL_ERROR = 1, HAL_BUSY = 2, HAL_TIMEOUT = 3 } HAL_StatusTypeDef;
typedef enum { GPIO_PIN_RESET = 0, GPIO_PIN_SET } GPIO_PinState;
#define GPIO_PIN_8 ((uint16_t)0x0100)
#define HAL_UART_ERROR_NONE 0x00000000U
#define HAL_UART_ERROR_PE 0x00000001U
#define HAL_UART_ERROR_NE 0x00000002U
#define HAL_UART_ERROR_FE 0x00000004U
#define HAL_UART_ERROR_ORE 0x00000008U

typedef struct {
    USART_TypeDef* Instance;
    uint32_t volatile ErrorCode;
} UART_HandleTypeDef;
typedef struct {
    TIM_TypeDef* Instance;
} TIM_HandleTypeDef;

extern GPIO_TypeDef port_a;
#define GPIOA (&port_a)

extern "C" {
void HAL_GPIO_WritePin(GPIO_TypeDef* port, uint16_t pin, GPIO_PinState state);
HAL_StatusTypeDef HAL_UART_Transmit_IT(UART_HandleTypeDef* uart, uint8_t const* data, uint16_t size);
HAL_StatusTypeDef HAL_UART_Receive_IT(UART_HandleTypeDef* uart, uint8_t* data, uint16_t size);
void HAL_UART_TxCpltCallback(UART_HandleTypeDef* uart);
void HAL_UART_RxCpltCallback(UART_HandleTypeDef* uart);
void HAL_UART_ErrorCallback(UART_HandleTypeDef* uart);
void __disable_irq();
void __enable_irq();
void __WFI();
}
