// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// ESP32 with ESP-IDF: a client on UART1, TX on GPIO 17, RX on 16. The driver of the UART itself enables that of the line, by
// RTS on GPIO 18, from the first start bit to the last stop bit.
#include <array>
#include <cstddef>
#include <cstdint>

#include <driver/uart.h>
#include <esp_err.h>
#include <esp_timer.h>
#include <freertos/FreeRTOS.h>
#include <freertos/queue.h>
#include <rtuwire/client.hpp>

using namespace rtuwire;

std::uint16_t value = 0;   // of the register: show it where trouble is errc::none
errc trouble = errc::busy; // why there is no value, in words name(trouble); busy until the first answer or time-out

namespace {

constexpr uart_port_t port = UART_NUM_1;
constexpr int transmit_pin = 17, receive_pin = 16, driver_enable = 18;
QueueHandle_t events = nullptr;

/// Microseconds of 64 bits, cut: they wrap at 32 bits and nowhere else.
instant now() { return instant{static_cast<std::uint32_t>(esp_timer_get_time())}; }

/// What the driver has kept is taken in each pass, whatever its events say: where its buffer is full, it stops receiving until then.
template <typename Engine> void receive(Engine& link)
{
    bool is_damaged = false;
    for (uart_event_t told{}; xQueueReceive(events, &told, 0) == pdTRUE;) {
        is_damaged = is_damaged or told.type != UART_DATA; // overrun, full buffer, parity, framing
    }
    std::array<std::byte, 128> place{};
    int const got = uart_read_bytes(port, place.data(), place.size(), 0);
    instant const at = now();
    if (is_damaged) {
        link.receive_error(at);
    }
    if (got > 0) {
        link.receive(byte_view{place}.first(static_cast<std::size_t>(got)), at);
    }
    link.advance(at);
}

template <typename Engine> void transmit(Engine& link)
{
    if (byte_view const frame = link.poll_transmit(); not frame.empty()) {
        uart_write_bytes(port, frame.data(), frame.size());
        ESP_ERROR_CHECK(uart_wait_tx_done(port, portMAX_DELAY)); // until the last stop bit has left
        link.sent(now());
    }
}

/// Until an event of the driver, or for a tick.
void rest()
{
    uart_event_t told{};
    xQueuePeek(events, &told, 1);
}

} // namespace

extern "C" void app_main()
{
    uart_config_t config{};
    config.baud_rate = 19'200;
    config.data_bits = UART_DATA_8_BITS;
    config.parity = UART_PARITY_EVEN;
    config.stop_bits = UART_STOP_BITS_1;
    // No buffer for sending: a write returns when all is in the FIFO.
    ESP_ERROR_CHECK(uart_driver_install(port, 512, 0, 16, &events, 0));
    ESP_ERROR_CHECK(uart_param_config(port, &config));
    ESP_ERROR_CHECK(uart_set_pin(port, transmit_pin, receive_pin, driver_enable, UART_PIN_NO_CHANGE));
    ESP_ERROR_CHECK(uart_set_mode(port, UART_MODE_RS485_HALF_DUPLEX));
    ESP_ERROR_CHECK(uart_set_rx_full_threshold(port, 1)); // bytes are passed on as they come
    // A task may run late by a tick: the times of a host.
    client link{line_timing::host(19'200, character_format::even_8_1)};
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
