// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Our server with all functions that have clauses, unit 1: rtuwire_server DEVICE. 128 of each, from address 0.
#include <array>
#include <cstdint>

#include <rtuwire/server/banks.hpp>

#include "../served_device.hpp"

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
    static device bank;
    auto const line = line_timing::host(19'200, character_format::none_8_1);
    counting_server::with<functions> node{unit_id{1}, line, profile};
    return test::serve_device(argc, argv, line, node, bank);
}
