// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Function 08: one word of data, but 1 to 125 for the query that is returned.
#include <rtuwire/wire/serial_line/diagnostics.hpp>

#include <array>

#include "support/encode_space.hpp"
#include "support/proof.hpp"
#include "support/random.hpp"

using namespace rtuwire;
using namespace rtuwire::detail;
using rtuwire::test::is_refused;
using rtuwire::test::survives;

namespace {

constexpr bool needs_its_room()
{
    return test::needs_room(diagnostics{subfunction::return_query_data, register_block{1, 2, 3}}, 12);
}
PROOF("a frame of function 08 needs all of its bytes", needs_its_room)

constexpr bool takes_one_word()
{
    register_block const one{0xFF00};
    register_block const two{1, 2};
    for (std::uint32_t number = 0; number <= 0x20; ++number) {
        auto const what = static_cast<subfunction>(number);
        diagnostics const ask{what, one};
        bool const is_query = what == subfunction::return_query_data;
        errc const with_two = is_query ? errc::none : errc::invalid_quantity;
        if (not survives(ask, [&](diagnostics<> const& read) { return read == ask; }) or
            diagnostics{what, two}.check() != with_two or
            not is_refused(diagnostics{what, {}}, errc::invalid_quantity, 16)) {
            return false;
        }
    }
    return true;
}
PROOF("every sub-function but the query takes exactly one word", takes_one_word)

} // namespace

TEST_CASE("a query of function 08 has 1 to 125 words")
{
    std::array<std::byte, 252> bytes{};
    test::random{8}.fill(bytes);
    for (std::size_t count = 0; count <= 126; ++count) {
        CAPTURE(count);
        diagnostics const query{subfunction::return_query_data, register_view{byte_view{bytes}.first(2 * count)}};
        if (count >= 1 and count <= 125) {
            CHECK(survives(query, [&](auto const& read) { return read == query; }));
        } else {
            CHECK(is_refused(query, errc::invalid_quantity));
        }
    }
}

TEST_CASE("function 08 is read in whole words only")
{
    std::array<std::byte, 260> bytes{};
    bytes[0] = std::byte{8};
    for (std::size_t size = 1; size <= bytes.size(); ++size) {
        CAPTURE(size);
        test::exact_bytes const pdu{byte_view{bytes}.first(size)};
        errc const expected = size < 3 or size % 2 == 0 ? errc::wrong_length
                              : size == 3 or size > 253 ? errc::invalid_quantity
                                                        : errc::none;
        CHECK(diagnostics<>::decode(pdu.view()).error() == expected);
    }
}
