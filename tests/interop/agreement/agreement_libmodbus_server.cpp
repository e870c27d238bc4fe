// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// A server of libmodbus with the memory of agreement.hpp.
#include <modbus.h>

#include "agreement.hpp"

int main(int argc, char** argv)
{
    modbus_t* const line = argc == 2 ? modbus_new_rtu(argv[1], 115'200, 'N', 8, 1) : nullptr;
    constexpr int all = agreement::addresses;
    modbus_mapping_t* const bank = modbus_mapping_new(all, all, all, all);
    if (line == nullptr or bank == nullptr or modbus_set_slave(line, 1) != 0 or modbus_connect(line) != 0) {
        std::fprintf(stderr, "libmodbus cannot serve on the device\n");
        return 2;
    }
    for (std::size_t i = 0; i < agreement::addresses; ++i) {
        bank->tab_input_registers[i] = agreement::input_word(i);
        bank->tab_input_bits[i] = agreement::input_bit(i) ? 1 : 0;
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
