// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Function 12: every number of events, every byte count and size.
#include <rtuwire/wire/serial_line/diagnostics.hpp>

#include "support/pdu_facts.hpp"
#include "support/proof.hpp"

#include <rtuwire/core/hex.hpp>

using namespace rtuwire;
using namespace rtuwire::detail;

namespace {

constexpr bool is_as_printed()
{
    using test::is;
    constexpr auto bytes = "0C 08 00 00 01 08 01 21 20 00"_hex;
    auto const told = get_comm_event_log_response::decode(bytes);
    return is(test::goes_there_and_back(get_comm_event_log{}), "request") and
           is(test::has_size<get_comm_event_log>("0C 00 00"_hex, 1), "sizes of a request") and
           is(told and told->status == 0 and told->events == 264 and told->messages == 289, "counters") and
           is(same_bytes(told->log, "20 00"_hex), "events") and is(test::needs_room(*told, 13), "room") and
           is(get_comm_event_log_response::decode("0B 06 00 00 00 00 00 00"_hex).error() == errc::wrong_function,
              "another function") and
           is(get_comm_event_log_response::decode("0C 06 00 01 00 00 00 00"_hex).error() == errc::malformed,
              "a status");
}
PROOF("function 12 is read as it is printed", is_as_printed)

} // namespace

TEST_CASE("function 12 is told up to 64 events")
{
    test::sample const some{12};
    for (std::size_t count = 0; count <= 66; ++count) {
        CAPTURE(count);
        get_comm_event_log_response const told{0xFFFF, 1, 2, some.first(count)};
        CHECK((count <= 64 ? test::survives(told,
                                            [&](auto const& read) {
                                                return read.status == 0xFFFF and read.events == 1 and
                                                       read.messages == 2 and same_bytes(read.log, told.log);
                                            })
                           : test::is_refused(told, errc::invalid_quantity)));
    }
    CHECK(test::is_refused(get_comm_event_log_response{1, 0, 0, {}}, errc::malformed));
}

TEST_CASE("a response of function 12 has 6 to 70 bytes, as its byte count says")
{
    test::sample some{12};
    some.bytes[2] = some.bytes[3] = std::byte{0xFF}; // a status
    auto const told = [](std::uint32_t byte_count, byte_view) {
        return byte_count < 6 ? errc::wrong_length : byte_count <= 70 ? errc::none : errc::invalid_quantity;
    };
    CHECK(test::misread_byte_counts<get_comm_event_log_response>(some, told) == 0);
}
