// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// The task of FreeRTOS behind a CMSIS driver of the least that its interface promises: a reception ends with its byte and with
// an error, and what comes while none goes on is lost.
// PROCESSORS: cortex-m0plus cortex-m3 cortex-m4 rv32imc
#include "lives.hpp"

#include "../../examples/boards/freertos.cpp"

#include "loop.hpp"

namespace {

ARM_USART_SignalEvent_t on_event = nullptr;
std::uint8_t* place = nullptr;
bool is_on = false, is_notified = false;
unsigned calls = 0;
std::uint32_t format = 0;

void arrive(std::uint8_t byte, stand_in::arrival how)
{
    using stand_in::arrival;
    if (place == nullptr or not is_on) {
        return;
    }
    std::uint32_t what = ARM_USART_EVENT_RECEIVE_COMPLETE;
    switch (how) {
    case arrival::good: break;
    case arrival::parity: what |= ARM_USART_EVENT_RX_PARITY_ERROR; break;
    case arrival::framing: what |= ARM_USART_EVENT_RX_FRAMING_ERROR; break;
    case arrival::noise: what |= ARM_USART_EVENT_RX_BREAK; break;
    case arrival::overrun: what = ARM_USART_EVENT_RX_OVERFLOW; break;
    }
    *place = byte;
    place = nullptr;
    on_event(what);
}

struct freertos : stand_in::loop_of_file {
    static constexpr line_timing timing{19'200, character_format::even_8_1};
    static void open()
    {
        stand_in::line.on_byte = arrive;
        stand_in::line.on_last_bit = [] { on_event(ARM_USART_EVENT_TX_COMPLETE); };
    }
    static void run() { modbus_task(nullptr); }
};

} // namespace

ARM_DRIVER_USART Driver_USART1{.GetCapabilities =
                                   [] {
                                       return ARM_USART_CAPABILITIES{1, 1};
                                   },
                               .Initialize =
                                   [](ARM_USART_SignalEvent_t event) {
                                       on_event = event;
                                       return ARM_DRIVER_OK;
                                   },
                               .PowerControl =
                                   [](ARM_POWER_STATE state) {
                                       stand_in::check(state == ARM_POWER_FULL, "the UART has power");
                                       return ARM_DRIVER_OK;
                                   },
                               .Send =
                                   [](void const* data, uint32_t count) {
                                       if (not stand_in::line.is_idle()) {
                                           return ARM_DRIVER_ERROR_BUSY;
                                       }
                                       for (uint32_t i = 0; i < count; ++i) {
                                           stand_in::line.put(static_cast<std::uint8_t const*>(data)[i]);
                                       }
                                       return ARM_DRIVER_OK;
                                   },
                               .Receive =
                                   [](void* data, uint32_t count) {
                                       stand_in::check(count == 1 and format != 0, "it receives byte by byte, as 8E1");
                                       if (place != nullptr or ++calls % 97 == 0) {
                                           return ARM_DRIVER_ERROR_BUSY;
                                       }
                                       place = static_cast<std::uint8_t*>(data);
                                       return ARM_DRIVER_OK;
                                   },
                               .Control =
                                   [](uint32_t control, uint32_t argument) {
                                       format = control == 0x1001 and argument == 19'200
                                                    ? control
                                                    : format; // asynchronous, even parity
                                       is_on = is_on or (control == ARM_USART_CONTROL_RX and argument == 1);
                                       return ARM_DRIVER_OK;
                                   }};

std::uint32_t microseconds_gone() { return stand_in::line.now_32(); }
void enable_driver(bool is_it) { stand_in::line.drive(is_it); }
void stand_in_assert(bool is_so) { stand_in::check(is_so, "what the task asserts"); }
void stand_in_yield(BaseType_t) {}
TaskHandle_t xTaskGetCurrentTaskHandle() { return nullptr; }
void vTaskGenericNotifyGiveFromISR(TaskHandle_t, UBaseType_t, BaseType_t* is_due)
{
    is_notified = true;
    *is_due = pdTRUE;
}
uint32_t ulTaskGenericNotifyTake(UBaseType_t, BaseType_t, TickType_t ticks)
{
    stand_in::check(ticks >= 1, "other tasks get their time");
    if (not is_notified) {
        stand_in::line.pass_to_event(1'000);
    }
    is_notified = false;
    return 1;
}

int main() { return stand_in::live<freertos>(value, trouble); }
