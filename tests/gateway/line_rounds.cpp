// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// The rounds of a line, in simulated time: periods, silent devices, others in their place, lost ports, settings, a day.
#include "../../tools/gateway/line_rounds.hpp"

#include <algorithm>
#include <filesystem>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include <malloc.h>

#include "support/catch.hpp"

#include "gateway/timed_line.hpp"

using namespace gateway_test;

namespace {

constexpr std::size_t power = 0, energy = 1, level = 2, limit = 3;

std::uint64_t seconds_after(std::uint64_t time, std::uint64_t since) { return (time - since) / 1'000'000; }

} // namespace

TEST_CASE("each value is read in its own period, with the time and the number of its round")
{
    rounds_on_line on{2};
    on.line.units[0].held = 7;
    on.run_for(90s);
    // 10 ms after its due time at the latest, so that the last round of a period is in.
    CHECK(on.line.units[1].reads == 90);
    CHECK(on.line.units[0].reads == 90 + 2);

    device_slot::content const now = on.board.device(0);
    CHECK(now->is_available);
    CHECK(now->values[power].state == value_state::valid);
    CHECK(std::get<std::int64_t>(now->values[power].value) == 7);
    CHECK(now->seq == on.line.units[0].reads);
    CHECK(now->values[power].seq > now->values[energy].seq);
    CHECK(seconds_after(now->values[power].time, first_second) == 89);
    CHECK(seconds_after(now->values[energy].time, first_second) == 60);

    on.run_for(1s);
    CHECK(on.board.device(0)->seq == now->seq + 1); // the newest overwrites
    CHECK(on.board.device(0)->values[energy].seq == now->values[energy].seq);
}

TEST_CASE("a value is no older than its time, however long its reading and what follows it take")
{
    rounds_on_line on{2};
    on.line.response = 300ms;
    on.line.units[0].loses_one = true; // so that it says who it is, behind its values
    on.have_the_first_say_who_it_is();
    on.run_for(5s);
    for (std::size_t const each : {0U, 1U}) {
        std::uint64_t const time = on.board.device(each)->values[power].time;
        CHECK(time <= on.line.units[each].read_at);
        CHECK(seconds_after(on.line.units[each].read_at, time) < 2);
        CHECK(on.board.device(each)->time == time);
    }
}

TEST_CASE("a device that may owe an answer is not read, also right behind its identification, and its turn is kept")
{
    rounds_on_line on{2};
    on.line.units[1].owes = true;
    on.run_for(3s);
    CHECK(on.line.units[1].identified == 1);
    CHECK(on.line.units[1].reads == 0);
    CHECK(on.line.units[1].kept > 0);
    CHECK(on.line.units[0].reads > 2);
    CHECK(on.line.units[0].kept == 0);
    on.line.units[1].owes = false;
    on.run_for(1s);
    CHECK(on.line.units[1].reads > 0);
    CHECK(on.board.device(1)->is_available);
    on.line.units[1].owes = true;
    on.run_for(3s);
    on.line.units[1].owes = false;
    on.run_for(1s);
    CHECK(on.count(event_kind::note) == 0); // its periods are not to blame
}

TEST_CASE("a value that is none is marked, and none stands there")
{
    rounds_on_line on{1};
    on.line.units[0].is_invalid = true;
    on.run_for(2s);
    slot_value const value = on.board.device(0)->values[power];
    CHECK(value.state == value_state::invalid);
    CHECK(std::holds_alternative<std::monostate>(value.value));
    CHECK(value.why == "no value");
    CHECK(on.board.device(0)->is_available);
}

TEST_CASE("a heartbeat comes from the loop of the line")
{
    rounds_on_line on{1};
    on.run_for(10s);
    line_state const before = on.board.state();
    CHECK(before.is_up);
    CHECK(before.opened == 1);
    CHECK(before.requests == on.line.counts().asked);
    CHECK(seconds_after(before.time, first_second) >= 9);
    line_state const frozen = on.board.state(); // nobody made a step
    CHECK(frozen.time == before.time);
    CHECK(frozen.seq == before.seq);
    on.run_for(1s);
    CHECK(on.board.state().time >= before.time + 900'000);
    CHECK(on.board.state().seq > before.seq);
}

TEST_CASE("silent devices cost the others nothing beyond their turns")
{
    for (std::size_t const silent : {std::size_t{1}, std::size_t{15}, std::size_t{29}}) {
        rounds_on_line on{30};
        for (std::size_t i = 0; i < silent; ++i) {
            on.line.units[29 - i].is_there = false;
        }
        on.run_for(60s); // they are known as silent
        std::vector<unsigned> before;
        for (timed_line::unit const& each : on.line.units) {
            before.push_back(each.reads);
        }
        unsigned long const silences = on.line.counts().silent;
        std::uint64_t const overruns = on.board.state().overruns;
        on.run_for(600s);
        CAPTURE(silent);
        // The line is busy for 0.3 s of a second at most: all who are there are read each second.
        for (std::size_t i = 0; i < 30 - silent; ++i) {
            CHECK(on.line.units[i].reads - before[i] >= 599);
        }
        // A tenth of 600 s is 300 time-outs of 0.2 s.
        CHECK(on.line.counts().silent - silences <= 301);
        CHECK(on.line.counts().silent - silences >= 60);
        CHECK(on.board.state().overruns == overruns);
        for (std::size_t i = 30 - silent; i < 30; ++i) { // and none of them is forgotten
            CHECK(on.line.units[i].identified > 5);
        }
    }
}

TEST_CASE("the values of a silent device are marked and stay so, and it is identified before they count again")
{
    rounds_on_line on{2};
    on.run_for(5s);
    unsigned const identified = on.line.units[0].identified;
    CHECK(identified == 1);
    static_cast<void>(on.board.take_events());
    on.line.units[0].is_there = false;
    on.run_for(5s);
    device_slot::content const lost = on.board.device(0);
    CHECK_FALSE(lost->is_available);
    CHECK(lost->why == "no response in time");
    for (slot_value const& each : lost->values) {
        CHECK(each.state == value_state::not_read);
        CHECK(std::holds_alternative<std::monostate>(each.value));
    }
    on.run_for(600s);
    CHECK(on.board.device(0)->seq == lost->seq); // nothing is repeated
    CHECK(on.count(event_kind::device_silent) == 1);

    on.line.units[0].is_there = true;
    on.run_for(10s);
    CHECK(on.board.device(0)->is_available);
    CHECK(on.board.device(0)->values[power].state == value_state::valid);
    CHECK(on.line.units[0].identified > identified);
    CHECK(on.count(event_kind::device_back) == 1);
}

TEST_CASE("one missed response where no request is repeated marks a value, and loses nobody")
{
    line_plan unrepeated = plan_of(1);
    unrepeated.choices.retries = 0;
    rounds_on_line on{unrepeated};
    on.run_for(5s);
    static_cast<void>(on.board.take_events());
    unsigned const identified = on.line.units[0].identified;
    unsigned long const silences = on.line.counts().silent;
    on.line.units[0].is_there = false;
    while (on.line.counts().silent == silences) {
        on.rounds.step();
    }
    on.line.units[0].is_there = true;
    CHECK(on.board.device(0)->is_available);
    CHECK(on.board.device(0)->values[power].state == value_state::failed);
    on.run_for(3s);
    CHECK(on.board.device(0)->values[power].state == value_state::valid);
    CHECK(on.line.units[0].identified == identified);
    CHECK(on.board.take_events().empty());
}

TEST_CASE("another device in its place is marked, and nothing of it is published")
{
    rounds_on_line on{2};
    on.line.units[0].held = 42;
    on.line.units[0].is_other = true;
    on.run_for(300s);
    CHECK(on.line.units[0].reads == 0);
    CHECK(on.line.units[0].identified == 5);
    CHECK_FALSE(on.board.device(0)->is_available);
    CHECK(on.board.device(0)->why == "another device");
    CHECK(on.count(event_kind::wrong_device) == 1);
    CHECK(on.line.units[1].reads >= 299);

    on.line.units[0].is_other = false;
    on.run_for(62s);
    CHECK(on.board.device(0)->values[power].state == value_state::valid);

    // Exchanged while it was away.
    on.line.units[0].is_there = false;
    on.run_for(5s);
    on.line.units[0].is_there = true;
    on.line.units[0].is_other = true;
    unsigned const reads = on.line.units[0].reads;
    on.run_for(60s);
    CHECK(on.line.units[0].reads == reads);
    CHECK(on.board.device(0)->why == "another device");
}

TEST_CASE("another device in the place of one that says who it is, is found behind a pause and behind a lost response")
{
    for (bool const is_missed : {false, true}) {
        CAPTURE(is_missed);
        rounds_on_line on{2};
        on.have_the_first_say_who_it_is();
        on.run_for(5s);
        REQUIRE(on.board.device(0)->is_available);
        REQUIRE(on.line.units[0].identified == 1);
        if (is_missed) {
            on.line.units[0].is_there = false;
            for (unsigned const reads = on.line.units[0].reads; on.line.units[0].reads == reads;) {
                on.rounds.step();
            }
            on.line.units[0].is_there = true;
        } else {
            on.line.pass(4s); // nobody asks anything
        }
        on.line.units[0].is_other = true;
        on.run_for(3s);
        CHECK_FALSE(on.board.device(0)->is_available);
        CHECK(on.board.device(0)->values[power].state == value_state::not_read);
        CHECK(on.count(event_kind::wrong_device) == 1);
        CHECK(on.board.device(1)->is_available);
    }
}

TEST_CASE("what answers a repetition says who it is before its values count")
{
    rounds_on_line on{1};
    on.have_the_first_say_who_it_is();
    on.run_for(5s);
    REQUIRE(on.line.units[0].identified == 1);
    on.line.units[0].loses_one = true;
    on.line.units[0].held = 222;
    SECTION("the same one")
    {
        on.run_for(2s);
        CHECK(on.line.units[0].identified > 1);
        CHECK(on.board.device(0)->values[power].value == slot_value{.value = std::int64_t{222}}.value);
    }
    SECTION("another one")
    {
        on.line.units[0].is_other = true;
        on.run_for(2s);
        CHECK_FALSE(on.board.device(0)->is_available);
        CHECK(on.board.device(0)->values[power].state == value_state::not_read);
    }
}

TEST_CASE("a device whose identification takes turns leaves the others theirs")
{
    rounds_on_line on{3};
    timed_line::unit& slow = on.line.units[0];
    slow.looks = 8;
    slow.takes = 1s;
    time_point const began = on.line.now();
    time_point last_read = began;
    asked_line::clock::duration longest{};
    for (unsigned reads = 0; slow.reads == 0;) {
        on.rounds.step();
        REQUIRE(on.line.now() - began < 20s);
        if (std::exchange(reads, on.line.units[1].reads) != on.line.units[1].reads) {
            longest = std::max(longest, on.line.now() - last_read);
            last_read = on.line.now();
        }
    }
    CHECK(slow.identified == 8);
    CHECK(longest < 2100ms); // its period, and one turn
    CHECK(on.line.units[2].reads + 1 >= on.line.units[1].reads);
    CHECK(on.count(event_kind::note) == 0);
}

TEST_CASE("a device whose responses do not come at once has one turn, whatever of it is due")
{
    rounds_on_line on{2};
    on.line.units[0].loses_one = true;
    while (on.line.units[1].reads == 0) {
        on.rounds.step();
    }
    CHECK(on.line.units[0].reads == 1); // of two groups
    on.run_for(1s);
    CHECK(on.board.device(0)->values[energy].state == value_state::valid);
}

TEST_CASE("what a slow device said counts once it has said who it is, in turns with others")
{
    rounds_on_line on{2};
    on.have_the_first_say_who_it_is();
    on.run_for(5s);
    timed_line::unit& slow = on.line.units[0];
    slow.looks = 3;
    slow.takes = 600ms;
    slow.loses_one = slow.is_late = true;
    slow.held = 222;
    unsigned const reads = slow.reads, identified = slow.identified, others = on.line.units[1].reads;
    auto const value = [&] { return on.board.device(0)->values[power]; };
    while (slow.identified < identified + 2) {
        on.rounds.step();
    }
    CHECK(slow.reads == reads + 1);
    CHECK(on.line.units[1].reads >= others + 2);
    CHECK_FALSE(value().value == cell{std::int64_t{222}});
    SECTION("the same one")
    {
        std::uint64_t const read_at = slow.read_at;
        while (slow.identified < identified + 3) {
            on.rounds.step();
        }
        CHECK(slow.reads == reads + 1);
        CHECK(value().value == cell{std::int64_t{222}});
        CHECK(value().time == read_at);
    }
    SECTION("unless it is set meanwhile")
    {
        slow.sets = 3;
        on.submit(limit, "333", 30s);
        while (slow.written == 0) {
            on.rounds.step();
            CHECK_FALSE(value().value == cell{std::int64_t{222}});
        }
        CHECK(on.answer().result == setting_result::done);
        std::uint64_t const done_at = on.line.unix_time();
        while (on.line.unix_time() < done_at + 10'000'000) {
            on.rounds.step();
            CHECK_FALSE(value().value == cell{std::int64_t{222}});
        }
        CHECK(value().value == cell{std::int64_t{333}});
        CHECK(value().time >= done_at - 1'000'000);
    }
    SECTION("and before each further setting")
    {
        slow.sets = 3;
        for (unsigned i = 0; i < 40; ++i) { // one behind the other
            on.submit(limit, std::to_string(400 + i), 30s);
            unsigned const written = slow.written;
            std::uint64_t const seq = on.board.device(0)->seq;
            while (slow.written == written) {
                on.rounds.step();
            }
            CHECK((i == 0 or on.board.device(0)->seq > seq));
        }
    }
    SECTION("another one")
    {
        slow.is_other = true;
        on.run_for(5s);
        CHECK(value().state == value_state::not_read);
        CHECK(on.count(event_kind::wrong_device) == 1);
        CHECK(slow.reads == reads + 1);
    }
    SECTION("one that went")
    {
        slow.is_there = false;
        on.run_for(5s);
        CHECK(value().state == value_state::not_read);
        CHECK(on.count(event_kind::device_silent) == 1);
    }
    SECTION("one whose port went, and is back with another value")
    {
        on.line.is_gone = true;
        on.run_for(1s);
        on.line.is_gone = false;
        slow.held = 333;
        slow.takes = 0ms;
        on.run_for(10s);
        CHECK(value().value == cell{std::int64_t{333}});
    }
}

TEST_CASE("a setting of a device whose responses do not come at once is written in turns with others")
{
    rounds_on_line on{3};
    on.run_for(5s);
    timed_line::unit& slow = on.line.units[0];
    slow.takes = 1s;
    slow.sets = 8;
    on.submit(limit, "21", 30s, "first");
    on.submit(level, "3", 30s, "second");
    unsigned const own = slow.reads;
    auto const longest_while = [&](auto const& goes_on) {
        time_point last_read = on.line.now();
        asked_line::clock::duration longest{};
        for (unsigned reads = on.line.units[1].reads; goes_on();) {
            on.rounds.step();
            REQUIRE(on.line.now() - last_read < 20s);
            if (std::exchange(reads, on.line.units[1].reads) != on.line.units[1].reads) {
                longest = std::max(longest, on.line.now() - last_read);
                last_read = on.line.now();
            }
        }
        return longest;
    };
    CHECK(longest_while([&] { return slow.written == 0; }) < 2100ms); // its period, and one turn
    CHECK(slow.set == 8);
    CHECK(slow.reads <= own + 1); // none between its turns
    setting_answer const answer = on.answer();
    CHECK(answer.result == setting_result::done);
    CHECK(answer.id == "first");
    CHECK(longest_while([&] { return slow.written == 1; }) < 2100ms);
    CHECK(slow.reads > own); // before the second
    CHECK(on.answer().id == "second");
    CHECK(on.board.device(0)->is_available);
    CHECK(on.count(event_kind::note) == 0);
}

TEST_CASE("a setting that waits behind another of its device is told to have expired when it has")
{
    rounds_on_line on{2};
    on.run_for(5s);
    timed_line::unit& slow = on.line.units[0];
    slow.takes = 1s;
    slow.sets = 20;
    on.submit(limit, "21", 60s, "first");
    on.submit(level, "3", 5s, "second");
    on.run_for(9s);
    CHECK(slow.set > 1);
    CHECK(slow.written == 0);
    setting_answer const second = on.answer();
    CHECK(second.id == "second");
    CHECK(second.result == setting_result::expired);
    CHECK(second.why == "it expired before its turn");
    CHECK(seconds_after(second.time, first_second) <= 12);
    on.run_for(50s);
    CHECK(on.answer().id == "first");
}

TEST_CASE("a setting whose device owes an answer waits for that, and keeps the turn")
{
    rounds_on_line on{2};
    on.run_for(5s);
    timed_line::unit& owing = on.line.units[0];
    owing.owes = true;
    owing.kept = 0;
    on.submit(limit, "21", 3s);
    unsigned const others = on.line.units[1].reads;
    on.run_for(2s);
    CHECK(owing.written == 0);
    CHECK(owing.kept > 0);
    CHECK(on.line.units[1].reads >= others + 2);
    SECTION("until it has come")
    {
        owing.owes = false;
        on.run_for(100ms);
        CHECK(on.answer().result == setting_result::done);
        CHECK(owing.written == 1);
    }
    SECTION("until it expires")
    {
        on.run_for(1100ms);
        CHECK(on.answer().result == setting_result::expired);
        owing.owes = false;
        on.run_for(5s);
        CHECK(owing.written == 0);
    }
}

TEST_CASE("what ends a setting between two of its turns is its one answer, and the next one begins anew")
{
    rounds_on_line on{2};
    on.run_for(5s);
    timed_line::unit& slow = on.line.units[0];
    slow.takes = 300ms;
    slow.sets = 4;
    on.submit(limit, "21", 3s, "first");
    while (slow.set < 2) {
        on.rounds.step();
    }
    CHECK(on.board.take_answers().empty());
    SECTION("it expires")
    {
        on.line.pass(3s);
        on.rounds.step();
        CHECK(on.answer().result == setting_result::expired);
    }
    SECTION("a newer one")
    {
        on.submit(limit, "22", 10s, "second");
        on.rounds.step();
        setting_answer const first = on.answer();
        CHECK(first.id == "first");
        CHECK(first.why == "a newer one took its place");
        on.run_for(10s);
        CHECK(on.answer().id == "second");
        CHECK(slow.written == 1);
        CHECK(slow.held == 22);
        slow.written = 0;
    }
    SECTION("its port goes")
    {
        on.line.is_gone = true;
        on.run_for(1s);
        CHECK(on.answer().result == setting_result::failed);
        on.line.is_gone = false;
    }
    SECTION("its line ends")
    {
        on.rounds.end();
        CHECK(on.answer().why == "the line ended before its turn");
    }
    on.run_for(10s);
    CHECK(slow.written == 0);
    CHECK(on.board.take_answers().empty());
    on.submit(limit, "23", 10s, "third");
    on.run_for(5s);
    CHECK(on.answer().result == setting_result::done);
    CHECK(slow.set == 4);
    CHECK(slow.written == 1);
}

TEST_CASE("a setting whose turn does not come before the end is answered")
{
    rounds_on_line on{1};
    on.run_for(5s);
    on.submit(limit, "5");
    on.rounds.end();
    setting_answer const found = on.answer();
    CHECK(found.result == setting_result::refused);
    CHECK(found.why == "the line ended before its turn");
    CHECK(on.line.units[0].written == 0);
}

TEST_CASE("what a line listens to before its first request leaves out no round")
{
    rounds_on_line on{1};
    on.line.listening = 1'500ms;
    on.run_for(5s);
    on.line.is_gone = true;
    on.run_for(5s);
    on.line.is_gone = false;
    on.run_for(10s);
    CHECK(on.board.state().opened == 2);
    CHECK(on.board.state().overruns == 0);
    CHECK(on.board.device(0)->values[power].state == value_state::valid);
}

TEST_CASE("a lost port is opened again with growing pauses, and all is marked meanwhile")
{
    rounds_on_line on{2};
    on.run_for(5s);
    CHECK(on.count(event_kind::port_opened) == 1);
    on.line.is_gone = true;
    on.run_for(100s);
    CHECK_FALSE(on.board.state().is_up);
    CHECK(on.board.state().why == "the port is gone");
    CHECK(on.line.opens >= 48);
    CHECK(on.line.opens <= 60); // of 2 s in the end
    for (std::size_t const each : {0U, 1U}) {
        CHECK_FALSE(on.board.device(each)->is_available);
        CHECK(on.board.device(each)->values[0].state == value_state::not_read);
    }
    CHECK(on.count(event_kind::port_lost) == 1);
    std::uint64_t const time = on.board.state().time;
    on.line.is_gone = false;
    on.run_for(10s);
    CHECK(on.board.state().time > time);
    CHECK(on.board.state().is_up);
    CHECK(on.board.state().opened == 2);
    CHECK(on.count(event_kind::port_opened) == 1);
    CHECK(on.board.device(0)->values[power].state == value_state::valid);
    CHECK(on.line.units[0].identified == 2);
}

TEST_CASE(
    "a port that hangs up on each request, as a server of another protocol does, is told once, and each new reason")
{
    rounds_on_line on{2};
    on.line.hangs_up = "closed by the other end";
    on.run_for(600s);
    unsigned lost = 0;
    unsigned opened = 0;
    for (line_event const& each : on.board.take_events()) {
        lost += each.what == event_kind::port_lost ? 1U : 0U;
        opened += each.what == event_kind::port_opened ? 1U : 0U;
    }
    CHECK(lost == 1);
    CHECK(opened == 1);
    CHECK(on.board.state().opened >= 280); // counted, with pauses of 2 s in the end
    CHECK(on.board.state().opened <= 320);
    for (unsigned i = 0; i < 20; ++i) {
        on.line.hangs_up = i % 2 == 0 ? "reset" : "closed by the other end";
        on.run_for(5s);
    }
    CHECK(on.count(event_kind::port_lost) == 1);
    on.line.hangs_up.clear();
    on.run_for(10s);
    CHECK(on.board.device(0)->is_available);
    CHECK(on.count(event_kind::port_opened) == 1);

    // Nobody responds: it is open all the same.
    for (timed_line::unit& each : on.line.units) {
        each.is_there = false;
    }
    on.line.is_gone = true;
    on.run_for(5s);
    on.line.is_gone = false;
    on.run_for(10s);
    CHECK(on.count(event_kind::port_opened) == 1);
}

TEST_CASE("a port that was never there is told, and opened when it comes")
{
    rounds_on_line on{1};
    on.line.is_gone = true;
    on.run_for(60s);
    CHECK_FALSE(on.board.state().is_up);
    CHECK(on.board.device(0)->why == "the port is gone");
    CHECK(on.count(event_kind::port_lost) == 1);
    on.line.is_gone = false;
    on.run_for(10s);
    CHECK(on.board.device(0)->is_available);
}

TEST_CASE("more than the line carries is left out, told once, and everybody has a share")
{
    rounds_on_line on{20};
    on.line.response = 100ms; // 20 of them are 2 s, of a period of 1 s
    on.run_for(600s);
    CHECK(on.board.state().overruns > 5'000);
    CHECK(on.count(event_kind::note) == 1);
    auto const reads = [](timed_line::unit const& each) { return each.reads; };
    unsigned const least = reads(*std::ranges::min_element(on.line.units, {}, reads));
    unsigned const most = reads(*std::ranges::max_element(on.line.units, {}, reads));
    CHECK(least > 250);
    CHECK(most < least + 30); // the first has a value of a minute besides
}

TEST_CASE("what the first look at all devices takes is no round that was left out")
{
    rounds_on_line on{30};
    on.line.response = 20ms; // a look at all of them takes 1.2 s
    on.line.units[3].is_there = false;
    on.run_for(60s);
    CHECK(on.board.state().overruns == 0);
    CHECK(on.count(event_kind::note) == 0);
}

TEST_CASE("what a silent device takes of the line is no reason for longer periods")
{
    rounds_on_line on{3};
    on.run_for(10s);
    on.line.timeout = 1500ms;
    on.line.units[1].is_there = false;
    on.run_for(60s);
    CHECK(on.board.state().overruns > 0);
    CHECK(on.count(event_kind::note) == 0);
    on.line.units[1].is_there = true;
    on.run_for(10s);
    on.line.response = 400ms; // of three is more than a second
    on.run_for(10s);
    CHECK(on.count(event_kind::note) == 1);
}

TEST_CASE("a device that was away has no round left out once it is back, whatever the moment")
{
    for (unsigned i = 0; i < 40; ++i) {
        CAPTURE(i);
        rounds_on_line on{2};
        on.run_for(10s + i * 50ms);
        on.line.units[1].is_there = false;
        on.run_for(12s);
        std::uint64_t const before = on.board.state().overruns;
        on.line.units[1].is_there = true;
        on.run_for(30s);
        CHECK(on.board.device(1)->is_available);
        CHECK(on.board.state().overruns == before);
        CHECK(on.count(event_kind::note) == 0);
    }
}

TEST_CASE("that nobody knows who a device is is told once, and it is read all the same")
{
    rounds_on_line on{2};
    on.line.units[1].is_unsure = true;
    on.run_for(5s);
    CHECK(on.count(event_kind::note) == 1);
    on.line.units[1].is_there = false;
    on.run_for(10s);
    on.line.units[1].is_there = true;
    on.run_for(10s);
    CHECK(on.board.device(1)->is_available);
    CHECK(on.count(event_kind::note) == 0);
}

TEST_CASE("that a device answers too late is told once, where it does so again and again")
{
    rounds_on_line on{2};
    on.run_for(5s);
    for (unsigned i = 0; i < 5; ++i) { // now and then
        on.line.units[1].is_late = true;
        on.run_for(1500ms);
        on.line.units[1].is_late = false;
        on.run_for(3s);
    }
    CHECK(on.count(event_kind::note) == 0);
    on.line.units[1].is_late = true;
    on.run_for(60s);
    CHECK(on.count(event_kind::note) == 1);
}

TEST_CASE("a setting is written once, answered, and read soon")
{
    rounds_on_line on{1};
    on.run_for(5s);
    on.submit(limit, "21", 10s, "first");
    on.run_for(100ms);
    setting_answer const answer = on.answer();
    CHECK(answer.result == setting_result::done);
    CHECK(answer.id == "first");
    CHECK(answer.device == 0);
    CHECK(answer.value == limit);
    CHECK(on.line.units[0].written == 1);
    CHECK(std::get<std::int64_t>(on.board.device(0)->values[limit].value) == 21);
    on.run_for(600s);
    CHECK(on.line.units[0].written == 1);
    CHECK(on.board.take_answers().empty());
}

TEST_CASE("what may not be written is answered and never leaves")
{
    rounds_on_line on{1};
    on.run_for(5s);
    on.submit(power, "1");
    CHECK(on.answer().why == "it is none of the settings that the file names");
    on.board.submit({5, 0, "1", on.line.unix_time() + 1'000'000}, on.line.unix_time(), on.line.now());
    CHECK(on.answer().result == setting_result::refused);
    on.submit(limit, "1", 0s);
    CHECK(on.answer().result == setting_result::expired);
    on.submit(limit, "1", 60s + 1us);
    CHECK(on.answer().why == "it expires more than 60 s ahead");
    on.submit(limit, "1", 60s);
    CHECK(on.board.take_answers().empty()); // it waits
    on.run_for(1s);
    CHECK(on.answer().result == setting_result::done);
    CHECK(on.line.units[0].written == 1);

    rounds_on_line reading{1, false};
    reading.run_for(5s);
    reading.submit(limit, "1");
    CHECK(reading.answer().why == "this gateway only reads: it runs without --write");
    reading.run_for(5s);
    CHECK(reading.line.units[0].written == 0);
}

TEST_CASE("a newer value of a register takes the place of one that waits")
{
    rounds_on_line on{1};
    on.run_for(5s);
    on.submit(limit, "1", 10s, "a");
    on.submit(limit, "2", 10s, "b");
    CHECK(on.answer().id == "a");
    on.submit(level, "3", 10s, "c");
    on.run_for(1s);
    std::vector<setting_answer> const both = on.board.take_answers();
    REQUIRE(both.size() == 2);
    CHECK(both[0].id == "b");
    CHECK(both[1].id == "c");
    CHECK(on.line.units[0].written == 2);
}

TEST_CASE("a newer value of a register takes the place of one that is judged, until it is written")
{
    rounds_on_line on{1};
    on.run_for(5s);
    on.board.take_events();
    bool is_first = true;
    on.line.while_judged = [&] {
        if (not std::exchange(is_first, false)) {
            return;
        }
        on.submit(level, "2", 10s, "b");
        on.submit(limit, "3", 10s, "c"); // another register of the same device
        on.submit(level, "4", 10s, "d");
    };
    on.submit(level, "1", 10s, "a"); // a stored one: were it written, the newest one might not be for a minute
    on.run_for(2s);
    std::vector<std::pair<std::string, setting_result>> found;
    for (setting_answer const& each : on.board.take_answers()) {
        found.emplace_back(each.id, each.result);
        CHECK((each.result == setting_result::done or each.why == "a newer one took its place"));
    }
    std::vector<std::pair<std::string, setting_result>> const wanted{{"b", setting_result::refused},
                                                                     {"a", setting_result::refused},
                                                                     {"c", setting_result::done},
                                                                     {"d", setting_result::done}};
    CHECK(found == wanted);
    CHECK(on.line.units[0].written == 2);
    CHECK(on.count(event_kind::setting) == 4);
}

TEST_CASE("each of many settings has one answer, and is told once, whatever becomes of its device")
{
    rounds_on_line on{2};
    on.run_for(5s);
    on.line.before_write = 300ms;
    std::map<std::string, unsigned> answers;
    unsigned sent = 0;
    unsigned told = 0;
    auto const take = [&] {
        for (setting_answer const& each : on.board.take_answers()) {
            ++answers[each.id];
        }
        told += on.count(event_kind::setting);
    };
    on.line.while_judged = [&] {
        if (sent % 3 != 0) {
            on.submit(sent % 2 == 0 ? limit : level, "7", 400ms, std::to_string(sent));
            ++sent;
        }
    };
    for (unsigned i = 0; i < 300; ++i) {
        on.line.units[0].is_there = i / 20 % 2 == 0;
        on.line.is_gone = i % 50 == 49;
        on.submit(i % 4 == 0 ? level : limit, std::to_string(i), i % 7 == 0 ? 0ms : 250ms * (i % 5),
                  std::to_string(sent));
        ++sent;
        on.run_for(i % 3 == 0 ? 400ms : 20ms);
        take();
    }
    on.rounds.end();
    take();
    CHECK(answers.size() == sent);
    CHECK(told == sent);
    CHECK(std::ranges::all_of(answers, [](auto const& each) { return each.second == 1; }));
}

TEST_CASE("a setting that expires behind another's time-out, or while it is judged, is not written")
{
    rounds_on_line on{2};
    on.run_for(5s);
    on.submit(limit, "1", 100ms);
    on.line.pass(150ms); // a request of another unit
    on.run_for(1s);
    CHECK(on.answer().result == setting_result::expired);

    on.line.before_write = 150ms;
    on.submit(limit, "1", 100ms);
    on.run_for(1s);
    CHECK(on.answer().result == setting_result::expired);
    CHECK(on.line.units[0].written == 0);
}

TEST_CASE("a stored register is written once a minute at most")
{
    rounds_on_line on{1};
    on.run_for(5s);
    on.submit(level, "1");
    on.run_for(1s);
    CHECK(on.answer().result == setting_result::done);
    on.submit(level, "2");
    on.run_for(1s);
    setting_answer const soon = on.answer();
    CHECK(soon.result == setting_result::refused);
    CHECK(soon.why.find("60 s lie between two") != std::string::npos);
    on.run_for(59s);
    on.submit(level, "3");
    on.run_for(1s);
    CHECK(on.answer().result == setting_result::done);
    CHECK(on.line.units[0].written == 2);
    on.submit(limit, "1"); // one that is not stored
    on.run_for(1s);
    on.submit(limit, "2");
    on.run_for(1s);
    CHECK(on.line.units[0].written == 4);
}

TEST_CASE("a stored register keeps its interval in another line and under another name, also where its write was lost")
{
    rounds_on_line on{1};
    on.run_for(5s);
    on.line.loses_port_in_write = true;
    on.submit(level, "1");
    on.run_for(100ms);
    CHECK(on.answer().result == setting_result::failed); // written or not, nobody knows
    on.line.loses_port_in_write = false;
    on.line.is_gone = false;
    on.run_for(20s);

    line_plan renamed = on.plan;
    renamed.name = "line2";
    renamed.devices[0].name = "other";
    line_board board{renamed, true, [] {}};
    line_rounds again{renamed, on.line, board, on.stored};
    for (auto const end = on.line.now() + 2s; on.line.now() < end;) {
        again.step();
    }
    board.submit({0, level, "2", on.line.unix_time() + 10'000'000}, on.line.unix_time(), on.line.now());
    again.step();
    std::vector<setting_answer> const soon = board.take_answers();
    REQUIRE(soon.size() == 1);
    CHECK(soon[0].result == setting_result::refused);
    CHECK(soon[0].why.find("60 s lie between two") != std::string::npos);
    CHECK(on.line.units[0].written == 1);
}

TEST_CASE("a stored register keeps its interval where its port has another name")
{
    scratch_folder const folder;
    std::string const device = folder.write("ttyUSB0", "");
    std::string const link = folder.path("by-id");
    std::filesystem::create_symlink(device, link);
    auto const writes = [](rounds_on_line& on) {
        on.run_for(2s);
        on.submit(level, "1");
        on.run_for(1s);
        return on.answer().result;
    };
    for (bool const is_link_first : {false, true}) {
        rounds_on_line on{1};
        on.plan.choices.port = is_link_first ? link : device;
        REQUIRE(writes(on) == setting_result::done);
        on.plan.choices.port = is_link_first ? device : link;
        CHECK(writes(on) == setting_result::refused);
        on.plan.choices.port = folder.write("ttyUSB1", "");
        CHECK(writes(on) == setting_result::done);
        // Put in again: the link is the same, and the device's file has another name.
        on.plan.choices.port = link;
        on.run_for(60s);
        REQUIRE(writes(on) == setting_result::done);
        std::filesystem::remove(link);
        std::filesystem::create_symlink(folder.path("ttyUSB1"), link);
        CHECK(writes(on) == setting_result::refused);
        std::filesystem::remove(link);
        std::filesystem::create_symlink(device, link);
    }
}

TEST_CASE("for a device or a port that is away a setting fails at once, and comes to nothing later")
{
    rounds_on_line on{1};
    on.run_for(5s);
    on.line.units[0].is_there = false;
    on.run_for(10s);
    on.submit(limit, "1");
    on.run_for(100ms);
    CHECK(on.answer().result == setting_result::failed);
    on.line.units[0].is_there = true;
    on.run_for(10s);
    CHECK(on.line.units[0].written == 0);

    on.line.loses_port_in_write = true;
    on.submit(limit, "1");
    on.run_for(100ms);
    CHECK(on.answer().why == "nobody knows");
    CHECK(on.line.units[0].written == 1);
    CHECK(on.board.state().why == "the port is gone");
    CHECK(on.board.device(0)->why == "the port is gone");
    on.submit(limit, "2");
    on.run_for(100ms);
    CHECK(on.answer().why == "the line is away: the port is gone");
    on.line.loses_port_in_write = false;
    on.line.is_gone = false;
    on.run_for(60s);
    CHECK(on.board.state().is_up);
    CHECK(on.line.units[0].written == 1); // no second try
    CHECK(on.board.take_answers().empty());
}

TEST_CASE("nobody who takes nothing makes a line grow, and many settings starve no reading")
{
    rounds_on_line on{2};
    for (unsigned i = 0; i < 5'000; ++i) {
        on.submit(limit, std::to_string(i));
        on.line.units[1].is_there = i % 40 < 20;
        on.run_for(1s);
    }
    CHECK(on.board.take_events().size() == line_board::most_events);
    CHECK(on.board.take_answers().size() == line_board::most_answers);
    CHECK(on.line.units[0].reads >= 4'990);
}

TEST_CASE("a day of a line takes as much memory as its first hour")
{
    rounds_on_line on{10};
    auto const hours = [&on](unsigned count) {
        for (unsigned i = 0; i < count * 3'600; i += 60) {
            on.line.units[i / 60 % 10].is_there = i / 60 % 3 != 0;
            on.line.is_gone = i % 1'800 == 0;
            on.submit(limit, "1");
            on.run_for(60s);
            on.line.is_gone = false;
            static_cast<void>(on.board.take_events());
            static_cast<void>(on.board.take_answers());
        }
    };
    hours(1);
    std::size_t const before = ::mallinfo2().uordblks;
    hours(23);
    std::size_t const after = ::mallinfo2().uordblks;
    CHECK(after <= before + 4'096);
    CHECK(on.line.counts().asked > 400'000);
}
