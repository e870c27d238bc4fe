// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Zephyr: a client on the UART that the devicetree's alias modbus-uart names; driver-enable-gpios of zephyr,user is the driver's pin.
#include <atomic>
#include <cstddef>
#include <cstdint>

#include <rtuwire/client.hpp>
#include <zephyr/drivers/gpio.h>
#include <zephyr/drivers/uart.h>
#include <zephyr/kernel.h>

using namespace rtuwire;

std::uint16_t value = 0;   // of the register: show it where trouble is errc::none
errc trouble = errc::busy; // why there is no value, in words name(trouble); busy until the first answer or time-out

namespace {

device const* const uart = DEVICE_DT_GET(DT_ALIAS(modbus_uart));
gpio_dt_spec const driver_enable = GPIO_DT_SPEC_GET(DT_PATH(zephyr_user), driver_enable_gpios);
K_SEM_DEFINE(woken, 0, 1);
constinit interrupt_queue<> events;
byte_view rest_of_frame; // the interrupt's while it sends
std::atomic<bool> is_sending{false};

/// Microseconds of 64 bits, cut: they wrap at 32 bits and nowhere else.
instant now()
{
    return instant{static_cast<std::uint32_t>(k_ticks_to_us_floor64(static_cast<std::uint64_t>(k_uptime_ticks())))};
}

void on_uart(device const*, void*) // in the interrupt
{
    uart_irq_update(uart);
    if (uart_err_check(uart) > 0) { // clears an overrun, too, which would stop the receiver
        events.receive_error(now());
    }
    for (std::uint8_t byte = 0; uart_irq_rx_ready(uart) > 0 and uart_fifo_read(uart, &byte, 1) == 1;) {
        events.receive(static_cast<std::byte>(byte), now());
    }
    if (is_sending and not rest_of_frame.empty() and uart_irq_tx_ready(uart) > 0) {
        auto const* const bytes = reinterpret_cast<std::uint8_t const*>(rest_of_frame.data());
        int const taken = uart_fifo_fill(uart, bytes, static_cast<int>(rest_of_frame.size()));
        rest_of_frame = rest_of_frame.subspan(taken > 0 ? static_cast<std::size_t>(taken) : 0);
    } else if (is_sending and rest_of_frame.empty() and uart_irq_tx_complete(uart) > 0) { // the last stop bit has left
        uart_irq_tx_disable(uart);
        gpio_pin_set_dt(&driver_enable, 0);
        is_sending = false;
        events.sent(now());
    }
    k_sem_give(&woken);
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
        rest_of_frame = frame;
        gpio_pin_set_dt(&driver_enable, 1);
        is_sending = true;
        uart_irq_tx_enable(uart);
    }
}

/// Until the interrupt, or for a millisecond.
void rest() { k_sem_take(&woken, K_USEC(1'000)); }

} // namespace

int main()
{
    gpio_pin_configure_dt(&driver_enable, GPIO_OUTPUT_INACTIVE);
    uart_irq_callback_user_data_set(uart, on_uart, nullptr);
    uart_irq_rx_enable(uart);
    uart_irq_err_enable(uart);
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
