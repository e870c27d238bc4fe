// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Our server for others' clients: unit 1 on the device named on the command line, until it is ended.
// Registers 100..199 hold their own address; it limits quantities as an ATV320 does.
#include <cstdio>

#include <rtuwire/port/posix_serial.hpp>
#include <rtuwire/server/blocking.hpp>

using namespace rtuwire;

namespace {

// Too much for one page.
constexpr device_object objects[] = {{vendor_name, "rtuwire"},
                                     {product_code, "ATV310H037N4"},
                                     {major_minor_revision, "0201"},
                                     {3, "0123456789012345678901234567890123456789"
                                         "0123456789012345678901234567890123456789"
                                         "0123456789012345678901234567890123456789"},
                                     {4, "interoperability test"},
                                     {5, "0123456789012345678901234567890123456789"
                                         "0123456789012345678901234567890123456789"
                                         "0123456789012345678901234567890123456789"}};
constexpr server_profile profile{.limits = {63, 61, 20, 20}, .identity = identity_of<objects>};

} // namespace

int main(int argc, char** argv)
{
    posix_serial port;
    if (argc != 2 or not port.open(argv[1])) {
        std::fprintf(stderr, "%s\n", argc == 2 ? port.failure().c_str() : "usage: our_server DEVICE");
        return 2;
    }
    word_bank<100> bank{100};
    for (std::uint16_t address = 100; address < 200; ++address) {
        static_cast<void>(bank.set(address, address));
    }
    // Short: the clients under test send nothing to other units between whose frames gaps would count.
    auto const line = line_timing::host(19'200, character_format::even_8_1);
    server node{unit_id{1}, line, profile};
    // Nothing is heard before the line was silent once.
    instant const silent = port.now() + line.frame_end() + milliseconds(10);
    while (not reached(port.now(), silent)) {
        static_cast<void>(serve_once(node, port, bank, milliseconds(10)));
    }
    std::puts("ready");
    std::fflush(stdout);
    while (serve_once(node, port, bank, milliseconds(200))) {
    }
    std::fprintf(stderr, "%s\n", port.failure().c_str());
    return 1;
}
