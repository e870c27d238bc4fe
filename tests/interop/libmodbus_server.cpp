// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// A server of libmodbus for our client: unit 1, registers 100..199 hold their own address.
#include <cstdint>
#include <cstdio>

#include <modbus.h>

int main(int argc, char** argv)
{
    modbus_t* const line = argc == 2 ? modbus_new_rtu(argv[1], 19'200, 'E', 8, 1) : nullptr;
    modbus_mapping_t* const bank = modbus_mapping_new_start_address(0, 0, 0, 0, 100, 100, 0, 0);
    if (line == nullptr or bank == nullptr or modbus_set_slave(line, 1) != 0 or modbus_connect(line) != 0) {
        std::fprintf(stderr, "libmodbus cannot serve on the device\n");
        return 2;
    }
    for (std::uint16_t i = 0; i < 100; ++i) {
        bank->tab_registers[i] = static_cast<std::uint16_t>(100 + i);
    }
    std::puts("ready");
    std::fflush(stdout);
    for (;;) {
        std::uint8_t request[MODBUS_RTU_MAX_ADU_LENGTH];
        int const size = modbus_receive(line, request);
        if (size > 0) {
            modbus_reply(line, request, size, bank);
        }
    }
}
