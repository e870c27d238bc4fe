// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// A line that gives back what is sent.
#include <rtuwire/client/echo_probe.hpp>

#include "support/far_end.hpp"
#include "support/proof.hpp"

using namespace rtuwire;
using test::answer_1234;
using test::far_end;
using test::read_eta;

namespace {

constexpr client_options echoing{
    .response_timeout = milliseconds(100), .retries = 0, .has_echo = true};
constexpr client_options plain{.response_timeout = milliseconds(100), .retries = 0};
constexpr auto write_cmd = "01 06 21 35 00 0F D3 FC"_hex;

constexpr bool is_taken_out()
{
    far_end unit{echoing};
    unit.ask(read_eta);
    unit.say(read_eta);
    bool const waits = unit.fault() == errc::busy;
    unit.pass(milliseconds(2));
    unit.say(answer_1234);
    return waits and unit.has(0x1234);
}
PROOF("the echo is taken out, and the answer accepted", is_taken_out)

constexpr bool in_any_chunks()
{
    far_end unit{echoing};
    static_cast<void>(unit.link.start(request{read_eta}, unit.now));
    // While it is sent, the first half comes back; the rest with the answer.
    static_cast<void>(unit.link.poll_transmit());
    unit.link.receive(byte_view{read_eta}.first(5), unit.now);
    unit.link.sent(unit.now);
    unit.say(byte_view{read_eta}.subspan(5));
    unit.say(answer_1234);
    return unit.has(0x1234);
}
PROOF("it may come in parts, and before the transmission is reported to be over", in_any_chunks)

constexpr bool ends_at_a_difference()
{
    echo_check echo;
    echo.begin();
    bool const agrees = echo.take(read_eta[0], read_eta) and echo.is_open();
    bool const differs = not echo.take(read_eta[0], read_eta);
    return agrees and differs and not echo.is_open();
}
PROOF("no octet behind one that differs belongs to the echo", ends_at_a_difference)

constexpr bool one_wrong_octet()
{
    far_end unit{echoing};
    unit.ask(read_eta);
    for (std::size_t i = 0; i < read_eta.size(); ++i) {
        std::byte const octet = i == 3 ? ~read_eta[i] : read_eta[i];
        unit.say({&octet, 1});
    }
    unit.run(milliseconds(200));
    return unit.fault() == errc::collision;
}
PROOF("one wrong octet is a collision, also where octets come one by one", one_wrong_octet)

constexpr bool no_success_by_echo()
{
    far_end unit{echoing};
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
    far_end unit{echoing};
    unit.ask(read_eta);
    unit.say("01 03 0C 81 00 03 D7 72"_hex);
    unit.pass(milliseconds(5));
    unit.say(answer_1234);
    bool const waits = unit.fault() == errc::busy;
    unit.run(milliseconds(300));
    bool const told = unit.fault() == errc::collision;

    far_end patient{{.response_timeout = milliseconds(100), .retries = 1, .has_echo = true}};
    patient.ask(read_eta);
    patient.say("FF"_hex);
    patient.run(milliseconds(150));
    bool const again = patient.transmissions == 2;
    patient.say(read_eta);
    patient.say(answer_1234);
    return waits and told and again and patient.has(0x1234);
}
PROOF("an echo that differs is a collision, and its answer is not believed", sees_a_collision)

constexpr bool sees_a_broadcast_collide()
{
    constexpr auto everyone = "00 06 21 35 00 00 92 29"_hex;
    far_end unit{echoing};
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
    far_end unit{plain};
    unit.ask(read_eta);
    unit.say(read_eta);
    unit.pass(milliseconds(2));
    unit.run(milliseconds(300));
    return unit.fault() == errc::echoed;
}
PROOF("an echo that nobody spoke of is never a value", without_being_told)

/// A request on the line, of which so many octets have come back while it leaves.
constexpr void let_come_back(test::basic_far_end<basic_client<line_statistics>>& unit,
                             std::size_t count)
{
    static_cast<void>(unit.link.start(request{read_eta}, unit.now));
    static_cast<void>(unit.link.poll_transmit());
    unit.link.receive(byte_view{read_eta}.first(count), unit.now);
}
constexpr bool takes_no_part_for_the_whole()
{
    // Behind five the answer's first octet would be the next one of the echo.
    for (std::size_t const count : {0U, 1U, 3U, 4U, 6U, 7U, 8U}) {
        test::basic_far_end<basic_client<line_statistics>> unit{plain};
        let_come_back(unit, count);
        bool const waits = unit.fault() == errc::busy;
        unit.now = unit.now + test::line.characters(read_eta.size());
        unit.link.sent(unit.now);
        unit.say(answer_1234);
        bool const is_whole = count == read_eta.size();
        bool const ends = is_whole ? unit.fault() == errc::echoed : unit.has(0x1234);
        if (not waits or not ends or
            unit.link.statistics().line()[line_event::mismatch] != (is_whole ? 1U : 0U)) {
            return false;
        }
    }
    return true;
}
PROOF("a request that came back whole ends when it has left, one that did in part is answered",
      takes_no_part_for_the_whole)

constexpr bool ends_with_its_last_octet()
{
    for (std::size_t count = read_eta.size() / 2; count < read_eta.size(); ++count) {
        test::basic_far_end<basic_client<line_statistics>> unit{plain};
        let_come_back(unit, count);
        unit.link.sent(unit.now);
        unit.link.receive(byte_view{read_eta}.subspan(count), unit.now);
        if (unit.fault() != errc::echoed) {
            return false;
        }
    }
    return true;
}
PROOF("a request that comes back in part behind its end is known at its last octet",
      ends_with_its_last_octet)

/// What the probe finds on a line that does this.
template <typename Say> constexpr result<bool> probed(Say say)
{
    far_end unit{plain};
    echo_probe probe{unit_id{1}};
    unit.link.converse(probe, unit.now);
    unit.transmit();
    say(unit, probe.next()->frame());
    unit.run(milliseconds(300));
    unit.link.converse(probe, unit.now);
    return probe.outcome();
}

constexpr bool probes()
{
    auto const echo = [](far_end& unit, byte_view asked) { unit.say(asked); };
    auto const both = [](far_end& unit, byte_view asked) {
        unit.say(asked);
        unit.say(answer_1234);
    };
    auto const answer = [](far_end& unit, byte_view) { unit.say(answer_1234); };
    auto const refusal = [](far_end& unit, byte_view) { unit.say("01 83 02 C0 F1"_hex); };
    auto const silence = [](far_end&, byte_view) {};
    return probed(echo) == true and probed(answer) == false and probed(refusal) == false and
           probed(silence) == errc::timed_out and probed(both).has_value();
}
PROOF("a probe tells a line with echo from one without", probes)

} // namespace
