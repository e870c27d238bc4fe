// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// A line that gives back what is sent.
#include <rtuwire/ask/words_read.hpp>

#include "support/manual_unit.hpp"
#include "support/proof.hpp"

#include <rtuwire/client/statistics.hpp>

using namespace rtuwire;
using namespace rtuwire::detail;
using test::asking;
using test::manual_unit;
using test::read_eta;
using test::response_1234;

namespace {

constexpr client_options echoing{.response_timeout = milliseconds(100), .retries = 0, .has_line_echo = true};
constexpr client_options count16{.response_timeout = milliseconds(100), .retries = 0};
constexpr auto write_cmd = "01 06 21 35 00 0F D3 FC"_hex;

constexpr bool is_taken_out()
{
    manual_unit unit{echoing};
    unit.ask(read_eta);
    unit.say(read_eta);
    bool const waits = unit.none_yet();
    unit.pass(milliseconds(2));
    unit.say(response_1234);
    return waits and unit.has(0x1234);
}
PROOF("the echo is taken out, and the response accepted", is_taken_out)

constexpr bool in_any_chunks()
{
    manual_unit unit{echoing};
    static_cast<void>(unit.link.start(request_frame{read_eta}, unit.now));
    // While it is sent, the first half comes back; the rest with the response.
    static_cast<void>(unit.link.poll_transmit());
    unit.link.receive(byte_view{read_eta}.first(5), unit.now);
    unit.link.sent(unit.now);
    unit.say(byte_view{read_eta}.subspan(5));
    unit.say(response_1234);
    return unit.has(0x1234);
}
PROOF("it may come in parts, and before the transmission is reported to be over", in_any_chunks)

constexpr bool ends_at_a_difference()
{
    line_echo echo;
    echo.begin();
    byte_view const first{read_eta.data(), 1};
    bool const agrees = echo.take(first, read_eta) == 1 and echo.is_open() and echo.taken() == 1;
    bool const differs = echo.take(first, read_eta) == 0;
    return agrees and differs and not echo.is_open() and not echo.is_whole() and echo.take(read_eta, read_eta) == 0;
}
PROOF("no byte behind one that differs belongs to the echo", ends_at_a_difference)

constexpr bool one_wrong_byte()
{
    manual_unit unit{echoing};
    unit.ask(read_eta);
    for (std::size_t i = 0; i < read_eta.size(); ++i) {
        std::byte const byte = i == 3 ? ~read_eta[i] : read_eta[i];
        unit.say({&byte, 1});
    }
    unit.run(milliseconds(200));
    return unit.fault() == errc::collision;
}
PROOF("one wrong byte is a collision, also where bytes come one by one", one_wrong_byte)

constexpr bool no_success_by_echo()
{
    manual_unit unit{echoing};
    unit.ask(write_cmd);
    unit.say(write_cmd);
    unit.run(milliseconds(500));
    bool const silent = unit.fault() == errc::timed_out;
    unit.ask(write_cmd);
    unit.say(write_cmd);
    unit.say(write_cmd);
    return silent and unit.fault() == errc::none;
}
PROOF("the echo of a write is no confirmation of it", no_success_by_echo)

constexpr bool sees_a_collision()
{
    manual_unit unit{echoing};
    unit.ask(read_eta);
    unit.say("01 03 0C 81 00 03 D7 72"_hex);
    unit.pass(milliseconds(5));
    unit.say(response_1234);
    bool const waits = unit.none_yet();
    unit.run(milliseconds(300));
    bool const told = unit.fault() == errc::collision;

    manual_unit patient{{.response_timeout = milliseconds(100), .retries = 1, .has_line_echo = true}};
    patient.ask(read_eta);
    patient.say("FF"_hex);
    patient.run(milliseconds(150));
    bool const again = patient.transmissions == 2;
    patient.say(read_eta);
    patient.say(response_1234);
    return waits and told and again and patient.has(0x1234);
}
PROOF("an echo that differs is a collision, and its response is not believed", sees_a_collision)

constexpr bool sees_a_broadcast_collide()
{
    constexpr auto everyone = "00 06 21 35 00 00 92 29"_hex;
    manual_unit unit{echoing};
    unit.ask(everyone);
    unit.say(everyone);
    unit.run(milliseconds(200));
    bool const sent = unit.fault() == errc::none;
    unit.ask(everyone);
    unit.say("00 07"_hex);
    unit.run(milliseconds(200));
    return sent and unit.fault() == errc::collision;
}
PROOF("a broadcast that collides is reported", sees_a_broadcast_collide)

constexpr bool without_being_told()
{
    manual_unit unit{count16};
    unit.ask(read_eta);
    unit.say(read_eta);
    unit.pass(milliseconds(2));
    unit.run(milliseconds(300));
    return unit.fault() == errc::line_echo;
}
PROOF("an echo that nobody spoke of is never a value", without_being_told)

/// A request on the line, of which so many bytes have come back while it leaves.
constexpr void let_come_back(test::basic_manual_unit<basic_client<observed_by<line_statistics>>>& unit,
                             std::size_t count)
{
    static_cast<void>(unit.link.start(request_frame{read_eta}, unit.now));
    static_cast<void>(unit.link.poll_transmit());
    unit.link.receive(byte_view{read_eta}.first(count), unit.now);
}
constexpr bool takes_no_part_for_the_whole()
{
    // Behind five the response's first byte is the next one of the echo as well.
    for (std::size_t const count : {0U, 1U, 3U, 4U, 5U, 6U, 7U, 8U}) {
        test::basic_manual_unit<basic_client<observed_by<line_statistics>>> unit{count16};
        let_come_back(unit, count);
        bool const waits = unit.none_yet();
        unit.now = unit.now + test::line.characters(read_eta.size());
        unit.link.sent(unit.now);
        unit.say(response_1234);
        bool const is_whole = count == read_eta.size();
        bool const ends = is_whole ? unit.fault() == errc::line_echo : unit.has(0x1234);
        if (not waits or not ends or unit.link.statistics().line()[line_event::mismatch] != (is_whole ? 1U : 0U)) {
            return false;
        }
    }
    return true;
}
PROOF("a request that came back whole ends when it has left, one that did in part is answered",
      takes_no_part_for_the_whole)

constexpr bool ends_with_its_last_byte()
{
    for (std::size_t count = 0; count < read_eta.size(); ++count) {
        test::basic_manual_unit<basic_client<observed_by<line_statistics>>> unit{count16};
        let_come_back(unit, count);
        unit.link.sent(unit.now);
        unit.link.receive(byte_view{read_eta}.subspan(count), unit.now);
        if (unit.fault() != errc::line_echo) {
            return false;
        }
    }
    return true;
}
PROOF("a request that comes back in part behind its end is known at its last byte", ends_with_its_last_byte)

constexpr auto read_status = "11 07 4C 22"_hex;

/// What becomes of a request of a function alone, where this comes back in pieces of so many bytes.
template <std::size_t Size>
constexpr bool ends(std::array<std::byte, Size> const& said, std::size_t piece, errc expected,
                    line_timing const& timing = test::line)
{
    asking<client> link{timing, count16};
    instant now{0xFFFF'FFFFU - 5'000'000U};
    link.advance(now);
    now = now + milliseconds(100);
    link.advance(now);
    static_cast<void>(link.start(request_frame{read_status}, now));
    static_cast<void>(link.poll_transmit());
    link.sent(now);
    for (std::size_t at = 0; at < Size; at += piece) {
        byte_view const bytes = byte_view{said}.subspan(at, piece < Size - at ? piece : Size - at);
        now = now + timing.characters(bytes.size());
        link.receive(bytes, now);
        link.advance(now);
    }
    for (int i = 0; i < 10; ++i) {
        now = now + milliseconds(20);
        link.advance(now);
    }
    auto const outcome = link.poll_outcome();
    return outcome and outcome->error() == expected and link.has_seen_echo() == (expected == errc::line_echo);
}
constexpr bool tells_a_response_from_an_echo()
{
    constexpr auto response = "11 07 4C 22 00"_hex; // the status is the first byte of the request's CRC
    constexpr auto with_response = "11 07 4C 22 11 07 05 E3 F6"_hex;
    constexpr auto with_refusal = "11 07 4C 22 11 87 01 83 F5"_hex;
    constexpr auto host = line_timing::host(19'200, character_format::even_8_1);
    for (std::size_t const piece : {1U, 4U, 9U}) {
        if (not ends(response, piece, errc::none) or not ends(read_status, piece, errc::line_echo) or
            not ends(read_status, piece, errc::line_echo, host) or
            not ends(read_status, piece, errc::line_echo, line_timing::without_wire()) or
            not ends(with_response, piece, errc::line_echo) or not ends(with_refusal, piece, errc::line_echo)) {
            return false;
        }
    }
    return true;
}
PROOF("a response that begins with the whole request is no echo", tells_a_response_from_an_echo)

/// What the probe finds on a line that does this.
template <typename Say> constexpr result<bool> probed(Say say)
{
    manual_unit unit{count16};
    line_echo_probe probe{unit_id{1}};
    unit.link.converse(probe, unit.now);
    unit.transmit();
    say(unit, probe.next()->frame());
    unit.run(milliseconds(300));
    unit.link.converse(probe, unit.now);
    return probe.outcome();
}

constexpr bool probes()
{
    auto const echo = [](manual_unit& unit, byte_view asked) { unit.say(asked); };
    auto const both = [](manual_unit& unit, byte_view asked) {
        unit.say(asked);
        unit.say(response_1234);
    };
    auto const response = [](manual_unit& unit, byte_view) { unit.say(response_1234); };
    auto const refusal = [](manual_unit& unit, byte_view) { unit.say("01 83 02 C0 F1"_hex); };
    auto const silence = [](manual_unit&, byte_view) {};
    return probed(echo) == true and probed(response) == false and probed(refusal) == false and
           probed(silence) == errc::timed_out and probed(both).has_value();
}
PROOF("a probe tells a line with echo from one without", probes)

} // namespace
