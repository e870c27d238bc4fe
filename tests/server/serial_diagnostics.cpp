// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Function 08 with its counters, and the listen-only mode.
#include <rtuwire/server/serial_diagnostics.hpp>

#include "support/proof.hpp"
#include "support/server_on_a_line.hpp"

#include <rtuwire/core/hex.hpp>
#include <rtuwire/server/server.hpp>
#include <rtuwire/wire/raw.hpp>

using namespace rtuwire;
using namespace rtuwire::detail;

namespace {

constexpr std::uint16_t nothing = 0xFFFF;

/// Unit 1 with one register, and its line.
template <typename Server = counting_server> struct counted : test::server_on_a_line<Server, word_bank<1>> {
    using base = test::server_on_a_line<Server, word_bank<1>>;
    using base::ask;
    using base::line;
    using base::node;
    using base::now;
    using base::pass;

    constexpr void hear(byte_view bytes)
    {
        this->receive(bytes);
        pass(line.t3_5());
    }

    /// The word that a sub-function returns.
    constexpr std::uint16_t word(std::uint8_t what)
    {
        std::array<std::byte, 5> const pdu{std::byte{8}, std::byte{0}, std::byte{what}};
        byte_view const response = ask(pdu);
        bool const is_normal = response.size() == 8 and response[1] == std::byte{8};
        return is_normal ? u16_at(response, 4) : nothing;
    }

    constexpr bool is_refused(byte_view pdu, errc code)
    {
        byte_view const response = ask(pdu);
        return response.size() == 5 and response[1] == std::byte{0x88} and
               to_u8(response[2]) == static_cast<std::uint8_t>(code);
    }
};

constexpr bool counts()
{
    counted<> unit;
    bool ok = unit.word(0x0B) == 1 and unit.word(0x0E) == 2;
    static_cast<void>(unit.ask("03 00 00 00 01"_hex));    // answered
    static_cast<void>(unit.ask("03 00 09 00 01"_hex));    // refused
    static_cast<void>(unit.ask("06 00 00 00 07"_hex, 0)); // everyone
    static_cast<void>(unit.ask("06 00 09 00 07"_hex, 0)); // everyone, and wrong
    static_cast<void>(unit.ask("03 00 00 00 01"_hex, 9)); // somebody else
    unit.hear("01 03 00 00 00 01 00 00"_hex);             // damaged
    unit.pass(milliseconds(5));
    unit.node.receive_overrun(unit.now);
    unit.pass(milliseconds(5));
    ok = ok and unit.bank.get(0) == 7;
    using test::is;
    return is(ok, "it begins at nothing, and the write to everyone is carried out") and
           is(unit.word(0x0B) == 8, "eight messages on the line") and
           is(unit.word(0x0C) == 2, "two damaged messages") and is(unit.word(0x0D) == 2, "two exceptions") and
           is(unit.word(0x0E) == 10, "ten messages to this unit") and
           is(unit.word(0x0F) == 2, "two messages without an answer") and
           is(unit.word(0x10) == 0, "no negative acknowledgement") and
           is(unit.word(0x11) == 0, "no refusal as busy") and is(unit.word(0x12) == 1, "one overrun") and
           is(unit.word(0x02) == 0, "the diagnostic register is 0");
}
PROOF("messages, errors, exceptions, requests and silences are counted", counts)

constexpr auto request = "03 00 00 00 01"_hex;

constexpr bool counts_requests_to_everyone()
{
    counted<> unit;
    bool const is_silent = unit.ask(request, 0).empty();
    return is_silent and unit.word(0x0D) == 1 and unit.word(0x0F) == 1;
}
PROOF("a request to everyone is an exception that nobody hears", counts_requests_to_everyone)

constexpr bool clears()
{
    counted<> unit;
    unit.node.receive_overrun(unit.now);
    unit.pass(milliseconds(5));
    using test::is;
    return is(unit.word(0x12) == 1, "one overrun") and is(unit.word(0x14) == 0, "14 is answered") and
           is(unit.word(0x12) == 0, "14 clears the overruns") and is(unit.word(0x0C) == 1, "14 leaves the errors") and
           is(unit.word(0x0A) == 0, "0A is answered") and is(unit.word(0x0C) == 0, "0A clears the errors") and
           is(unit.word(0x0B) == 2, "0A clears the messages") and is(unit.word(0x01) == 0, "01 is answered") and
           is(unit.word(0x0B) == 1, "01 clears the messages");
}
PROOF("the counters are cleared by 0A, by 01 and the overruns by 14", clears)

constexpr bool refuses()
{
    counted<> unit;
    using test::is;
    return is(unit.is_refused("08 00 05 00 00"_hex, errc::illegal_function), "sub-function 0005") and
           is(unit.is_refused("08 00 13 00 00"_hex, errc::illegal_function), "sub-function 0013") and
           is(unit.is_refused("08 00 15 00 00"_hex, errc::illegal_function), "sub-function 0015") and
           is(unit.is_refused("08 FF 00 00 00"_hex, errc::illegal_function), "sub-function FF00") and
           is(unit.is_refused("08 00 01 12 34"_hex, errc::illegal_data_value), "a restart with other data") and
           is(unit.is_refused("08 00 03 41 01"_hex, errc::illegal_data_value), "a delimiter of two bytes") and
           is(unit.is_refused("08 00 0B 00 01"_hex, errc::illegal_data_value), "a counter with data") and
           is(unit.is_refused("08 00 0B"_hex, errc::illegal_data_value), "a counter without its field") and
           is(unit.word(0x03) == 0, "a delimiter may be set") and is(unit.word(0x0D) == 8, "eight exceptions") and
           is(unit.node.poll_transmit().empty(), "nothing more is sent");
}
PROOF("reserved sub-functions get 01, other data 03", refuses)

constexpr bool only_listens()
{
    counted<> unit;
    bool ok = unit.ask("08 00 04 00 00"_hex).empty();
    ok = ok and unit.ask("06 00 00 00 07"_hex).empty() and unit.bank.get(0) == 0;
    ok = ok and unit.ask("06 00 00 00 07"_hex, 0).empty() and unit.bank.get(0) == 0;
    ok = ok and unit.word(0x0B) == nothing and unit.word(0x0A) == nothing and unit.ask("08 00 01 12 34"_hex).empty();
    ok = ok and unit.ask("08 00 01 FF 00"_hex).empty();
    ok = ok and unit.word(0x0B) == 1;
    static_cast<void>(unit.ask("06 00 00 00 07"_hex));
    return ok and unit.bank.get(0) == 7;
}
PROOF("a server that listens only acts on nothing but a restart, and answers nothing", only_listens)

constexpr auto query = "08 00 00 A5 37"_hex;
constexpr auto bus_messages = "08 00 0B 00 00"_hex;
constexpr auto listen_only = "08 00 04 00 00"_hex;

constexpr bool loops_back()
{
    counted<server> unit;
    byte_view const response = unit.ask(query);
    bool ok = response.size() == 8 and same_bytes(response.subspan(1, query.size()), query);
    ok = ok and unit.is_refused(bus_messages, errc::illegal_function);
    return ok and unit.is_refused(listen_only, errc::illegal_function);
}
PROOF("a plain server loops back, and cannot be silenced", loops_back)

constexpr auto read_0 = "01 03 00 00 00 01 84 0A"_hex;

constexpr bool counts_what_was_dropped()
{
    counted<> unit;
    unit.node.receive(read_0, unit.now); // dropped before it was served
    unit.node.receive(read_0, unit.now); // its response is dropped
    unit.node.serve(unit.bank, unit.now);
    unit.node.receive_error(unit.now); // behind a request: counts nowhere
    unit.node.receive(read_0, unit.now);
    unit.pass(milliseconds(5));
    bool const ok = unit.word(0x0F) == 1 and unit.word(0x0C) == 0;
    return ok and unit.word(0x0B) == 5 and unit.word(0x0E) == 5;
}
PROOF("a dropped request is a message only, a dropped response a silence", counts_what_was_dropped)

constexpr bool counts_a_response_that_is_too_late()
{
    counted<> unit;
    unit.node.receive(read_0, unit.now);
    unit.node.serve(unit.bank, unit.now);
    unit.pass(milliseconds(500)); // nobody took it
    return unit.node.poll_transmit().empty() and unit.word(0x0F) == 1;
}
PROOF("a response that nobody takes in time is a silence", counts_a_response_that_is_too_late)

constexpr bool counts_in_listen_only()
{
    counted<> unit;
    static_cast<void>(unit.ask(listen_only));
    static_cast<void>(unit.ask("03 00 09 00 01"_hex));
    static_cast<void>(unit.ask("08 00 01 00 00"_hex));
    return unit.word(0x0F) == 1 and unit.word(0x0D) == 0 and unit.word(0x0E) == 3;
}
PROOF("a restart out of the listen-only mode is itself not answered", counts_in_listen_only)

constexpr auto naks = "08 00 10 00 00"_hex;
constexpr auto busies = "08 00 11 00 00"_hex;
constexpr auto exceptions = "08 00 0D 00 00"_hex;

constexpr bool counts_kinds_of_refusal()
{
    serial_diagnostics unit;
    unit.note_end(function_code::diagnostics, errc::negative_acknowledge);
    unit.note_end(function_code::diagnostics, errc::server_device_busy);
    unit.note_end(function_code::diagnostics, errc::server_device_busy);
    auto const counted = [&unit](byte_view asked, std::uint16_t count) {
        std::array<std::byte, max_pdu_size> bytes{};
        byte_writer{bytes}.bytes(asked);
        pdu_buffer pdu{bytes, asked.size()};
        return unit.response(pdu) == errc::none and u16_at(pdu.view(), 3) == count;
    };
    return counted(naks, 1) and counted(busies, 2) and counted(exceptions, 3);
}
PROOF("NAK and busy are counted for themselves", counts_kinds_of_refusal)

static_assert(sizeof(server) < sizeof(counting_server));

} // namespace
