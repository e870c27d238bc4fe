// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// One request and what may come of it.
#include <rtuwire/client/client.hpp>

#include "support/manual_unit.hpp"
#include "support/proof.hpp"

using namespace rtuwire;
using namespace rtuwire::detail;
using test::line;
using test::manual_unit;
using test::read_eta;
using test::response_1234;

namespace {

STATIC_CHECK(crc16(read_eta) == 0 and crc16(test::read_next) == 0);

constexpr bool has_response()
{
    manual_unit unit;
    bool const asked = unit.ask(read_eta) and unit.link.is_busy();
    unit.pass(milliseconds(5));
    unit.say(response_1234);
    return asked and unit.has(0x1234) and not unit.link.is_busy() and unit.transmissions == 1;
}
PROOF("a request is answered", has_response)

constexpr bool early_response()
{
    manual_unit unit;
    unit.ask(read_eta);
    // Drives answer after three characters, before our own t3.5 is over.
    unit.pass(line.characters(3));
    unit.say(response_1234);
    return unit.has(0x1234);
}
PROOF("a response may come before t3.5 is over", early_response)

constexpr bool waits_before_sending()
{
    manual_unit unit;
    unit.say("00"_hex);
    static_cast<void>(unit.link.start(request_frame{read_eta}, unit.now));
    unit.pass(microseconds(line.t3_5().microseconds - 1));
    bool const silent = unit.link.poll_transmit().empty();
    unit.pass(microseconds(1));
    return silent and same_bytes(unit.link.poll_transmit(), read_eta) and unit.link.poll_transmit().empty();
}
PROOF("a request is sent after t3.5 of silence, and once", waits_before_sending)

constexpr bool power_up()
{
    test::asking<client> link{line};
    instant now{77};
    link.advance(now);
    static_cast<void>(link.start(request_frame{read_eta}, now));
    bool const silent = link.poll_transmit().empty() and link.poll_deadline() == deadline{now + line.t3_5()};
    link.advance(now + line.t3_5());
    return silent and not link.poll_transmit().empty();
}
PROOF("at power-up the line must be silent first", power_up)

constexpr bool gives_up_in_time(std::uint8_t retries)
{
    manual_unit unit{{.retries = retries}};
    unit.ask(read_eta);
    unit.run(milliseconds(10'000));
    return unit.fault() == errc::timed_out and unit.transmissions == 1U + retries;
}
constexpr bool gives_up_at_once() { return gives_up_in_time(0); }
constexpr bool gives_up_after_two() { return gives_up_in_time(2); }
PROOF("silence without retries is one transmission", gives_up_at_once)
PROOF("silence with two retries is three transmissions", gives_up_after_two)

constexpr bool time_out_is_exact()
{
    manual_unit unit{{.response_timeout = milliseconds(300), .retries = 0}};
    unit.ask(read_eta);
    duration const limit = milliseconds(300) + line.characters(response_1234.size());
    unit.pass(microseconds(limit.microseconds - 1));
    bool const waits = unit.none_yet();
    unit.pass(microseconds(1));
    return waits and unit.fault() == errc::timed_out;
}
PROOF("the time-out is the response time-out and the response's own time", time_out_is_exact)

template <std::size_t Size> constexpr bool refusal_is(std::array<std::byte, Size> const& response, errc expected)
{
    manual_unit unit;
    unit.ask(read_eta);
    unit.say(response);
    return unit.fault() == expected and unit.transmissions == 1;
}
constexpr bool refusals()
{
    return refusal_is("01 83 01 80 F0"_hex, errc::illegal_function) and
           refusal_is("01 83 02 C0 F1"_hex, errc::illegal_data_address) and
           refusal_is("01 83 04 40 F3"_hex, errc::server_device_failure) and
           refusal_is("01 83 7F 00 D0"_hex, static_cast<errc>(0x7F)) and
           refusal_is("01 83 00 41 30"_hex, errc::unlisted_exception);
}
PROOF("an exception is the outcome, with its number, and is not repeated", refusals)

constexpr bool ignores_other_units()
{
    manual_unit unit;
    unit.ask(read_eta);
    unit.pass(milliseconds(2));
    unit.say("02 03 02 12 34 F1 33"_hex);
    bool const waits = crc16("02 03 02 12 34 F1 33"_hex) == 0 and unit.none_yet();
    unit.say(response_1234);
    return waits and unit.has(0x1234);
}
PROOF("another unit's answer is ignored while the timer runs", ignores_other_units)

constexpr bool repeats_after_damage()
{
    manual_unit unit;
    unit.ask(read_eta);
    unit.say("01 03 02 12 34 B4 33"_hex);
    unit.run(milliseconds(20));
    bool const repeated = unit.transmissions == 2 and unit.none_yet();
    unit.say(response_1234);
    return repeated and unit.has(0x1234);
}
PROOF("a damaged response of the unit is followed by a repetition after silence", repeats_after_damage)

template <std::size_t Size> constexpr bool never_accepted(std::array<std::byte, Size> const& bytes, errc expected)
{
    manual_unit unit{{.response_timeout = milliseconds(200), .retries = 0}};
    unit.ask(read_eta);
    unit.say(bytes);
    unit.run(milliseconds(1'000));
    return unit.fault() == expected;
}
constexpr bool wrong_answers()
{
    using test::is;
    return is(never_accepted("01 04 02 12 34 B4 47"_hex, errc::wrong_function), "a read of input registers") and
           is(never_accepted("01 03 00 20 F0"_hex, errc::wrong_length), "no register") and
           is(never_accepted("01 03 03 12 34 56 73 75"_hex, errc::wrong_length), "a register and a half") and
           is(never_accepted("01 83 02 C0 E1"_hex, errc::crc_mismatch), "a damaged exception") and
           is(never_accepted("00 01 03 02 12 34 B5 33"_hex, errc::crc_mismatch), "a byte before the response") and
           is(never_accepted("01 03 01 03 02 12 34 B5 33"_hex, errc::crc_mismatch),
              "a beginning before the response") and
           is(never_accepted("01 03 02 12 34"_hex, errc::crc_mismatch), "a response without its CRC") and
           is(never_accepted("01"_hex, errc::timed_out), "a single byte") and
           is(never_accepted("01 06 0C 81 00 01 1B 72"_hex, errc::wrong_function), "the response to a write");
}
PROOF("what is no response to the request is never accepted, and said at the end", wrong_answers)

constexpr bool takes_the_first_of_two()
{
    constexpr auto two = "01 03 02 12 34 B5 33 01 03 02 56 78 87 C6"_hex;
    manual_unit unit;
    unit.ask(read_eta);
    unit.say(two);
    return unit.has(0x1234) and unit.none_yet();
}
PROOF("a second response behind the first is noise", takes_the_first_of_two)

constexpr bool poisoned()
{
    manual_unit unit{{.retries = 0}};
    unit.ask(read_eta);
    unit.link.receive(byte_view{response_1234}.first(4), unit.now);
    unit.link.receive_error(unit.now);
    unit.link.receive(byte_view{response_1234}.subspan(4), unit.now);
    unit.run(milliseconds(2'000));
    return unit.fault() == errc::uart_error;
}
PROOF("a response with a damaged byte is refused even if its CRC is right", poisoned)

} // namespace
