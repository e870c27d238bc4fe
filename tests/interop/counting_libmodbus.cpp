// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// A client of libmodbus that asks unit 1 for one register after another, each of which holds its own address, and says how
// many answers were right, wrong or missing: counting_libmodbus DEVICE COUNT TIME_OUT_MS.
#include <cstdint>
#include <cstdio>
#include <cstdlib>

#include <modbus.h>

int main(int argc, char** argv)
{
    modbus_t* const line = argc == 4 ? modbus_new_rtu(argv[1], 19'200, 'E', 8, 1) : nullptr;
    if (line == nullptr or modbus_set_slave(line, 1) != 0 or modbus_connect(line) != 0) {
        std::fprintf(stderr, "libmodbus cannot open the device\n");
        return 2;
    }
    modbus_set_response_timeout(line, 0, static_cast<std::uint32_t>(std::strtoul(argv[3], nullptr, 10) * 1'000));
    unsigned long const count = std::strtoul(argv[2], nullptr, 10);
    unsigned long right = 0;
    unsigned long wrong = 0;
    for (unsigned long i = 0; i < count; ++i) {
        int const address = static_cast<int>(100 + i * 37 % 100);
        std::uint16_t word = 0;
        if (modbus_read_registers(line, address, 1, &word) == 1) {
            (word == address ? right : wrong) += 1;
        }
    }
    std::printf("%lu %lu %lu\n", right, wrong, count - right - wrong);
    modbus_close(line);
    modbus_free(line);
    return 0;
}
