// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Function 02 at every quantity and every size, both directions.
#include <rtuwire/wire/bits.hpp>

#include "support/bit_reads.hpp"
#include "support/golden.hpp"
#include "support/proof.hpp"

#include <rtuwire/core/hex.hpp>

using namespace rtuwire;
using namespace rtuwire::detail;

namespace {

constexpr bool asks_for_1_to_2000()
{
    using test::is;
    return is(test::counts_to<read_discrete_inputs>(2000), "quantities") and
           is(test::reaches_the_last_address<read_discrete_inputs>(2000), "addresses") and
           is(test::has_size<read_discrete_inputs>("02 00 C4 00 16 00 00"_hex, 5), "sizes") and
           is(read_discrete_inputs::decode("01 00 C4 00 16"_hex).error() == errc::wrong_function, "another function");
}
PROOF("function 02 asks for 1 to 2000 bits up to address 65535", asks_for_1_to_2000)

// The specification's example.
constexpr auto asked = "02 00 C4 00 16"_hex;
constexpr auto told = "02 03 AC DB 35"_hex;
constexpr bool is_as_printed()
{
    auto const request = read_discrete_inputs::decode(asked);
    auto const response = read_discrete_inputs_response::decode(told);
    return request == read_discrete_inputs{196, 22} and response and response->inputs.size() == 24 and
           response->inputs[0] == false and response->inputs[2] == true and
           test::needs_room(read_discrete_inputs_response{bit_view{response->inputs.bytes(), 22}}, 8);
}
PROOF("function 02 is read as it is printed", is_as_printed)

} // namespace

TEST_CASE("a request of function 02 is read with a quantity of 1 to 2000 of all 65536")
{
    CHECK(test::misread_quantities<read_discrete_inputs>(2000) == 0);
}

TEST_CASE("a response of function 02 has 1 to 250 bytes, as its byte count says")
{
    auto const told_by = [](std::uint32_t byte_count, byte_view) {
        return byte_count >= 1 and byte_count <= 250 ? errc::none : errc::invalid_quantity;
    };
    CHECK(test::misread_byte_counts<read_discrete_inputs_response>(test::sample{2}, told_by) == 0);
}

TEST_CASE("a response of function 02 carries 1 to 2000 bits in whole bytes, padded by zeros")
{
    CHECK(test::wrong_bit_responses<read_discrete_inputs_response>(test::sample{2},
                                                                   &read_discrete_inputs_response::inputs) == 0);
}
