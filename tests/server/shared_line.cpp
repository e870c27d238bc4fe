// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// A unit among others: whatever they say, only a request to it is obeyed, and none is missed.
#include <rtuwire/server/server.hpp>

#include "support/proof.hpp"
#include "support/server_on_a_line.hpp"

#include <rtuwire/core/hex.hpp>
#include <rtuwire/wire/registers.hpp>
#include <rtuwire/wire/serial_line/device_identification.hpp>

using namespace rtuwire;
using namespace rtuwire::detail;

namespace {

/// A host's times: its silence is long, and between the frames here there is none.
constexpr auto host_line = line_timing::host(19'200, character_format::even_8_1);

/// Our unit 1, and unit 2 with as many registers on the same line.
struct two_units : test::server_on_a_line<server, word_bank<16>> {
    server other{unit_id{2}, host_line};
    word_bank<16> others{};

    constexpr two_units() : server_on_a_line{host_line}
    {
        pass({});
        pass(milliseconds(60));
    }

    constexpr void pass(duration length)
    {
        server_on_a_line::pass(length);
        other.advance(now);
        other.serve(others, now);
    }

    constexpr void hear(byte_view bytes)
    {
        receive(bytes);
        pass({});
    }
    template <pdu Request> constexpr void hear(unit_id unit, Request const& request)
    {
        auto const frame = *encode(unit, request);
        hear(frame);
    }

    /// A request to unit 2, and its response.
    template <pdu Request> constexpr void between_others(Request const& request)
    {
        auto const frame = *encode(unit_id{2}, request);
        hear(frame);
        other.receive(frame, now);
        pass(line.t3_5());
        byte_view const response = other.poll_transmit();
        hear(response);
        other.sent(now);
    }

    /// Whether a write to us is obeyed.
    constexpr bool obeys(std::uint16_t word)
    {
        hear(unit_id{1}, write_single_register{1, word});
        pass(line.t3_5());
        static_cast<void>(send());
        return bank.get(1) == word;
    }
};

constexpr bool hears_at_once()
{
    two_units it;
    it.between_others(read_holding_registers{0, 4});
    bool ok = it.obeys(1);
    it.between_others(write_single_register{0, 7});
    ok = it.obeys(2) and ok;
    it.between_others(write_multiple_registers{0, register_block{1, 2, 3}});
    ok = it.obeys(3) and ok;
    it.between_others(read_write_multiple_registers{0, 3, 2, register_block{5}});
    ok = it.obeys(4) and ok;
    it.between_others(read_holding_registers{99, 4}); // an exception
    ok = it.obeys(5) and ok;
    it.between_others(read_holding_registers{0, 1});
    it.between_others(read_holding_registers{0, 1});
    return it.obeys(6) and ok and it.others.get(0) == 1;
}
PROOF("after another unit's answer the next request is heard without a silence", hears_at_once)

constexpr bool not_from_the_data()
{
    // Unit 2 holds a whole request to unit 1.
    constexpr auto request = encode(unit_id{1}, write_single_register{1, 3});
    byte_view const bytes = *request;
    two_units it;
    for (std::size_t i = 0; i < 4; ++i) {
        static_cast<void>(it.others.set(static_cast<std::uint16_t>(i), u16_at(bytes, 2 * i)));
    }
    it.between_others(read_holding_registers{0, 4});
    bool const heeds_not = it.bank.get(1) == 0;
    return heeds_not and it.obeys(9);
}
PROOF("another unit's answer that holds a request to us is no request", not_from_the_data)

constexpr bool not_after_a_lost_request()
{
    constexpr auto response = "02 03 08 01 06 00 01 00 03 98 0B DA 98"_hex;
    two_units it;
    it.hear(response); // its request was not heard
    bool const is_listen_only = not it.obeys(3);
    it.pass(host_line.frame_end());
    return is_listen_only and it.obeys(4);
}
PROOF("a response without its request silences the ear until the line is quiet", not_after_a_lost_request)

/// The pause of a client between its frames: far from the silence that ends a frame on a host.
constexpr duration pause = milliseconds(5);

constexpr bool never_answered()
{
    two_units it;
    auto const request = *encode(unit_id{2}, read_holding_registers{0, 4});
    bool ok = true;
    for (std::uint16_t i = 1; i <= 3; ++i) {
        it.hear(request);
        it.pass(pause);
        it.hear(request); // the client's second try
        it.pass(pause);
        it.hear(unit_id{2}, read_holding_registers{3201, 6}); // another, of the same function
        it.pass(pause);
        it.hear(unit_id{2}, write_single_register{0, 7});
        it.pass(pause);
        ok = it.obeys(i) and ok;
        it.pass(pause);
    }
    return ok;
}
PROOF("a unit that never answers keeps nobody from hearing", never_answered)

constexpr bool repeated_then_answered()
{
    two_units it;
    it.hear(unit_id{2}, read_holding_registers{0, 4});
    it.pass(pause);
    it.between_others(read_holding_registers{0, 4});
    it.pass(pause);
    bool const ok = it.obeys(1);
    it.hear(unit_id{2}, read_holding_registers{99, 4});
    it.pass(pause);
    it.between_others(read_holding_registers{99, 4}); // an exception
    it.pass(pause);
    return ok and it.obeys(2);
}
PROOF("a request that is repeated and then answered keeps nobody from hearing", repeated_then_answered)

/// Frames whose first part has a right CRC as well, because the last byte is 00 (bus-faults rule 7): the
/// first 8 of 9 bytes could be a request, or the first 4 of 5.
constexpr auto asks_for_two = "02 03 00 00 00 02 C4 38"_hex;
constexpr auto two_that_end_with_00 = "02 03 04 00 00 00 44 C9 00"_hex;
constexpr auto asks_for_status = "04 07 42 B2"_hex;
constexpr auto status_that_ends_with_00 = "04 07 42 B2 00"_hex;
constexpr auto request_that_ends_with_00 = "04 03 02 00 00 74 44 00"_hex;
constexpr auto one_word_of_4 = "04 03 02 00 00 74 44"_hex;

constexpr bool hears_behind(byte_view request, byte_view response, duration before, duration behind)
{
    two_units it;
    it.hear(request);
    it.pass(before);
    it.hear(response);
    it.pass(behind);
    return it.obeys(1);
}

constexpr bool ends_with_00()
{
    bool ok = true;
    for (duration const before : {duration{}, pause}) {
        for (duration const behind : {duration{}, pause}) {
            ok = ok and hears_behind(asks_for_two, two_that_end_with_00, before, behind);
            ok = ok and hears_behind(asks_for_status, status_that_ends_with_00, before, behind);
            ok = ok and hears_behind(request_that_ends_with_00, request_that_ends_with_00, before, behind);
            ok = ok and hears_behind(request_that_ends_with_00, one_word_of_4, before, behind);
            ok = ok and hears_behind(asks_for_two, asks_for_two, before, behind);
            ok = ok and hears_behind(asks_for_status, asks_for_status, before, behind);
        }
    }
    return ok;
}
PROOF("a response whose last byte is 00 ends whole, and so does a request in its place", ends_with_00)

constexpr bool broadcast_behind()
{
    // Its size is that of a response, and one byte less than that of a request.
    constexpr auto asks_for_one = "07 03 00 00 00 01 84 6C"_hex;
    constexpr auto one_word = "07 03 02 00 00 30 44"_hex;
    constexpr auto everyone_writes_3 = "00 06 00 01 00 03 99 DA"_hex;
    two_units it;
    it.hear(asks_for_one);
    it.hear(one_word);
    it.pass(host_line.t3_5());
    it.hear(everyone_writes_3);
    return it.bank.get(1) == 3;
}
PROOF("a byte 00 after a silence of t3.5 begins a broadcast", broadcast_behind)

constexpr bool broadcast_glued()
{
    // As the start of a response it would be 17 bytes long: it ends here, and no byte behind it is its own.
    auto const request = *encode(unit_id{2}, read_holding_registers{3201, 6});
    two_units it;
    it.hear(request);
    it.hear(request);
    bool const ends = it.node.poll_deadline() == deadline{it.now + host_line.silence()}; // not that of a frame's end
    it.hear("00 06 00 01 00 03 99 DA"_hex);
    return ends and it.bank.get(1) == 3;
}
PROOF("a repeated request ends at once where the response would be far longer", broadcast_glued)

constexpr bool damaged_response()
{
    two_units it;
    it.hear(unit_id{2}, read_holding_registers{0, 4});
    it.hear("02 03 08 01 06 00 01 00 03 98 0B DA 99"_hex);
    bool const is_listen_only = not it.obeys(3);
    it.pass(host_line.frame_end());
    return is_listen_only and it.obeys(4);
}
PROOF("after a damaged response only silence opens the ear", damaged_response)

} // namespace
