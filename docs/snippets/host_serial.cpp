// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// What the page of Windows and macOS shows: a device by the port of the system. Here nobody answers at one, and there is no
// other.
//! [head]
#include <cstdint>
#include <iostream>
#include <string>

#include <rtuwire/client.hpp>
#include <rtuwire/port.hpp>
#include <rtuwire/print.hpp>

using namespace rtuwire;
//! [head]

namespace {

//! [ask]
// "COM3" on Windows, "/dev/cu.usbserial-1420" on macOS, "/dev/ttyUSB0" on Linux.
result<std::uint16_t> first_register(std::string const& name)
{
    host_serial port;
    if (auto const opened = port.open(name, {.bits_per_second = 19'200}); not opened) {
        std::cerr << port.failure() << '\n';
        return opened.error();
    }
    blocking_client line{port, port.timing()};
    auto const answer = line.ask(unit_id{1}, read_holding_registers{100, 1});
    return answer ? result{answer->registers[0]} : answer.error();
}
//! [ask]

} // namespace

int main()
{
    pseudo_terminal silent;
    bool const is_made = silent.open().has_value();
    bool const is_right =
        first_register(silent.path()) == errc::timed_out and first_register("/dev/of-nobody") == errc::device_not_found;
    return is_made and is_right ? 0 : 1;
}
