// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Function 11: every status, every size.
#include <rtuwire/wire/serial_line/diagnostics.hpp>

#include "support/length.hpp"
#include "support/pdu_facts.hpp"
#include "support/proof.hpp"

#include <rtuwire/core/hex.hpp>

using namespace rtuwire;
using namespace rtuwire::detail;

namespace {

constexpr bool has_its_sizes()
{
    using test::is;
    return is(test::goes_there_and_back(get_comm_event_counter{}), "request") and
           is(test::has_size<get_comm_event_counter>("0B 00 00"_hex, 1), "sizes of a request") and
           is(test::has_size<get_comm_event_counter_response>("0B FF FF 01 08 00 00"_hex, 5), "sizes of a response") and
           is(get_comm_event_counter_response::decode("0C FF FF 01 08"_hex) == errc::wrong_function,
              "another function");
}
PROOF("function 11 is one byte, and is told five", has_its_sizes)

constexpr bool is_as_printed()
{
    auto const told = get_comm_event_counter_response::decode("0B FF FF 01 08"_hex);
    return told == get_comm_event_counter_response{0xFFFF, 264} and told->is_busy() and
           not get_comm_event_counter_response{0, 264}.is_busy();
}
PROOF("function 11 is read as it is printed", is_as_printed)

// The last two bytes stand for the CRC.
STATIC_CHECK(test::is_told(direction::request, "02 0B 00 00"_hex));
STATIC_CHECK(test::is_told(direction::response, "02 0B FF FF 01 08 00 00"_hex));

} // namespace

TEST_CASE("of all 65536 statuses of function 11, 0000 and FFFF are written and read")
{
    unsigned wrong = 0;
    for (std::uint32_t status = 0; status <= 0xFFFF; ++status) {
        get_comm_event_counter_response const told{static_cast<std::uint16_t>(status), 264};
        std::array<std::byte, 5> const pdu{std::byte{11}, to_byte(status >> 8U), to_byte(status), {}, {}};
        auto const read = get_comm_event_counter_response::decode(pdu);
        bool const is_right = status == 0 or status == 0xFFFF
                                  ? test::goes_there_and_back(told) and read
                                  : test::is_refused(told, errc::malformed) and read.error() == errc::malformed;
        wrong += is_right ? 0U : 1U;
    }
    CHECK(wrong == 0);
}
