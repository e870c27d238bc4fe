// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// The file for STM32 behind a HAL that does what ST's does in its interrupt: a reception ends with its byte, and at an overrun;
// it refuses to begin one that goes on, and, as older ones do while the other direction holds its lock, now and then for
// nothing.
// PROCESSORS: cortex-m0plus cortex-m3 cortex-m4
#include "lives.hpp"

#include "../../examples/boards/stm32_hal.cpp"

#include "loop.hpp"

namespace {

USART_TypeDef usart{};
TIM_TypeDef timer{};
std::uint8_t* place = nullptr; // where a reception puts its byte
bool has_byte = false, is_overrun = false;
std::uint8_t data = 0;
unsigned calls = 0;
bool is_masked = false, is_sending = false;

/// HAL_UART_IRQHandler: the byte first, then the error, which ends the reception if it is an overrun that nobody began anew.
void interrupt()
{
    timer.CNT = stand_in::line.now_32();
    if (place == nullptr) { // its interrupts are off
        return;
    }
    bool const is_error = huart1.ErrorCode != HAL_UART_ERROR_NONE or is_overrun;
    if (is_overrun) {
        huart1.ErrorCode = huart1.ErrorCode | HAL_UART_ERROR_ORE;
        is_overrun = false;
    }
    if (has_byte) {
        *place = data;
        place = nullptr;
        has_byte = false;
        HAL_UART_RxCpltCallback(&huart1);
    }
    if (is_error) {
        if ((huart1.ErrorCode & HAL_UART_ERROR_ORE) != 0) {
            place = nullptr;
        }
        HAL_UART_ErrorCallback(&huart1);
        huart1.ErrorCode = HAL_UART_ERROR_NONE;
    }
}

void arrive(std::uint8_t byte, stand_in::arrival how)
{
    using stand_in::arrival;
    if (has_byte or how == arrival::overrun) { // the one in the data register stays
        is_overrun = true;
    } else {
        data = byte;
        has_byte = true;
        huart1.ErrorCode = huart1.ErrorCode | (how == arrival::parity    ? HAL_UART_ERROR_PE
                                               : how == arrival::framing ? HAL_UART_ERROR_FE
                                               : how == arrival::noise   ? HAL_UART_ERROR_NE
                                                                         : HAL_UART_ERROR_NONE);
    }
    interrupt();
}

struct stm32_hal : stand_in::loop_of_file {
    static constexpr line_timing timing{19'200, character_format::even_8_1};
    static void open()
    {
        huart1.Instance = &usart;
        htim2.Instance = &timer;
        stand_in::line.on_byte = arrive;
        stand_in::line.on_last_bit = [] {
            timer.CNT = stand_in::line.now_32();
            is_sending = false;
            HAL_UART_TxCpltCallback(&huart1);
        };
    }
    static void run() { run_modbus(); }
};

} // namespace

UART_HandleTypeDef huart1{};
TIM_HandleTypeDef htim2{};
GPIO_TypeDef port_a{};

void HAL_GPIO_WritePin(GPIO_TypeDef* port, uint16_t pin, GPIO_PinState state)
{
    stand_in::check(port == GPIOA and pin == GPIO_PIN_8, "the pin is PA8");
    stand_in::line.drive(state == GPIO_PIN_SET);
}

HAL_StatusTypeDef HAL_UART_Transmit_IT(UART_HandleTypeDef* uart, uint8_t const* bytes, uint16_t size)
{
    if (is_sending) {
        return HAL_BUSY;
    }
    is_sending = true;
    uart->ErrorCode = HAL_UART_ERROR_NONE;
    for (uint16_t i = 0; i < size; ++i) {
        stand_in::line.put(bytes[i]);
    }
    return HAL_OK;
}

HAL_StatusTypeDef HAL_UART_Receive_IT(UART_HandleTypeDef* uart, uint8_t* bytes, uint16_t size)
{
    stand_in::check(size == 1, "it receives byte by byte");
    if (place != nullptr or ++calls % 97 == 0) {
        return HAL_BUSY;
    }
    uart->ErrorCode = HAL_UART_ERROR_NONE;
    place = bytes;
    if (has_byte or is_overrun) {
        interrupt(); // what came meanwhile is waiting
    }
    return HAL_OK;
}

void __disable_irq() { is_masked = true; }
void __enable_irq() { is_masked = false; }
void __WFI()
{
    stand_in::check(is_masked, "no interrupt is slept over");
    stand_in::line.pass_to_event(1'000); // SysTick's comes each millisecond
    timer.CNT = stand_in::line.now_32();
}

int main() { return stand_in::live<stm32_hal>(value, trouble); }
