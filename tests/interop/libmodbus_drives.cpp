// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// libmodbus takes drives through the words of their manuals: libmodbus_drives DEVICE [UNIT CMD ETA]...
#include <array>
#include <cerrno>
#include <cstdint>
#include <cstdio>
#include <cstdlib>

#include <modbus.h>

namespace {

/// A command word, and the state that it leads to as the status word tells it.
struct stage {
    std::uint16_t command;
    std::uint16_t mask;
    std::uint16_t state;
};
constexpr std::array<stage, 6> way{{{0x0006, 0x6F, 0x21},
                                    {0x0007, 0x6F, 0x23},
                                    {0x000F, 0x6F, 0x27},
                                    {0x0007, 0x6F, 0x23},
                                    {0x0006, 0x6F, 0x21},
                                    {0x0000, 0x4F, 0x40}}};

/// How many stages go wrong.
int walk(modbus_t* line, int unit, int cmd, int eta)
{
    int failures = 0;
    modbus_set_slave(line, unit);
    for (stage const& each : way) {
        std::uint16_t status = 0;
        bool const is_right = modbus_write_register(line, cmd, each.command) == 1 and
                              modbus_read_registers(line, eta, 1, &status) == 1 and (status & each.mask) == each.state;
        std::printf("%s unit %d: CMD %04X, ETA %04X (%s)\n", is_right ? "ok  " : "FAIL", unit, unsigned{each.command},
                    unsigned{status}, modbus_strerror(errno));
        failures += is_right ? 0 : 1;
    }
    return failures;
}

} // namespace

int main(int argc, char** argv)
{
    // A pseudo-terminal keeps no parity.
    modbus_t* const line = argc > 1 ? modbus_new_rtu(argv[1], 19'200, 'N', 8, 1) : nullptr;
    if (line == nullptr or modbus_connect(line) != 0) {
        std::fprintf(stderr, "libmodbus cannot open the device: %s\n", modbus_strerror(errno));
        return 2;
    }
    modbus_set_response_timeout(line, 5, 0);
    int failures = argc < 5 ? 1 : 0;
    for (int i = 2; i + 2 < argc; i += 3) {
        failures += walk(line, std::atoi(argv[i]), std::atoi(argv[i + 1]), std::atoi(argv[i + 2]));
    }
    modbus_close(line);
    modbus_free(line);
    return failures == 0 ? 0 : 1;
}
