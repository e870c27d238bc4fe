// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Our client, asking as counting_libmodbus.cpp does: counting_client DEVICE COUNT TIME_OUT_MS. It is told that answers may
// come up to a second behind the time-out.
#include <cstdint>
#include <cstdio>
#include <cstdlib>

#include <rtuwire/client.hpp>
#include <rtuwire/port.hpp>

using namespace rtuwire;

int main(int argc, char** argv)
{
    posix_serial port;
    if (argc != 4 or not port.open(argv[1])) {
        std::fprintf(stderr, "%s\n", port.failure().c_str());
        return 2;
    }
    auto const time_out = static_cast<std::uint32_t>(std::strtoul(argv[3], nullptr, 10));
    blocking_client line{
        port, port.timing(), {.response_timeout = milliseconds(time_out), .late_response = milliseconds(1'000)}};
    unsigned long const count = std::strtoul(argv[2], nullptr, 10);
    unsigned long right = 0;
    unsigned long wrong = 0;
    for (unsigned long i = 0; i < count; ++i) {
        auto const address = static_cast<std::uint16_t>(100 + i * 37 % 100);
        if (auto const answer = line.ask(unit_id{1}, read_holding_registers{address, 1})) {
            (answer->registers.size() == 1 and answer->registers[0] == address ? right : wrong) += 1;
        }
    }
    std::printf("%lu %lu %lu\n", right, wrong, count - right - wrong);
    return 0;
}
