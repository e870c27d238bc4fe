// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// ESP32 with Arduino's core 3: a sketch that is a client on Serial1, RX on GPIO 16, TX on 17. The core enables the line's driver,
// by RTS on GPIO 18, from the first start bit to the last stop bit.
#include <Arduino.h>

#include <atomic>
#include <cstddef>
#include <cstdint>

#include <rtuwire/client.hpp>

using namespace rtuwire;

std::uint16_t value = 0;   // of the register: show it where trouble is errc::none
errc trouble = errc::busy; // why there is no value, in words name(trouble); busy until the first answer or time-out

namespace {

constexpr std::int8_t receive_pin = 16, transmit_pin = 17, driver_enable = 18;
std::atomic<bool> is_damaged{false};

instant now() { return instant{static_cast<std::uint32_t>(micros())}; }

/// What the core has kept is taken in each pass: where its buffer is full, it stops receiving until then.
template <typename Engine> void receive(Engine& link)
{
    instant const at = now();
    if (is_damaged.exchange(false)) {
        link.receive_error(at);
    }
    while (Serial1.available() > 0) {
        link.receive(static_cast<std::byte>(Serial1.read()), at);
    }
    link.advance(at);
}

template <typename Engine> void transmit(Engine& link)
{
    if (byte_view const frame = link.poll_transmit(); not frame.empty()) {
        Serial1.write(reinterpret_cast<std::uint8_t const*>(frame.data()), frame.size());
        Serial1.flush(); // until the last stop bit has left
        link.sent(now());
    }
}

void rest() { delay(1); }

// The core keeps bytes until the loop takes them: the times of a host.
client modbus{line_timing::host(19'200, character_format::even_8_1)};
single_request ask{unit_id{7}, read_holding_registers{.start = 3201, .count = 1}};

} // namespace

void setup()
{
    Serial1.begin(19'200, SERIAL_8E1, receive_pin, transmit_pin);
    bool const is_half_duplex = Serial1.setPins(receive_pin, transmit_pin, -1, driver_enable) and
                                Serial1.setMode(UART_MODE_RS485_HALF_DUPLEX) and Serial1.setRxFIFOFull(1);
    if (not is_half_duplex) {
        trouble = errc::device_setting_refused;
    }
    Serial1.onReceiveError([](hardwareSerial_error_t) { is_damaged = true; }); // in a task of the core's
}

void loop()
{
    receive(modbus);
    modbus.converse(ask, now());
    if (ask.settled()) {
        auto const response = ask.outcome();
        trouble = response.error();
        value = response ? response->to<read_holding_registers>()->registers[0] : value;
        ask.again();
    }
    transmit(modbus);
    rest();
}
