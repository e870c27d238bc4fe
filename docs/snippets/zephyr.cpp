// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// What the page of Zephyr shows, run with stand-ins for its UART, pins and clock.
//! [page]
#include <cstddef>
#include <cstdint>

#include <rtuwire/altivar/atv320.hpp>
#include <rtuwire/client.hpp>
#include <zephyr/drivers/gpio.h>
#include <zephyr/drivers/uart.h>
#include <zephyr/kernel.h>

using namespace rtuwire;

namespace {

constexpr station<altivar::atv320::device> drive{unit_id{7}};
device const* const uart = DEVICE_DT_GET(DT_NODELABEL(uart1));
gpio_dt_spec const driver_enable{}; // GPIO_DT_SPEC_GET of a pin of your board
constinit interrupt_queue<> events;

/// Microseconds of 64 bits, cut: they have to wrap at 32 bits and nowhere else.
instant now()
{
    auto const ticks = static_cast<std::uint64_t>(k_uptime_ticks());
    return instant{static_cast<std::uint32_t>(k_ticks_to_us_floor64(ticks))};
}

void on_uart(device const* from, void*)
{
    while (uart_irq_update(from) != 0 and uart_irq_rx_ready(from) != 0) {
        std::uint8_t byte = 0;
        bool const is_damaged = uart_err_check(from) != 0;
        while (uart_fifo_read(from, &byte, 1) == 1) {
            events.receive(static_cast<std::byte>(byte), now());
        }
        if (is_damaged) {
            events.receive_error(now());
        }
    }
}

void send(client& link, byte_view frame)
{
    gpio_pin_set_dt(&driver_enable, 1);
    for (std::byte const each : frame) {
        uart_poll_out(uart, std::to_integer<unsigned char>(each));
    }
    while (uart_irq_tx_complete(uart) == 0) { // the last stop bit
    }
    gpio_pin_set_dt(&driver_enable, 0);
    link.sent(now());
}

} // namespace

int main()
{
    uart_irq_callback_user_data_set(uart, on_uart, nullptr);
    uart_irq_rx_enable(uart);
    client link{line_timing{19'200, character_format::even_8_1}};
    poller<read_plan<altivar::atv320::device, altivar::atv320::eta, altivar::atv320::rfr>> panel{drive};
    for (;;) {
        events.deliver_to(link, now());
        link.advance(now());
        link.converse(panel, now());
        if (panel.settled()) {
            if (panel.outcome()) {
                show(panel.latest().get<altivar::atv320::rfr>());
            }
            panel.again();
        }
        if (byte_view const frame = link.poll_transmit(); not frame.empty()) {
            send(link, frame);
        }
        k_sleep(K_USEC(500));
    }
}
//! [page]
