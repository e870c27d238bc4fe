// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Any core of Arduino with C++20 (arduino-pico, STM32duino): a sketch that is a client on a HardwareSerial, or on whatever is a
// Stream; pin 2 enables the driver.
#include <Arduino.h>

#include <cstddef>
#include <cstdint>

#include <rtuwire/client.hpp>

using namespace rtuwire;

std::uint16_t value = 0;   // of the register: show it where trouble is errc::none
errc trouble = errc::busy; // why there is no value, in words name(trouble); busy until the first answer or time-out

namespace {

constexpr int driver_enable = 2;
// The port's interrupt keeps bytes until the loop takes them: the times of a host.
constexpr auto timing = line_timing::host(19'200, character_format::even_8_1);
Stream& port = Serial1;

instant now() { return instant{static_cast<std::uint32_t>(micros())}; }

/// A port that has lost or refused bytes says nothing and goes on; the CRC finds what is missing.
template <typename Engine> void receive(Engine& link)
{
    instant const at = now();
    while (port.available() > 0) {
        link.receive(static_cast<std::byte>(port.read()), at);
    }
    link.advance(at);
}

template <typename Engine> void transmit(Engine& link)
{
    if (byte_view const frame = link.poll_transmit(); not frame.empty()) {
        digitalWrite(driver_enable, HIGH);
        instant const last_bit = now() + timing.characters(frame.size());
        port.write(reinterpret_cast<std::uint8_t const*>(frame.data()), frame.size());
        port.flush();
        while (not reached(now(), last_bit)) { // some cores return a byte or two too early
        }
        digitalWrite(driver_enable, LOW);
        link.sent(now());
    }
}

void rest() { delay(1); }

client modbus{timing};
single_request ask{unit_id{7}, read_holding_registers{.start = 3201, .count = 1}};

} // namespace

void setup()
{
    pinMode(driver_enable, OUTPUT);
    digitalWrite(driver_enable, LOW);
    Serial1.begin(19'200, SERIAL_8E1);
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
