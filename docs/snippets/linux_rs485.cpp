// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// What the page of Linux shows: a port whose driver switches the transceiver. A pseudo-terminal stands for the device;
// it has no transceiver, so that the port that demands one is refused.
//! [head]
#include <atomic>
#include <iostream>
#include <string>
#include <thread>

#include <rtuwire/client.hpp>
#include <rtuwire/port.hpp>
#include <rtuwire/print.hpp>
#include <rtuwire/server.hpp>

using namespace rtuwire;
//! [head]

namespace {

//! [open]
result<std::uint16_t> first_register(std::string const& device)
{
    posix_serial port;
    serial_settings settings{.bits_per_second = 19'200, .format = character_format::even_8_1};
    settings.rs485 = rs485_mode::if_offered; // `required`: device_setting_refused where the driver can't
    if (auto const opened = port.open(device, settings); not opened) {
        return opened.error();
    }
    if (not port.has_low_latency()) {
        std::cerr << "the adapter may hand bytes over up to 16 ms late\n";
    }
    blocking_client line{port, line_timing::host(19'200, character_format::even_8_1)};
    auto const response = line.ask(unit_id{2}, read_holding_registers{.start = 3201, .count = 1});
    if (not response) {
        return response.error();
    }
    return response->registers[0];
}
//! [open]

} // namespace

int main()
{
    pseudo_terminal far_end;
    if (not far_end.open()) {
        return 1;
    }
    word_bank<4> bank{3200};
    static_cast<void>(bank.set(3201, 0x0250));
    std::atomic<bool> is_asked{true};
    std::thread unit{[&] {
        server node{unit_id{2}, line_timing::without_wire()};
        while (is_asked and serve_once(node, far_end, bank, milliseconds(50))) {
        }
    }};
    auto const word = first_register(far_end.path());
    is_asked = false;
    unit.join();
    posix_serial demanding;
    auto const refused = demanding.open(far_end.path(), {.rs485 = rs485_mode::required});
    if (not word) {
        std::cout << word.error() << '\n';
    }
    return word and *word == 0x0250 and refused.error() == errc::device_setting_refused ? 0 : 1;
}
