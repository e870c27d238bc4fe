// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// STMicroelectronics/stm32f4xx-hal-driver v1.8.5 with cmsis_device_f4 v2.6.9, and stm32g0xx-hal-driver v1.4.7 with cmsis_device_g0.
#include "main.h"

#include "facts.hpp"

using std::uint16_t, std::uint32_t, std::uint8_t;

// Inc/stm32f4xx_hal_uart.h
DECLARES(HAL_UART_Transmit_IT, HAL_StatusTypeDef(UART_HandleTypeDef*, uint8_t const*, uint16_t));
DECLARES(HAL_UART_Receive_IT, HAL_StatusTypeDef(UART_HandleTypeDef*, uint8_t*, uint16_t));
DECLARES(HAL_UART_TxCpltCallback, void(UART_HandleTypeDef*));
DECLARES(HAL_UART_RxCpltCallback, void(UART_HandleTypeDef*));
DECLARES(HAL_UART_ErrorCallback, void(UART_HandleTypeDef*));
MEMBER(UART_HandleTypeDef, Instance, USART_TypeDef*);
MEMBER(UART_HandleTypeDef, ErrorCode, uint32_t volatile);
VALUE(HAL_UART_ERROR_NONE, 0);
VALUE(HAL_UART_ERROR_PE, 1);
VALUE(HAL_UART_ERROR_NE, 2);
VALUE(HAL_UART_ERROR_FE, 4);
VALUE(HAL_UART_ERROR_ORE, 8);
// Inc/stm32f4xx_hal_def.h
VALUE(HAL_OK, 0);
VALUE(HAL_ERROR, 1);
VALUE(HAL_BUSY, 2);
VALUE(HAL_TIMEOUT, 3);
// Inc/stm32f4xx_hal_gpio.h
DECLARES(HAL_GPIO_WritePin, void(GPIO_TypeDef*, uint16_t, GPIO_PinState));
VALUE(GPIO_PIN_8, 0x100);
VALUE(GPIO_PIN_RESET, 0);
VALUE(GPIO_PIN_SET, 1);
static_assert(std::is_same_v<decltype(GPIOA), GPIO_TypeDef*>);
// Inc/stm32f4xx_hal_tim.h, Include/stm32f407xx.h of cmsis_device_f4
MEMBER(TIM_HandleTypeDef, Instance, TIM_TypeDef*);
MEMBER(TIM_TypeDef, CNT, uint32_t volatile);
// CMSIS/Core/Include/cmsis_gcc.h of ARM-software/CMSIS_5, in which the last is a macro
DECLARES(__disable_irq, void());
DECLARES(__enable_irq, void());
#ifndef __WFI
DECLARES(__WFI, void());
#endif
