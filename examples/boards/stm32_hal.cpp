// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// STM32 with ST's HAL in a project of CubeMX: a client on USART1, PA8 enables the driver, TIM2 counts microseconds. main.c calls
// `run_modbus`, which never returns, behind its MX_..._Init(). docs/boards.md has the settings.
#include "main.h" // CubeMX's, with the HAL of your family

#include <cstddef>
#include <cstdint>

#include <rtuwire/client.hpp>

using namespace rtuwire;

extern "C" UART_HandleTypeDef huart1;
extern "C" TIM_HandleTypeDef htim2;

std::uint16_t value = 0;   // of the register: show it where trouble is errc::none
errc trouble = errc::busy; // why there is no value, in words name(trouble); busy until the first answer or time-out

namespace {

constinit interrupt_queue<> events;
std::uint8_t arrived = 0;

instant now() { return instant{htim2.Instance->CNT}; }

void enable_driver(bool is_on) { HAL_GPIO_WritePin(GPIOA, GPIO_PIN_8, is_on ? GPIO_PIN_SET : GPIO_PIN_RESET); }

/// The HAL receives a byte and stops; it stops at an overrun, too. Where it receives, it is busy and this does nothing.
void listen() { HAL_UART_Receive_IT(&huart1, &arrived, 1); }

template <typename Engine> void receive(Engine& link)
{
    listen(); // nothing that happens in the HAL leaves the line deaf
    instant const at = now();
    events.deliver_to(link, at);
    link.advance(at);
}

template <typename Engine> void transmit(Engine& link)
{
    if (byte_view const frame = link.poll_transmit(); not frame.empty()) {
        enable_driver(true);
        auto const* const bytes = reinterpret_cast<std::uint8_t const*>(frame.data());
        if (HAL_UART_Transmit_IT(&huart1, bytes, static_cast<std::uint16_t>(frame.size())) != HAL_OK) {
            enable_driver(false);
            link.sent(now()); // nothing left: the request's time-out tells
        }
    }
}

/// Until an interrupt: the line's, or SysTick's each millisecond.
void rest()
{
    __disable_irq();
    if (events.is_empty()) {
        __WFI();
    }
    __enable_irq();
}

} // namespace

// A project that has one of these three already calls ours from its own, by another name.
extern "C" void HAL_UART_RxCpltCallback(UART_HandleTypeDef* uart)
{
    if (uart == &huart1 and uart->ErrorCode == HAL_UART_ERROR_NONE) { // else HAL_UART_ErrorCallback comes next
        events.receive(static_cast<std::byte>(arrived), now());
        listen();
    }
}

extern "C" void HAL_UART_ErrorCallback(UART_HandleTypeDef* uart) // overrun, parity, framing, noise
{
    if (uart == &huart1) {
        events.receive_error(now());
        listen();
    }
}

extern "C" void HAL_UART_TxCpltCallback(UART_HandleTypeDef* uart) // the last stop bit has left
{
    if (uart == &huart1) {
        enable_driver(false);
        events.sent(now());
    }
}

extern "C" void run_modbus()
{
    client link{line_timing{19'200, character_format::even_8_1}};
    single_request ask{unit_id{7}, read_holding_registers{.start = 3201, .count = 1}};
    for (;;) {
        receive(link);
        link.converse(ask, now());
        if (ask.settled()) {
            auto const response = ask.outcome();
            trouble = response.error();
            value = response ? response->to<read_holding_registers>()->registers[0] : value;
            ask.again();
        }
        transmit(link);
        rest();
    }
}
