// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Linux: a client on a serial port, whose driver enables that of the line where it can.  ./linux_rs485 /dev/ttyS1
#include <cstdlib>
#include <iostream>
#include <string>

#include <rtuwire/client.hpp>
#include <rtuwire/port.hpp>
#include <rtuwire/print.hpp>

using namespace rtuwire;

namespace {

/// Reads the register again and again, until the port fails; a unit that is silent is told, and asked again.
int poll(posix_serial& port)
{
    blocking_client line{port}; // with the times that suit the device
    for (;;) {
        auto const response = line.ask(unit_id{7}, read_holding_registers{.start = 3201, .count = 1});
        if (response) {
            std::cout << response->registers[0] << std::endl;
        } else if (not port.is_open()) {
            std::cerr << port.failure() << '\n';
            return EXIT_FAILURE;
        } else {
            std::cerr << response.error() << '\n';
        }
    }
}

} // namespace

int main(int count, char** words)
{
    if (count != 2) {
        std::cerr << "linux_rs485 DEVICE\n";
        return EXIT_FAILURE;
    }
    posix_serial port;
    serial_settings settings{.bits_per_second = 19'200, .format = character_format::even_8_1};
    settings.rs485 = rs485_mode::if_offered; // `required`: device_setting_refused where the driver can't
    if (auto const opened = port.open(words[1], settings); not opened) {
        std::cerr << port.failure() << '\n';
        return EXIT_FAILURE;
    }
    if (not port.has_low_latency()) {
        std::cerr << "the adapter may hand bytes over up to 16 ms late\n";
    }
    return poll(port);
}
