// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// What the page of ESP-IDF shows, run with stand-ins for its driver.
//! [page]
#include <array>
#include <cstddef>
#include <cstdint>

#include <driver/uart.h>
#include <esp_timer.h>
#include <rtuwire/altivar/atv320.hpp>
#include <rtuwire/client.hpp>

using namespace rtuwire;

namespace {

constexpr auto port = UART_NUM_1;
constexpr station<altivar::atv320::device> drive{unit_id{7}};

instant now() { return instant{static_cast<std::uint32_t>(esp_timer_get_time())}; }

void open_line(int transmit_pin, int receive_pin, int driver_enable_pin)
{
    uart_config_t config{};
    config.baud_rate = 19'200;
    config.data_bits = UART_DATA_8_BITS;
    config.parity = UART_PARITY_EVEN;
    config.stop_bits = UART_STOP_BITS_1;
    uart_driver_install(port, 512, 0, 0, nullptr, 0); // no transmit buffer: a write returns when all is in the FIFO
    uart_param_config(port, &config);
    uart_set_pin(port, transmit_pin, receive_pin, driver_enable_pin, UART_PIN_NO_CHANGE); // RTS enables the driver
    uart_set_mode(port, UART_MODE_RS485_HALF_DUPLEX);
    uart_set_rx_full_threshold(port, 1); // bytes are passed on as they come
}

} // namespace

extern "C" void app_main()
{
    open_line(17, 16, 18);
    // A task may run late by a tick or more: the times of a host.
    client link{line_timing::host(19'200, character_format::even_8_1)};
    poller<read_plan<altivar::atv320::device, altivar::atv320::eta, altivar::atv320::rfr>> panel{drive};
    for (;;) {
        std::array<std::byte, 128> place{};
        int const got = uart_read_bytes(port, place.data(), place.size(), 1); // sleeps for a tick at most
        if (got > 0) {
            link.receive(byte_view{place}.first(static_cast<std::size_t>(got)), now());
        }
        link.advance(now());
        link.converse(panel, now());
        if (panel.settled()) {
            if (panel.outcome()) {
                show(panel.latest().get<altivar::atv320::rfr>());
            }
            panel.again();
        }
        if (byte_view const frame = link.poll_transmit(); not frame.empty()) {
            uart_write_bytes(port, frame.data(), frame.size());
            uart_wait_tx_done(port, portMAX_DELAY);
            link.sent(now());
        }
    }
}
//! [page]

int main() { app_main(); }
