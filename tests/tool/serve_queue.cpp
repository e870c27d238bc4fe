// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Whose request is next where many wait, and how much of a line's time a unit costs that does not answer. All time is this
// test's own.
#include "serve/request_queue.hpp"

#include <algorithm>
#include <chrono>
#include <cstdint>
#include <map>
#include <random>
#include <vector>

#include "serve/silent_units.hpp"
#include "support/catch.hpp"

using namespace std::chrono_literals;
using tool::request_queue;
using tool::serve_time;
using tool::served_request;

namespace {

serve_time const begin{std::chrono::hours{1}};

served_request request_of(std::uint64_t client, std::uint16_t number, serve_time came = begin)
{
    return {.client = client, .number = number, .unit = 1, .pdu = {std::byte{3}}, .came = came};
}

} // namespace

TEST_CASE("serve: a client with many requests keeps nobody waiting behind them")
{
    request_queue queue;
    for (std::uint16_t i = 0; i < 16; ++i) {
        REQUIRE(queue.add(request_of(1, i)));
    }
    REQUIRE(queue.add(request_of(2, 100)));
    REQUIRE(queue.add(request_of(9, 200)));
    std::vector<std::uint64_t> order;
    std::vector<std::uint16_t> of_first;
    while (auto const next = queue.take(begin)) {
        order.push_back(next->client);
        if (next->client == 1) {
            of_first.push_back(next->number);
        }
    }
    CHECK(std::vector<std::uint64_t>{order.begin(), order.begin() + 4} == std::vector<std::uint64_t>{1, 2, 9, 1});
    CHECK(order.size() == 18);
    CHECK(std::ranges::is_sorted(of_first));
    CHECK(of_first.size() == 16);
}

TEST_CASE("serve: between two turns of a client that waits each other has one at most, whoever comes and goes")
{
    std::mt19937 random{20261130};
    request_queue queue;
    std::map<std::uint64_t, std::size_t> waiting;                           // how many of each, by this test
    std::map<std::uint64_t, std::map<std::uint64_t, unsigned>> turns_since; // of a client that waits: turns of others
    for (unsigned step = 0; step < 20'000; ++step) {
        std::uint64_t const client = 1 + random() % 32;
        auto const what = static_cast<unsigned>(random() % 100);
        if (what < 55) {
            bool const is_room = waiting[client] < 16 and queue.size() < 256;
            REQUIRE(queue.add(request_of(client, 0)) == is_room);
            if (is_room and ++waiting[client] == 1) {
                turns_since[client].clear();
            }
        } else if (what < 99) {
            auto const next = queue.take(begin);
            std::size_t const all = [&] {
                std::size_t sum = 0;
                for (auto const& [of, count] : waiting) {
                    sum += count;
                }
                return sum;
            }();
            REQUIRE(next.has_value() == (all > 0));
            if (next) {
                REQUIRE(waiting[next->client] > 0);
                --waiting[next->client];
                for (auto& [of, turns] : turns_since) {
                    if (of != next->client and waiting[of] > 0) {
                        REQUIRE(++turns[next->client] <= 1);
                    }
                }
                turns_since[next->client].clear();
            }
        } else {
            queue.drop(client);
            waiting[client] = 0;
        }
    }
}

TEST_CASE("serve: a queue has limits, of a client and of all")
{
    request_queue queue;
    for (std::uint16_t i = 0; i < 16; ++i) {
        REQUIRE(queue.add(request_of(1, i)));
    }
    CHECK_FALSE(queue.add(request_of(1, 16)));
    for (std::uint64_t client = 2; client <= 16; ++client) {
        for (std::uint16_t i = 0; i < 16; ++i) {
            REQUIRE(queue.add(request_of(client, i)));
        }
    }
    CHECK(queue.size() == 256);
    CHECK_FALSE(queue.add(request_of(99, 0)));
    REQUIRE(queue.take(begin));
    CHECK(queue.add(request_of(99, 0)));
}

TEST_CASE("serve: of a client that left nothing is taken, and what is old is handed out once")
{
    request_queue queue;
    REQUIRE(queue.add(request_of(1, 1)));
    REQUIRE(queue.add(request_of(2, 2, begin + 1s)));
    REQUIRE(queue.add(request_of(3, 3, begin + 3s)));
    CHECK(queue.next_old() == begin + 5s);
    queue.drop(1);
    CHECK(queue.next_old() == begin + 6s);
    CHECK(queue.take_old(begin + 6s - 1ns).empty());
    auto const old = queue.take_old(begin + 6s);
    REQUIRE(old.size() == 1);
    CHECK(old[0].number == 2);
    CHECK(queue.take_old(begin + 6s).empty());
    CHECK(queue.size() == 1);
    CHECK(queue.take(begin)->number == 3);
    CHECK_FALSE(queue.take(begin));
    CHECK_FALSE(queue.next_old());
}

TEST_CASE("serve: what came behind a request that is old goes with it, in its order, and another client's stays")
{
    request_queue queue;
    REQUIRE(queue.add(request_of(1, 1)));
    REQUIRE(queue.add(request_of(1, 2, begin + 4s)));
    REQUIRE(queue.add(request_of(1, 3, begin + 5s)));
    REQUIRE(queue.add(request_of(2, 4, begin + 1s)));
    CHECK(queue.has(1));
    auto const old = queue.take_old(begin + 5s);
    REQUIRE(old.size() == 3);
    CHECK(old[0].number == 1);
    CHECK(old[1].number == 2);
    CHECK(old[2].number == 3);
    CHECK(queue.size() == 1);
    CHECK_FALSE(queue.has(1));
    CHECK(queue.take(begin)->number == 4);
}

TEST_CASE(
    "serve: a request without a response comes again behind the others' turns, and before what its client sent later")
{
    request_queue queue;
    REQUIRE(queue.add(request_of(1, 1)));
    REQUIRE(queue.add(request_of(1, 2)));
    REQUIRE(queue.add(request_of(2, 3)));
    auto first = queue.take(begin);
    REQUIRE(first);
    CHECK(first->number == 1);
    queue.put_back(*first);
    CHECK(queue.size() == 3);
    std::vector<std::uint16_t> order;
    while (auto const next = queue.take(begin)) {
        order.push_back(next->number);
    }
    CHECK(order == std::vector<std::uint16_t>{3, 1, 2});
}

TEST_CASE("serve: who wants a unit that is left alone waits, and nobody else does")
{
    request_queue queue;
    REQUIRE(queue.add(request_of(1, 1)));
    REQUIRE(queue.add({.client = 2, .number = 2, .unit = 5, .pdu = {std::byte{3}}, .came = begin}));
    REQUIRE(queue.add({.client = 2, .number = 3, .unit = 1, .pdu = {std::byte{3}}, .came = begin}));
    queue.leave_alone(request_of(1, 1), begin + 200ms, begin + 200ms);
    REQUIRE(queue.next_turn());
    CHECK(*queue.next_turn() <= begin);
    CHECK(queue.take(begin)->number == 2);
    CHECK(queue.next_turn() == begin + 200ms);
    CHECK_FALSE(queue.take(begin + 199ms)); // of both clients the next is for that unit
    CHECK(queue.take(begin + 200ms)->number == 1);
    CHECK(queue.take(begin + 200ms)->number == 3);
    CHECK_FALSE(queue.next_turn());
}

TEST_CASE(
    "serve: a unit that is kept for a reading of another's is not asked for clients before, and nobody else waits")
{
    request_queue queue;
    served_request const again{
        .client = 1, .number = 1, .unit = 1, .pdu = {std::byte{3}}, .came = begin, .sent = 1}; // whatever was sent
    queue.put_back(again);
    REQUIRE(queue.add({.client = 2, .number = 2, .unit = 5, .pdu = {std::byte{3}}, .came = begin}));
    queue.keep(1, begin + 2s);
    CHECK(queue.is_held(again, begin + 1999ms));
    CHECK(queue.take(begin)->number == 2);
    CHECK(queue.next_turn() == begin + 2s);
    CHECK_FALSE(queue.take(begin + 1999ms));
    SECTION("until it was done")
    {
        queue.note_kept_done(5);
        CHECK_FALSE(queue.take(begin));
        queue.note_kept_done(1);
        CHECK_FALSE(queue.is_held(again, begin));
        CHECK(queue.take(begin)->number == 1);
    }
    SECTION("until then, where it is not done")
    {
        CHECK_FALSE(queue.is_held(again, begin + 2s));
        CHECK(queue.take(begin + 2s)->number == 1);
    }
    SECTION("for longer where it is kept again")
    {
        queue.keep(1, begin + 3s);
        CHECK_FALSE(queue.take(begin + 2s));
        CHECK(queue.take(begin + 3s)->number == 1);
    }
    SECTION("where it is known to be silent nobody waits for that")
    {
        queue.refuse_at_once([](std::uint8_t unit) { return unit == 1; });
        CHECK(queue.take(begin)->number == 1);
    }
    SECTION("and what waits too long is refused all the same")
    {
        queue.keep(1, begin + 10s);
        CHECK(queue.take_old(begin + request_queue::oldest).size() == 1);
        CHECK(queue.size() == 0);
    }
}

TEST_CASE("serve: an answer that may come yet is waited for by each request that it might be taken for")
{
    auto const wants = [](std::uint16_t number, std::uint8_t function, std::uint8_t address, unsigned sent = 0) {
        return served_request{.client = number,
                              .number = number,
                              .unit = 1,
                              .pdu = {std::byte{function}, std::byte{0}, std::byte{address}},
                              .came = begin,
                              .sent = sent};
    };
    for (bool const is_refused : {false, true}) { // a unit that is known to be silent
        INFO(is_refused);
        request_queue queue;
        queue.refuse_at_once([&](std::uint8_t) { return is_refused; });
        queue.leave_alone(wants(1, 3, 7), begin + 200ms, begin + 1500ms);
        queue.leave_alone(wants(9, 4, 7), begin + 200ms, begin + 900ms); // another function's debt is another
        REQUIRE(queue.add(wants(1, 3, 7, 1)));                           // the same again
        REQUIRE(queue.add(wants(2, 3, 8)));
        REQUIRE(queue.add(wants(3, 6, 8))); // its answer says what it wrote
        CHECK(queue.is_held(wants(2, 3, 8), begin + 1499ms));
        CHECK(queue.is_held(wants(4, 3, 7), begin + 1499ms)); // another's, of the same registers
        CHECK_FALSE(queue.is_held(wants(2, 3, 8), begin + 1500ms));
        std::vector<std::uint16_t> order;
        for (auto const at : {begin + 199ms, begin + 200ms, begin + 1499ms, begin + 1500ms}) {
            while (auto const next = queue.take(at)) {
                order.push_back(next->number);
            }
            order.push_back(0);
        }
        CHECK(order == (is_refused ? std::vector<std::uint16_t>{1, 2, 3, 0, 0, 0, 0}
                                   : std::vector<std::uint16_t>{0, 1, 3, 0, 0, 2, 0}));
    }
}

namespace {

/// Two clients that ask at once again, of unit 9, which is off, and of unit 1, which answers within 10 ms. A time-out takes 1 s.
struct shared_line {
    tool::silent_units silent{};
    serve_time now = begin;
    unsigned answered{0};
    unsigned timed_out{0};
    std::chrono::nanoseconds longest_wait{0}; ///< between two answers of unit 1

    void run(std::chrono::seconds time, bool has_other)
    {
        serve_time const end = now + time;
        serve_time latest = now;
        while (now < end) {
            silent.note_request(9, now);
            if (silent.is_due(9, now)) {
                now += 1s;
                ++timed_out;
                silent.note(9, false, now, 1s);
            }
            now += 10ms; // the client's own time, or unit 1's
            if (has_other) {
                silent.note_request(1, now);
                REQUIRE(silent.is_due(1, now));
                silent.note(1, true, now, 10ms);
                longest_wait = std::max<std::chrono::nanoseconds>(longest_wait, now - latest);
                latest = now;
                ++answered;
            }
        }
    }
};

} // namespace

TEST_CASE("serve: a unit that is off costs the others one time-out now and then")
{
    shared_line line;
    line.run(300s, true);
    // Behind pauses of 0.25, 0.5, 1, 2, 4 and then 8 s: a time-out each 9 s, and 6 at the beginning.
    CHECK(line.timed_out <= 300 / 9 + 6);
    CHECK(line.timed_out >= 300 / 10);
    CHECK(line.longest_wait <= 1'010ms);
    CHECK(line.answered > 25'000);
}

TEST_CASE("serve: many units that are off cost the others a tenth of the line")
{
    constexpr std::uint8_t first = 10, count = 30;
    constexpr auto timeout = 500ms;
    tool::silent_units silent;
    serve_time now = begin;
    unsigned tried = 0;
    std::map<std::uint8_t, unsigned> tries;
    auto const run = [&](std::chrono::seconds time) {
        tried = 0;
        tries.clear();
        for (serve_time const end = now + time; now < end;) {
            for (std::uint8_t unit = first; unit < first + count;
                 ++unit) { // whose clients ask at once again, each in its turn
                silent.note_request(unit, now);
                if (silent.is_due(unit, now)) {
                    now += timeout;
                    ++tried;
                    ++tries[unit];
                    silent.note(unit, false, now, timeout);
                }
                silent.note_request(1, now);
                REQUIRE(silent.is_due(1, now));
                now += 10ms;
                silent.note(1, true, now, 10ms);
            }
        }
    };
    run(60s);
    CHECK(tried <= count + 60s / (10 * timeout) + 2); // each of them had to be met
    run(600s);
    CHECK(tried <= 600s / (10 * timeout) + 1);
    CHECK(tried >= 100); // and they are found when they are back
    CHECK(tries.size() == count);
}

TEST_CASE("serve: a unit that missed one request is asked soon again")
{
    tool::silent_units silent;
    silent.note_request(1, begin);
    silent.note(7, true, begin, 10ms);
    CHECK(silent.has_answered(7));
    silent.note(7, false, begin, 1s);
    CHECK_FALSE(silent.has_answered(7));
    CHECK_FALSE(silent.is_due(7, begin + 240ms));
    CHECK(silent.is_due(7, begin + 250ms));
}

TEST_CASE("serve: a unit that nobody else waits beside is asked each time")
{
    shared_line line;
    line.run(60s, false);
    CHECK(line.timed_out == 60);
    line.run(30s, true); // its pause is the longest by now
    CHECK(line.timed_out <= 60 + 4);
}

TEST_CASE("serve: that a unit falls silent is news once, and that it is back")
{
    tool::silent_units units;
    CHECK_FALSE(units.note(7, true, begin, 1s));
    CHECK(units.note(7, false, begin, 1s));
    CHECK_FALSE(units.note(7, false, begin + 1s, 1s));
    CHECK(units.is_silent(7));
    CHECK(units.note(7, true, begin + 2s, 1s));
    CHECK_FALSE(units.is_silent(7));
    units.note_request(7, begin + 2s);
    units.note_request(8, begin + 2s);
    CHECK(units.is_due(7, begin + 2s));
}
