// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Function 04 at every quantity and every size, both directions.
#include <rtuwire/wire/registers.hpp>

#include "support/pdu_facts.hpp"
#include "support/proof.hpp"

#include <rtuwire/core/hex.hpp>

using namespace rtuwire;

namespace {

constexpr bool asks_for_1_to_125()
{
    using test::is;
    return is(test::counts_to<read_input_registers>(125), "quantities") and
           is(test::reaches_the_last_address<read_input_registers>(125), "addresses") and
           is(test::has_size<read_input_registers>("04 00 08 00 01 00 00"_hex, 5), "sizes") and
           is(read_input_registers::decode("03 00 08 00 01"_hex) == errc::wrong_function, "another function");
}
PROOF("function 04 asks for 1 to 125 registers up to address 65535", asks_for_1_to_125)

constexpr bool is_as_printed()
{
    constexpr auto told = "04 02 00 0A"_hex;
    auto const response = read_input_registers_response::decode(told);
    return read_input_registers::decode("04 00 08 00 01"_hex) == read_input_registers{8, 1} and response and
           response->registers.size() == 1 and response->registers[0] == 10 and test::needs_room(*response, 7);
}
PROOF("function 04 is read as it is printed", is_as_printed)

} // namespace

TEST_CASE("a request of function 04 is read with a quantity of 1 to 125 of all 65536")
{
    CHECK(test::misread_quantities<read_input_registers>(125) == 0);
}

TEST_CASE("a response of function 04 has 1 to 125 whole registers, as its byte count says")
{
    auto const told = [](std::uint32_t byte_count, byte_view) {
        return byte_count % 2 != 0                     ? errc::wrong_length
               : byte_count >= 2 and byte_count <= 250 ? errc::none
                                                       : errc::invalid_quantity;
    };
    CHECK(test::misread_byte_counts<read_input_registers_response>(test::sample{4}, told) == 0);
}

TEST_CASE("a response of function 04 is written with 1 to 125 registers")
{
    test::sample const some{4};
    for (std::size_t count = 0; count <= 126; ++count) {
        CAPTURE(count);
        read_input_registers_response const told{register_view{some.first(2 * count)}};
        CHECK((count >= 1 and count <= 125
                   ? test::survives(told, [&](auto const& read) { return read.registers == told.registers; })
                   : test::is_refused(told, errc::invalid_quantity)));
    }
}
