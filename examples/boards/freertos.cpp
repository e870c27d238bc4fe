// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// A task of FreeRTOS on a UART with a CMSIS driver: a client on Driver_USART1. Give `modbus_task` to xTaskCreate; it needs
// 2 KB of stack and a priority above what may run for more than a few milliseconds.
#include <cstddef>
#include <cstdint>

#include <Driver_USART.h>
#include <FreeRTOS.h>
#include <rtuwire/client.hpp>
#include <task.h>

using namespace rtuwire;

extern "C" ARM_DRIVER_USART Driver_USART1;
// Yours: a timer of 32 bits that counts microseconds, and the pin that enables the driver.
extern "C" std::uint32_t microseconds_gone();
extern "C" void enable_driver(bool is_on);

std::uint16_t value = 0;   // of the register: show it where trouble is errc::none
errc trouble = errc::busy; // why there is no value, in words name(trouble); busy until the first answer or time-out

namespace {

constinit interrupt_queue<> events;
std::uint8_t arrived = 0;
TaskHandle_t task = nullptr;

instant now() { return instant{microseconds_gone()}; }

/// A driver receives a byte and stops; it stops at an error, too. Where it receives, it is busy and this does nothing.
void listen() { Driver_USART1.Receive(&arrived, 1); }

void on_uart(std::uint32_t what) // in the interrupt
{
    if ((what & (ARM_USART_EVENT_RX_OVERFLOW | ARM_USART_EVENT_RX_BREAK | ARM_USART_EVENT_RX_FRAMING_ERROR |
                 ARM_USART_EVENT_RX_PARITY_ERROR)) != 0) {
        events.receive_error(now());
    } else if ((what & ARM_USART_EVENT_RECEIVE_COMPLETE) != 0) {
        events.receive(static_cast<std::byte>(arrived), now());
    }
    listen();
    if ((what & ARM_USART_EVENT_TX_COMPLETE) != 0) { // the last stop bit has left
        enable_driver(false);
        events.sent(now());
    }
    BaseType_t is_due = pdFALSE;
    vTaskNotifyGiveFromISR(task, &is_due);
    portYIELD_FROM_ISR(is_due);
}

template <typename Engine> void receive(Engine& link)
{
    listen(); // nothing that happens in the driver leaves the line deaf
    instant const at = now();
    events.deliver_to(link, at);
    link.advance(at);
}

template <typename Engine> void transmit(Engine& link)
{
    if (byte_view const frame = link.poll_transmit(); not frame.empty()) {
        enable_driver(true);
        if (Driver_USART1.Send(frame.data(), static_cast<std::uint32_t>(frame.size())) != ARM_DRIVER_OK) {
            enable_driver(false);
            link.sent(now()); // nothing left: the request's time-out tells
        }
    }
}

/// Until the interrupt, or for a tick.
void rest() { ulTaskNotifyTake(pdTRUE, 1); }

} // namespace

extern "C" void modbus_task(void*)
{
    task = xTaskGetCurrentTaskHandle();
    enable_driver(false);
    configASSERT(Driver_USART1.GetCapabilities().event_tx_complete != 0); // without it the driver's end is not known
    Driver_USART1.Initialize(on_uart);
    Driver_USART1.PowerControl(ARM_POWER_FULL);
    Driver_USART1.Control(
        ARM_USART_MODE_ASYNCHRONOUS | ARM_USART_DATA_BITS_8 | ARM_USART_PARITY_EVEN | ARM_USART_STOP_BITS_1, 19'200);
    Driver_USART1.Control(ARM_USART_CONTROL_TX, 1);
    Driver_USART1.Control(ARM_USART_CONTROL_RX, 1);
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
