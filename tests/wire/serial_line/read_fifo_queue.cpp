// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Function 24: every number of registers, every size.
#include <rtuwire/wire/serial_line/fifo_queue.hpp>

#include "support/pdu_facts.hpp"
#include "support/proof.hpp"

#include <rtuwire/core/hex.hpp>

using namespace rtuwire;
using namespace rtuwire::detail;

namespace {

constexpr bool is_as_printed()
{
    constexpr auto bytes = "18 00 06 00 02 01 B8 12 84"_hex;
    auto const told = read_fifo_queue_response::decode(bytes);
    using test::is;
    return is(test::goes_there_and_back(read_fifo_queue{0x04DE}), "request") and
           is(test::has_size<read_fifo_queue>("18 04 DE 00 00"_hex, 3), "sizes of a request") and
           is(read_fifo_queue::decode("18 04 DE"_hex) == read_fifo_queue{1246}, "address") and
           is(told and told->registers.size() == 2, "count") and
           is(told->registers[0] == 440 and told->registers[1] == 4740, "registers") and
           is(test::needs_room(*told, 12), "room") and
           is(read_fifo_queue_response::decode("17 00 02 00 00"_hex).error() == errc::wrong_function,
              "another function");
}
PROOF("function 24 is read as it is printed", is_as_printed)

} // namespace

TEST_CASE("function 24 is told 0 to 31 registers")
{
    test::sample const some{24};
    for (std::size_t count = 0; count <= 33; ++count) {
        CAPTURE(count);
        read_fifo_queue_response const told{register_view{some.first(2 * count)}};
        CHECK((count <= 31 ? test::survives(told, [&](auto const& read) { return read.registers == told.registers; })
                           : test::is_refused(told, errc::invalid_quantity)));
    }
}

TEST_CASE("a response of function 24 is read only where byte count, queue count and size agree")
{
    test::sample some{24};
    some.bytes[0] = std::byte{24};
    unsigned wrong = 0;
    for (std::uint32_t byte_count : {0U, 1U, 2U, 3U, 4U, 5U, 6U, 62U, 64U, 65U, 66U, 68U, 0x0100U, 0x0102U, 0xFFFFU}) {
        for (std::uint32_t count : {0U, 1U, 2U, 30U, 31U, 32U, 33U, 0x0100U, 0x0101U, 0x7FFFU, 0x8000U, 0xFFFFU}) {
            for (std::size_t size = 1; size <= some.bytes.size(); ++size) {
                put_u16(&some.bytes[1], static_cast<std::uint16_t>(byte_count));
                put_u16(&some.bytes[3], static_cast<std::uint16_t>(count));
                test::exact_bytes const pdu{some.first(size)};
                bool const agrees = size >= 5 and size == 3 + byte_count and size == 5 + std::size_t{2} * count;
                errc const expected = not agrees   ? errc::wrong_length
                                      : count > 31 ? errc::invalid_quantity
                                                   : errc::none;
                wrong += read_fifo_queue_response::decode(pdu.view()).error() == expected ? 0U : 1U;
            }
        }
    }
    CHECK(wrong == 0);
}
