// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// RP2040 and RP2350 with the plain pico-sdk: a client on UART1, TX on GPIO 4, RX on 5, driver enable on 3.
#include <cstddef>
#include <cstdint>

#include <hardware/gpio.h>
#include <hardware/irq.h>
#include <hardware/uart.h>
#include <pico/stdlib.h>
#include <rtuwire/client.hpp>

using namespace rtuwire;

std::uint16_t value = 0;   // of the register: show it where trouble is errc::none
errc trouble = errc::busy; // why there is no value, in words name(trouble); busy until the first answer or time-out

namespace {

constexpr uint transmit_pin = 4, receive_pin = 5, driver_enable = 3;
constinit interrupt_queue<> events;

instant now() { return instant{time_us_32()}; }

void on_uart()
{
    constexpr std::uint32_t damage = UART_UARTDR_FE_BITS | UART_UARTDR_PE_BITS | UART_UARTDR_BE_BITS;
    while (uart_is_readable(uart1)) {
        std::uint32_t const word = uart_get_hw(uart1)->dr;
        if ((word & UART_UARTDR_OE_BITS) != 0) { // the receiver goes on by itself
            events.receive_overrun(now());
        }
        if ((word & damage) != 0) {
            events.receive_error(now());
        } else {
            events.receive(static_cast<std::byte>(word & 0xFFU), now());
        }
    }
}

template <typename Engine> void receive(Engine& link)
{
    instant const at = now();
    events.deliver_to(link, at);
    link.advance(at);
}

template <typename Engine> void transmit(Engine& link)
{
    if (byte_view const frame = link.poll_transmit(); not frame.empty()) {
        gpio_put(driver_enable, true);
        uart_write_blocking(uart1, reinterpret_cast<std::uint8_t const*>(frame.data()), frame.size());
        uart_tx_wait_blocking(uart1); // until the last stop bit has left
        gpio_put(driver_enable, false);
        link.sent(now());
    }
}

/// Until an interrupt, or for a millisecond.
void rest() { best_effort_wfe_or_timeout(make_timeout_time_us(1'000)); }

} // namespace

int main()
{
    gpio_init(driver_enable);
    gpio_set_dir(driver_enable, true);
    gpio_put(driver_enable, false);
    uart_init(uart1, 19'200);
    uart_set_format(uart1, 8, 1, UART_PARITY_EVEN);
    uart_set_fifo_enabled(uart1, false); // an interrupt for each byte, and its time
    gpio_set_function(transmit_pin, GPIO_FUNC_UART);
    gpio_set_function(receive_pin, GPIO_FUNC_UART);
    irq_set_exclusive_handler(UART1_IRQ, on_uart);
    irq_set_enabled(UART1_IRQ, true);
    uart_set_irqs_enabled(uart1, true, false);
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
