// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// A client of libmodbus against our server.
#include <cerrno>
#include <cstdint>
#include <cstdio>

#include <modbus.h>

namespace {

int failures = 0;

void expect(bool is_right, char const* what)
{
    std::printf("%s %s (%s)\n", is_right ? "ok  " : "FAIL", what, modbus_strerror(errno));
    failures += is_right ? 0 : 1;
}

void check_registers(modbus_t* line)
{
    std::uint16_t words[125]{};
    expect(modbus_read_registers(line, 100, 63, words) == 63 and words[0] == 100 and words[62] == 162, "03 reads 63");
    expect(modbus_write_register(line, 110, 0xBEEF) == 1, "06 writes");
    std::uint16_t const two[]{7, 8};
    expect(modbus_write_registers(line, 111, 2, two) == 2, "16 writes");
    expect(modbus_read_registers(line, 110, 3, words) == 3 and words[0] == 0xBEEF and words[2] == 8, "all was written");
    std::uint16_t const one[]{0x1234};
    expect(modbus_write_and_read_registers(line, 112, 1, one, 111, 3, words) == 3 and words[0] == 7 and
               words[1] == 0x1234 and words[2] == 113,
           "23 writes, then reads");
}

void check_exceptions(modbus_t* line)
{
    std::uint16_t words[125]{};
    std::uint8_t bits[8]{};
    expect(modbus_read_bits(line, 0, 1, bits) == -1 and errno == EMBXILFUN, "exception 01");
    expect(modbus_read_registers(line, 199, 2, words) == -1 and errno == EMBXILADD, "exception 02");
    expect(modbus_read_registers(line, 100, 64, words) == -1 and errno == EMBXILVAL, "exception 03");
    modbus_set_slave(line, 9);
    modbus_set_response_timeout(line, 0, 300'000);
    expect(modbus_read_registers(line, 100, 1, words) == -1 and errno == ETIMEDOUT, "silence of another unit");
}

} // namespace

int main(int argc, char** argv)
{
    modbus_t* const line = argc == 2 ? modbus_new_rtu(argv[1], 19'200, 'E', 8, 1) : nullptr;
    if (line == nullptr or modbus_set_slave(line, 1) != 0 or modbus_connect(line) != 0) {
        std::fprintf(stderr, "libmodbus cannot open the device: %s\n", modbus_strerror(errno));
        return 2;
    }
    modbus_set_response_timeout(line, 5, 0);
    check_registers(line);
    check_exceptions(line);
    modbus_close(line);
    modbus_free(line);
    return failures == 0 ? 0 : 1;
}
