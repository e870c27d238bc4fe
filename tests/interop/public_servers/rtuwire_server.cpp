// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Our server with all functions that have clauses, unit 1: rtuwire_server DEVICE. 128 of each, from address 0.
#include <array>
#include <cstdint>
#include <cstdio>

#include <rtuwire/port/posix_serial.hpp>
#include <rtuwire/server/banks.hpp>
#include <rtuwire/server/blocking.hpp>

using namespace rtuwire;

namespace {

struct device : word_bank<128> {
    bit_bank<128> switched{}, contacts{};
    word_bank<128> measured{};

    auto& coils() { return switched; }
    auto& discrete_inputs() { return contacts; }
    auto& input_registers() { return measured; }

    /// A queue of three at address 0.
    static errc read_fifo(std::uint16_t address, byte_writer& out)
    {
        if (address != 0) {
            return errc::illegal_data_address;
        }
        for (std::uint16_t each = 7; each < 10; ++each) {
            out.u16(each);
        }
        return errc::none;
    }
};

using functions =
    function_list<read_coils, read_discrete_inputs, read_holding_registers, read_input_registers, write_single_coil,
                  write_single_register, diagnostics<>, write_multiple_coils<>, write_multiple_registers<>,
                  mask_write_register, read_write_multiple_registers<>, read_fifo_queue, read_device_identification>;

constexpr device_object objects[] = {{vendor_name, "rtuwire"}, {product_code, "server"}, {major_minor_revision, "0.1"}};
constexpr server_profile profile{.identity = identity_of<objects>};

} // namespace

int main(int argc, char** argv)
{
    posix_serial port;
    if (argc != 2 or not port.open(argv[1])) {
        std::fprintf(stderr, "%s\n", argc == 2 ? port.failure().c_str() : "usage: rtuwire_server DEVICE");
        return 2;
    }
    static device bank;
    auto const line = line_timing::host(19'200, character_format::none_8_1);
    counting_server::with<functions> node{unit_id{1}, line, profile};
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
