// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Our client as `rtuwire check --client` starts it: PORT TIMEOUT, then "read UNIT ADDRESS COUNT" or "write UNIT ADDRESS VALUE".
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <string>

#include <rtuwire/port.hpp>
#include <rtuwire/rtuwire.hpp>

using namespace rtuwire;

namespace {

std::uint16_t number(char const* word) { return static_cast<std::uint16_t>(std::strtoul(word, nullptr, 10)); }

void tell(errc why) { std::printf("error: %s\n", std::string{name(why)}.c_str()); }

template <typename Line> void read(Line& line, unit_id unit, std::uint16_t address, std::uint16_t count)
{
    auto const answer = line.ask(unit, read_holding_registers{address, count});
    if (not answer) {
        return tell(answer.error());
    }
    for (std::size_t i = 0; i < answer->registers.size(); ++i) {
        std::printf("%u ", unsigned{answer->registers[i]});
    }
    std::printf("\n");
}

template <typename Line> void write(Line& line, std::uint16_t unit, std::uint16_t address, std::uint16_t value)
{
    write_single_register const request{address, value};
    errc const why = unit == 0 ? line.send_broadcast(request).error()
                               : line.ask(*unit_id::checked(static_cast<std::uint8_t>(unit)), request).error();
    why == errc::none ? static_cast<void>(std::puts("ok")) : tell(why);
}

} // namespace

int main(int argc, char** argv)
{
    posix_serial port;
    if (argc < 3 or not port.open(argv[1])) {
        std::fprintf(stderr, "%s\n", argc < 3 ? "checked_ours PORT TIMEOUT ..." : port.failure().c_str());
        return 2;
    }
    blocking_client line{port, port.timing(), {.response_timeout = milliseconds(number(argv[2]))}};
    for (char** word = argv + 3; word + 4 <= argv + argc; word += 4) {
        if (std::string{word[0]} == "read") {
            read(line, *unit_id::checked(static_cast<std::uint8_t>(number(word[1]))), number(word[2]), number(word[3]));
        } else {
            write(line, number(word[1]), number(word[2]), number(word[3]));
        }
    }
    return 0;
}
