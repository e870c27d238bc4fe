// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// What the page of arduino-pico shows, run with stand-ins for its serial port, pins and clock.
//! [page]
#include <cstddef>
#include <cstdint>

#include <Arduino.h>
#include <rtuwire/altivar/atv320.hpp>
#include <rtuwire/client.hpp>

using namespace rtuwire;

constexpr int driver_enable = 2;
constexpr station<altivar::atv320::device> drive{unit_id{7}};
// The serial port's own interrupt keeps bytes until the loop takes them: the times of a host.
client link{line_timing::host(19'200, character_format::even_8_1)};
poller<read_plan<altivar::atv320::device, altivar::atv320::eta, altivar::atv320::rfr>> panel{drive};

void setup()
{
    pinMode(driver_enable, OUTPUT);
    digitalWrite(driver_enable, LOW);
    Serial1.begin(19'200, SERIAL_8E1);
}

void loop()
{
    instant const now{micros()};
    while (Serial1.available()) {
        link.receive(static_cast<std::byte>(Serial1.read()), now);
    }
    link.advance(now);
    link.converse(panel, now);
    if (panel.settled()) {
        if (panel.outcome()) {
            show(panel.latest().get<altivar::atv320::rfr>());
        }
        panel.again();
    }
    if (byte_view const frame = link.poll_transmit(); not frame.empty()) {
        digitalWrite(driver_enable, HIGH);
        Serial1.write(reinterpret_cast<std::uint8_t const*>(frame.data()), frame.size());
        Serial1.flush(); // until the last stop bit has left
        digitalWrite(driver_enable, LOW);
        link.sent(instant{micros()});
    }
}
//! [page]

int main()
{
    setup();
    for (;;) {
        loop();
        stand_in::line.wait(microseconds(250));
    }
}
