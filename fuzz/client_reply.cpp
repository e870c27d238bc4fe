// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Any bytes as the response to a request, at once: what is accepted has the unit, function, length and
// echo of the request and a right CRC.
#include <rtuwire/rtuwire.hpp>

#include "input.hpp"

#include "../tests/support/asking.hpp"

using namespace rtuwire;
using fuzz::require;

namespace {

constexpr unit_id unit{1};
auto const read = *encode(unit, read_holding_registers{3201, 3});
auto const write = *encode(unit, write_single_register{8501, 15});
auto const block = *encode(unit, write_multiple_registers{9001, register_block{20, 30}});
auto const both = *encode(unit, read_write_multiple_registers{12741, 4, 12761, register_block{6}});
auto const test_line = *encode(unit, diagnostics{subfunction::return_query_data, register_block{7}});
auto const who = *encode(unit, read_device_identification{});

byte_view request(std::uint8_t choice)
{
    switch (choice % 6U) {
    case 0: return read;
    case 1: return write;
    case 2: return block;
    case 3: return both;
    case 4: return test_line;
    default: return who;
    }
}

/// Whether a whole frame of the unit with this PDU was heard. Others may have come before it.
bool was_heard(byte_view heard, std::byte from, byte_view pdu)
{
    std::size_t const size = pdu.size() + adu_overhead;
    for (; heard.size() >= size; heard = heard.subspan(1)) {
        bool const is_it = heard[0] == from and same_bytes(heard.subspan(1, pdu.size()), pdu);
        if (is_it and crc16(heard.first(size)) == 0) {
            return true;
        }
    }
    return false;
}

void check(byte_view asked, byte_view pdu, byte_view heard)
{
    require(was_heard(heard, asked[0], pdu) and pdu[0] == asked[1]);
    switch (to_u8(asked[1])) {
    case 3: require(pdu.size() == 8 and to_u8(pdu[1]) == 6); break;
    case 23: require(pdu.size() == 10 and to_u8(pdu[1]) == 8); break;
    case 6:
    case 16: require(same_bytes(pdu, asked.subspan(1, 5))); break;
    case 8: require(same_bytes(pdu, asked.subspan(1, asked.size() - adu_overhead))); break;
    default: require(device_identification::decode(pdu).has_value()); break;
    }
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(std::uint8_t const* data, std::size_t size)
{
    fuzz::input in{data, size};
    std::uint8_t const choice = in.u8();
    byte_view const asked = request(choice);
    fuzz::frame const heard{in.some(max_adu_size + 8), (choice & 0x80U) != 0};
    test::asking<client> link{line_timing{19'200, character_format::even_8_1}, {.retries = 0}};
    instant now{0};
    link.advance(now);
    now = now + milliseconds(10);
    link.advance(now);
    require(link.start(request_frame{asked}, now).has_value());
    require(same_bytes(link.poll_transmit(), asked));
    link.sent(now);
    link.receive(heard.view(), now + milliseconds(200));
    now = now + milliseconds(300);
    link.advance(now);
    now = now + milliseconds(10'000);
    link.advance(now);
    auto const outcome = link.poll_outcome();
    if (outcome and *outcome) {
        check(asked, (*outcome)->pdu(), heard.view());
    }
    return 0;
}
