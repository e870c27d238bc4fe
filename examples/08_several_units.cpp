// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Lesson 8: one board that is two units of a line: an I/O module at 3 and a meter at 4, each with its own registers and
// its own name. They have one UART, one framer and one frame's memory in common. Builds on lesson 2.
#include <iostream>

#include <rtuwire/client.hpp>
#include <rtuwire/print.hpp>
#include <rtuwire/server.hpp>
#include <rtuwire/sim.hpp>

using namespace rtuwire;

namespace {

struct io_module : word_bank<8> {
    bit_bank<8> outputs{};
    bit_bank<8>& coils() { return outputs; } // functions 01, 05 and 15, which the meter does not have
};

constexpr device_object meter_objects[] = {{vendor_name, "me"}, {product_code, "M1"}, {major_minor_revision, "1.0"}};
constexpr server_profile meter_profile{.identity = identity_of<meter_objects>};
using functions =
    function_list<write_single_coil, read_holding_registers, write_single_register, read_device_identification>;

} // namespace

int main()
{
    io_module io;
    word_bank<2> meter{100}; // registers 100 and 101
    static_cast<void>(meter.set(100, 2304));
    constexpr line_timing line{19'200, character_format::even_8_1};
    auto const board =
        server::with<functions>::for_units(line, bank_at{unit_id{3}, io}, bank_at{unit_id{4}, meter, meter_profile});
    sim::bench bench{line, board}; // on a board: board.receive(...), board.serve(now), board.poll_transmit()

    // Each unit answers from its own bank.
    single_request ask_meter{unit_id{4}, read_holding_registers{.start = 100, .count = 1}};
    auto const told = bench.run(ask_meter);
    auto const read = told ? told->to<read_holding_registers>() : told.error();
    if (not read) {
        std::cout << read.error() << '\n';
        return 1;
    }
    std::cout << "the meter shows " << read->registers[0] << '\n';

    // A function that one of them has, and one register that it does not have.
    auto const on = bench.run(single_request{unit_id{3}, write_single_coil{.address = 5, .value = true}});
    auto const no_coil = bench.run(single_request{unit_id{4}, write_single_coil{.address = 5, .value = true}});
    auto const no_register = bench.run(single_request{unit_id{3}, read_holding_registers{.start = 100, .count = 1}});
    std::cout << "a coil of the module: " << (on ? "on" : name(on.error())) << "; of the meter: " << no_coil.error()
              << "; register 100 of the module: " << no_register.error() << '\n';

    // A broadcast reaches both, and neither answers.
    auto const all = bench.run(single_request{broadcast, write_single_register{.address = 0, .value = 7}});
    std::cout << "after a broadcast register 0 of the module is " << io.get(0) << '\n';
    return all and read->registers[0] == 2304 and on and io.outputs.get(5) and no_coil == errc::illegal_function and
                   no_register == errc::illegal_data_address and io.get(0) == 7
               ? 0
               : 1;
}
