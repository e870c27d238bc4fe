// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Function 17: every byte count and size.
#include <rtuwire/wire/serial_line/unit_report.hpp>

#include "support/pdu_facts.hpp"
#include "support/proof.hpp"

#include <rtuwire/core/hex.hpp>

using namespace rtuwire;
using namespace rtuwire::detail;

namespace {

constexpr bool is_one_byte()
{
    constexpr auto bytes = "11 03 12 FF 34"_hex;
    auto const told = report_server_id_response::decode(bytes);
    using test::is;
    return is(test::goes_there_and_back(report_server_id{}), "request") and
           is(test::has_size<report_server_id>("11 00 00"_hex, 1), "sizes of a request") and
           is(told and same_bytes(told->data, "12 FF 34"_hex), "data") and is(test::needs_room(*told, 8), "room") and
           is(report_server_id_response::decode("10 01 12"_hex).error() == errc::wrong_function, "another function");
}
PROOF("function 17 is one byte, and is told bytes", is_one_byte)

} // namespace

TEST_CASE("function 17 is told 1 to 251 bytes")
{
    test::sample const some{17};
    for (std::size_t size = 0; size <= 252; ++size) {
        CAPTURE(size);
        report_server_id_response const told{some.first(size)};
        CHECK((size >= 1 and size <= 251
                   ? test::survives(told, [&](auto const& read) { return same_bytes(read.data, told.data); })
                   : test::is_refused(told, errc::invalid_quantity)));
    }
}

TEST_CASE("a response of function 17 is read as its byte count says")
{
    auto const told = [](std::uint32_t byte_count, byte_view) {
        return byte_count >= 1 and byte_count <= 251 ? errc::none : errc::invalid_quantity;
    };
    CHECK(test::misread_byte_counts<report_server_id_response>(test::sample{17}, told) == 0);
}
