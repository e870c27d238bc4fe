// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// What a client counts, and what counting nothing costs.
#include <rtuwire/client/statistics.hpp>

#include <rtuwire/client/client.hpp>

#include "support/errors.hpp"
#include "support/manual_unit.hpp"
#include "support/proof.hpp"

using namespace rtuwire;
using namespace rtuwire::detail;
using test::read_eta;
using test::response_1234;

namespace {

using counting_end = test::basic_manual_unit<basic_client<observed_by<unit_statistics<2>>>>;

constexpr client_options impatient{
    .response_timeout = milliseconds(50), .late_response = milliseconds(100), .retries = 0, .max_leading_noise = 1};

constexpr std::uint32_t of_unit(counting_end const& unit, line_event what)
{
    counters const* const own = unit.link.statistics().unit(1);
    return own == nullptr ? 0 : (*own)[what];
}

constexpr bool sorts_by_kind()
{
    struct pair {
        errc found;
        line_event counted;
    };
    constexpr pair all[] = {
        {errc::none, line_event::reply},
        {errc::illegal_function, line_event::exception},
        {errc::server_device_busy, line_event::exception},
        {errc::unlisted_exception, line_event::exception},
        {errc::frame_too_short, line_event::length},
        {errc::frame_too_long, line_event::length},
        {errc::wrong_length, line_event::length},
        {errc::crc_mismatch, line_event::crc},
        {errc::uart_error, line_event::crc},
        {errc::wrong_unit, line_event::foreign},
        {errc::wrong_function, line_event::mismatch},
        {errc::response_mismatch, line_event::mismatch},
        {errc::malformed, line_event::mismatch},
        {errc::line_echo, line_event::mismatch},
        {errc::collision, line_event::mismatch},
    };
    for (auto const& each : test::all_errors) {
        bool is_listed = each.category != error_category::reception;
        for (auto const& entry : all) {
            is_listed = is_listed or entry.found == each.error;
        }
        if (not is_listed) {
            return false;
        }
    }
    for (auto const& [found, counted] : all) {
        if (event_of(found) != counted) {
            return false;
        }
    }
    return true;
}
PROOF("each error of a frame counts as one kind", sorts_by_kind)

constexpr bool counts_good_and_bad()
{
    counting_end unit{impatient};
    unit.ask(read_eta);
    unit.pass(milliseconds(7));
    unit.say(response_1234);
    bool ok = unit.has(0x1234);
    unit.pass(milliseconds(5));
    unit.ask(read_eta);
    unit.say("00"_hex);
    unit.say("02 03 02 12 34 F1 33"_hex);
    unit.say("01 83 02 C0 F1"_hex);
    ok = ok and unit.fault() == errc::illegal_data_address;
    unit.pass(milliseconds(5));
    unit.ask(read_eta);
    unit.say("01 03 02 12 34 B4 33"_hex);
    unit.run(milliseconds(10));
    ok = ok and unit.fault() == errc::crc_mismatch;
    unit.pass(milliseconds(5));
    unit.ask(read_eta);
    unit.run(milliseconds(100));
    ok = ok and unit.fault() == errc::timed_out;
    unit.say(response_1234); // too late
    auto const& line = unit.link.statistics().line();
    using test::is;
    return is(ok, "each request ends as it should") and is(of_unit(unit, line_event::request) == 4, "four requests") and
           is(of_unit(unit, line_event::reply) == 1, "one reply") and
           is(of_unit(unit, line_event::exception) == 1, "one exception") and
           is(unit.link.statistics().unit(1)->by_exception[2] == 1, "it is exception 02") and
           is(of_unit(unit, line_event::crc) == 1, "one wrong CRC") and
           is(of_unit(unit, line_event::late) == 1, "one late response") and
           is(of_unit(unit, line_event::timeout) == 1, "one time-out") and
           is(of_unit(unit, line_event::foreign) == 1, "one frame of another unit") and
           is(of_unit(unit, line_event::noise) == 1, "one noise") and
           is(line[line_event::request] == 4, "four requests on the line") and
           is(line.worst_latency == milliseconds(7) + test::line.characters(response_1234.size()), "the worst latency");
}
PROOF("good, bad, late and missing responses are counted, each as what it was", counts_good_and_bad)

constexpr bool answers_before_the_reckoned_end()
{
    counting_end unit{impatient};
    bool const asked =
        unit.link.start(request_frame{read_eta}, unit.now).has_value() and not unit.link.poll_transmit().empty();
    unit.link.sent(unit.now + test::line.characters(read_eta.size()));
    unit.link.receive(response_1234, unit.now + microseconds(100));
    auto const& line = unit.link.statistics().line();
    return asked and unit.has(0x1234) and line[line_event::reply] == 1 and line.worst_latency == duration{};
}
PROOF("a response before the reckoned end of its request is one, and took no time", answers_before_the_reckoned_end)

constexpr auto damaged = "01 03 02 12 34 B4 33"_hex;

constexpr bool counts_what_follows_an_response()
{
    counting_end unit{impatient};
    unit.ask(read_eta);
    unit.say("01 03 02 12 34 B5 33 01 01"_hex);
    auto const& line = unit.link.statistics().line();
    return unit.has(0x1234) and line[line_event::noise] == 2 and line[line_event::late] == 0;
}
PROOF("bytes behind a response, in one lump with it, are noise", counts_what_follows_an_response)

/// Says something damaged and, after a silence that nobody was told of, what follows.
constexpr errc damaged_then(counting_end& unit, bool is_cancelled, byte_view rest)
{
    unit.ask(read_eta);
    unit.link.receive(damaged, unit.now);
    if (is_cancelled) {
        unit.link.cancel(unit.now);
    }
    unit.now = unit.now + milliseconds(20);
    unit.link.receive(rest, unit.now);
    return unit.fault();
}

constexpr bool judges_before_a_lump()
{
    counting_end waiting{impatient};
    counting_end gone{impatient};
    auto const crc_of = [](counting_end const& unit) { return unit.link.statistics().line()[line_event::crc]; };
    return damaged_then(waiting, false, response_1234) == errc::crc_mismatch and crc_of(waiting) == 1 and
           damaged_then(gone, true, response_1234) == errc::cancelled and crc_of(gone) == 0;
}
PROOF("what a silence ended is judged before the lump behind it, where a response is awaited", judges_before_a_lump)

constexpr bool counts_noise_of_no_unit()
{
    counting_end unit{impatient};
    unit.say("01"_hex); // the line is not silent from here on
    unit.say("01 01"_hex);
    auto const& line = unit.link.statistics().line();
    return line[line_event::noise] == 3 and line[line_event::late] == 0;
}
PROOF("what looks like a unit's and is owed by none is noise", counts_noise_of_no_unit)

constexpr bool has_room_for_two()
{
    unit_statistics<2> counts;
    counts.on_event(line_event::request, 3);
    counts.on_event(line_event::request, 7);
    counts.on_event(line_event::request, 9);
    for (int const code : {0x7F, 12, 11}) {
        counts.on_response(line_event::exception, static_cast<errc>(code), 7, instant{0});
    }
    bool const full = counts.unit(9) == nullptr and counts.line()[line_event::request] == 3;
    bool const other =
        counts.unit(7)->by_exception[0] == 2 and counts.unit(7)->by_exception[11] == 1 and counts.unit(4) == nullptr;
    counts.reset();
    return full and other and counts.unit(3) == nullptr and counts.line()[line_event::request] == 0;
}
PROOF("a unit beyond the table is counted for the line", has_room_for_two)

constexpr bool stops_at_the_end()
{
    counters counts;
    counts.by_event[0] = 0xFFFF'FFFE;
    counts.note(line_event::request);
    counts.note(line_event::request);
    return counts[line_event::request] == 0xFFFF'FFFF;
}
PROOF("a counter stays at its highest value", stops_at_the_end)

constexpr bool times_answers_and_refusals_only()
{
    counting_end unit{{.response_timeout = milliseconds(50), .retries = 0}};
    unit.ask(read_eta);
    unit.pass(milliseconds(30));
    unit.say("02 03 02 12 34 F1 33"_hex); // another unit's
    unit.say("01 04 02 12 34 B4 47"_hex); // another function's
    auto const& line = unit.link.statistics().line();
    bool const untimed =
        line[line_event::foreign] == 1 and line[line_event::mismatch] == 1 and line.worst_latency == duration{};
    unit.run(milliseconds(400));
    static_cast<void>(unit.fault());
    unit.ask(read_eta);
    unit.pass(milliseconds(9));
    unit.say("01 83 02 C0 F1"_hex);
    duration const refused = milliseconds(9) + test::line.characters(5);
    return untimed and line[line_event::exception] == 1 and line.worst_latency == refused and
           unit.link.statistics().unit(1)->worst_latency == refused;
}
PROOF("a response and a refusal have a latency, and no other frame", times_answers_and_refusals_only)

/// How many late responses are counted of a unit that says so after its time, in two parts. By value: Clang 14 cannot
/// print a view in a call of a function that it does not compute.
template <std::size_t Size>
constexpr std::uint32_t late_of(std::uint8_t number, std::array<std::byte, 3> begin, std::array<std::byte, Size> rest)
{
    counting_end unit{impatient};
    std::array<std::byte, 8> place{};
    unit.ask(*encode_into(place, *unit_id::checked(number), read_holding_registers{3201, 1}));
    unit.run(milliseconds(100));
    static_cast<void>(unit.fault());
    unit.say(begin);
    unit.say(rest);
    counters const& own = *unit.link.statistics().unit(number);
    bool const agrees = unit.link.statistics().line()[line_event::late] == own[line_event::late] and
                        unit.link.statistics().line()[line_event::noise] == 0;
    return agrees ? own[line_event::late] : 99;
}
constexpr bool counts_a_late_response_once()
{
    // The second part begins with the unit's address by chance.
    return late_of(1, "01 03 02"_hex, "01 34 B5 33"_hex) == 1 and
           late_of(246, "F6 03 02"_hex, "F6 34 B5 33"_hex) == 1 and
           late_of(247, "F7 03 02"_hex, "F7 34 B5 33"_hex) == 1;
}
PROOF("a late response of any unit is counted once, in however many parts it comes", counts_a_late_response_once)

constexpr auto is_busy = "01 83 06 C1 32"_hex;

constexpr bool counts_repetitions()
{
    counting_end unit{{.response_timeout = milliseconds(50), .retries = 2}};
    unit.ask(read_eta);
    unit.say(is_busy);
    unit.run(milliseconds(60));  // a pause, and once more
    unit.run(milliseconds(100)); // silence, and once more
    return unit.transmissions == 3 and of_unit(unit, line_event::request) == 1 and
           of_unit(unit, line_event::repetition) == 2;
}
PROOF("a request that leaves again after a pause and after silence is one request", counts_repetitions)

// Nothing is counted: nothing is held. Padding may differ.
static_assert(sizeof(client) + sizeof(line_statistics) <=
              sizeof(basic_client<observed_by<line_statistics>>) + alignof(client));
static_assert(sizeof(client) + sizeof(line_statistics) + alignof(client) >=
              sizeof(basic_client<observed_by<line_statistics>>));

} // namespace
