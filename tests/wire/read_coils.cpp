// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Function 01 at every quantity and every size, both directions.
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
    return is(test::counts_to<read_coils>(2000), "quantities") and
           is(test::reaches_the_last_address<read_coils>(2000), "addresses") and
           is(test::has_size<read_coils>("01 00 13 00 13 00 00"_hex, 5), "sizes") and
           is(read_coils::decode("02 00 13 00 13"_hex).error() == errc::wrong_function, "another function");
}
PROOF("function 01 asks for 1 to 2000 bits up to address 65535", asks_for_1_to_2000)

// The specification's example.
constexpr auto asked = "01 00 13 00 13"_hex;
constexpr auto told = "01 03 CD 6B 05"_hex;
constexpr bool is_as_printed()
{
    auto const request = read_coils::decode(asked);
    auto const response = read_coils_response::decode(told);
    return request == read_coils{19, 19} and response and response->coils.size() == 24 and
           response->coils[0] == true and response->coils[2] == true and
           test::needs_room(read_coils_response{bit_view{response->coils.bytes(), 19}}, 8);
}
PROOF("function 01 is read as it is printed", is_as_printed)

} // namespace

TEST_CASE("a request of function 01 is read with a quantity of 1 to 2000 of all 65536")
{
    CHECK(test::misread_quantities<read_coils>(2000) == 0);
}

TEST_CASE("a response of function 01 has 1 to 250 bytes, as its byte count says")
{
    auto const told_by = [](std::uint32_t byte_count, byte_view) {
        return byte_count >= 1 and byte_count <= 250 ? errc::none : errc::invalid_quantity;
    };
    CHECK(test::misread_byte_counts<read_coils_response>(test::sample{1}, told_by) == 0);
}

TEST_CASE("a response of function 01 carries 1 to 2000 bits in whole bytes, padded by zeros")
{
    CHECK(test::wrong_bit_responses<read_coils_response>(test::sample{1}, &read_coils_response::coils) == 0);
}
