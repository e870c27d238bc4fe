// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Our client against others' servers: unit 1 on the device named on the command line, or behind a TCP port of this
// machine ("tcp:4001"), holds registers 100..199 with their own address. With "identify" it reads the identification too.
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <string>

#include <rtuwire/client/blocking.hpp>
#include <rtuwire/core/hex.hpp>
#include <rtuwire/port/posix_serial.hpp>
#include <rtuwire/port/tcp_stream.hpp>
#include <rtuwire/wire/errc_name.hpp>
#include <rtuwire/wire/raw.hpp>
#include <rtuwire/wire/registers.hpp>
#include <rtuwire/wire/serial_line/device_identification.hpp>

using namespace rtuwire;
using namespace rtuwire::detail;

namespace {

int failures = 0;

void expect(bool is_right, char const* what, errc error)
{
    std::printf("%s %s (%s)\n", is_right ? "ok  " : "FAIL", what, std::string{name(error)}.c_str());
    failures += is_right ? 0 : 1;
}

template <typename Line> void check_registers(Line& line)
{
    auto const four = line.ask(unit_id{1}, read_holding_registers{100, 4});
    expect(four and four->registers[0] == 100 and four->registers[3] == 103, "03 reads", four.error());
    auto const many = line.ask(unit_id{1}, read_holding_registers{100, 100});
    expect(many and many->registers[99] == 199, "03 reads a long frame", many.error());
    auto const one = line.ask(unit_id{1}, write_single_register{110, 0xBEEF});
    expect(one and one->value == 0xBEEF, "06 writes", one.error());
    auto const two = line.ask(unit_id{1}, write_multiple_registers{111, register_block{7, 8}});
    expect(two and two->count == 2, "16 writes", two.error());
    auto const back = line.ask(unit_id{1}, read_holding_registers{110, 3});
    expect(back and back->registers == register_block{0xBEEF, 7, 8}, "all was written", back.error());
    auto const both = line.ask(unit_id{1}, read_write_multiple_registers{111, 3, 112, register_block{0x1234}});
    expect(both and both->registers == register_block{7, 0x1234, 113}, "23 writes, then reads", both.error());
}

constexpr auto no_registers = "00 64 00 00"_hex; // outside of a template, for Clang 14

template <typename Line> void check_exceptions(Line& line)
{
    auto const address = line.ask(unit_id{1}, read_holding_registers{60'000, 1});
    expect(address == errc::illegal_data_address, "exception 02", address.error());
    // A quantity of 0, which only a raw request can ask for.
    auto const value = line.ask(unit_id{1}, raw_pdu{function_code::read_holding_registers, no_registers});
    expect(value == errc::illegal_data_value, "exception 03", value.error());
    auto const silence = line.ask(unit_id{9}, read_holding_registers{100, 1});
    expect(silence == errc::timed_out, "silence of another unit", silence.error());
}

template <typename Line> void check_unknown_function(Line& line)
{
    auto const unknown = line.ask(unit_id{1}, raw_pdu{static_cast<function_code>(0x41), {}});
    expect(unknown == errc::illegal_function, "exception 01", unknown.error());
}

template <typename Line> void check_identification(Line& line)
{
    std::string ids;
    std::size_t bytes = 0;
    unsigned pages = 0;
    std::uint8_t next = vendor_name;
    for (bool more = true; more;) {
        auto const page = line.ask(unit_id{1}, read_device_identification{identification_access::regular, next});
        expect(page.has_value(), "43/14 is answered", page.error());
        if (not page) {
            return;
        }
        for (auto at = page->first(); at; at = page->after(*at)) {
            std::string text;
            for (std::byte const byte : at->value) {
                text += static_cast<char>(to_u8(byte));
            }
            std::printf("     object %u: %.20s (%zu)\n", at->id, text.c_str(), text.size());
            ids += std::to_string(at->id) + ' ';
            bytes += text.size();
        }
        ++pages;
        more = page->more_follows and page->next_object > next;
        next = page->next_object;
    }
    // What pymodbus_server.py says of itself: 8, 158, 3, 184 and 4 characters.
    expect(ids == "0 1 2 3 4 " and bytes == 357 and pages == 2, "43/14 gives all in two pages", errc::none);
}

template <typename Port> int check_all(Port& port, line_timing const& timing, bool identifies)
{
    blocking_client line{port, timing, {.response_timeout = milliseconds(2000), .retries = 0}};
    check_registers(line);
    check_exceptions(line);
    // pymodbus is silent on functions it does not know, libmodbus has no identification.
    if (identifies) {
        check_identification(line);
    } else {
        check_unknown_function(line);
    }
    return failures == 0 ? 0 : 1;
}

template <typename Port> int without_port(Port const& port)
{
    std::fprintf(stderr, "%s\n", port.failure().c_str());
    return 2;
}

} // namespace

int main(int argc, char** argv)
{
    if (argc < 2) {
        std::fprintf(stderr, "usage: our_client DEVICE|tcp:PORT [identify]\n");
        return 2;
    }
    bool const identifies = argc > 2 and std::strcmp(argv[2], "identify") == 0;
    if (std::strncmp(argv[1], "tcp:", 4) == 0) {
        tcp_stream port;
        auto const number = static_cast<std::uint16_t>(std::strtoul(argv[1] + 4, nullptr, 10));
        return port.open("localhost", number) ? check_all(port, line_timing::without_wire(), identifies)
                                              : without_port(port);
    }
    posix_serial port;
    return port.open(argv[1]) ? check_all(port, line_timing::host(19'200, character_format::even_8_1), identifies)
                              : without_port(port);
}
