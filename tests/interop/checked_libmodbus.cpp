// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// A client of libmodbus as `rtuwire check --client` starts it: PORT TIMEOUT, then "read UNIT ADDRESS COUNT" or
// "write UNIT ADDRESS VALUE".
#include <cerrno>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>

#include <modbus.h>

int main(int argc, char** argv)
{
    modbus_t* const line = argc < 3 ? nullptr : modbus_new_rtu(argv[1], 19'200, 'E', 8, 1);
    if (line == nullptr or modbus_connect(line) != 0) {
        return 2;
    }
    auto const timeout_ms = static_cast<std::uint32_t>(std::atoi(argv[2]));
    // A second and more in microseconds alone is refused.
    modbus_set_response_timeout(line, timeout_ms / 1'000, timeout_ms % 1'000 * 1'000);
    for (char** word = argv + 3; word + 4 <= argv + argc; word += 4) {
        std::uint16_t values[125];
        int const address = std::atoi(word[2]), number = std::atoi(word[3]);
        bool const is_read = std::strcmp(word[0], "read") == 0;
        modbus_set_slave(line, std::atoi(word[1]));
        int const done = is_read ? modbus_read_registers(line, address, number, values)
                                 : modbus_write_register(line, address, static_cast<std::uint16_t>(number));
        if (done < 0) {
            std::printf("error: %s\n", modbus_strerror(errno));
        }
        for (int i = 0; is_read and i < done; ++i) {
            std::printf("%d%c", values[i], i + 1 < done ? ' ' : '\n');
        }
        if (not is_read and done > 0) {
            std::puts("ok");
        }
    }
}
