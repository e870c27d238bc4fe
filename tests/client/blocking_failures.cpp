// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// A client that waits, when its port breaks and while its conversation pauses.
#include <rtuwire/client/blocking.hpp>

#include <array>
#include <optional>
#include <vector>

#include "support/catch.hpp"

#include <rtuwire/altivar/atv320.hpp>
#include <rtuwire/altivar/procedure/motion/stop.hpp>
#include <rtuwire/sim/bench.hpp>
#include <rtuwire/wire/registers.hpp>

using namespace rtuwire;

namespace {

constexpr line_timing timing{19'200, character_format::even_8_1};

/// A port on which nobody answers. Its clock jumps to each deadline; it breaks so many reads after the first frame.
struct silent_port {
    std::optional<unsigned> reads_left{};
    bool is_broken{false};
    instant clock{0xFFFF'FF00U};
    std::vector<instant> sent_at{};
    unsigned reads{0};

    instant now() const { return clock; }
    result<void> write(byte_view bytes, instant)
    {
        if (is_broken) {
            return errc::device_vanished;
        }
        sent_at.push_back(clock);
        clock = clock + timing.characters(bytes.size());
        return {};
    }
    result<byte_span> read(byte_span place, instant until)
    {
        ++reads;
        if (reads_left and not sent_at.empty()) {
            is_broken = is_broken or *reads_left == 0;
            --*reads_left;
        }
        if (is_broken) {
            return errc::device_vanished;
        }
        clock = reached(clock, until) ? clock + microseconds(10) : until;
        return place.first(0);
    }
};

/// One request; counts what it is told.
template <typename Request> struct counted : asker {
    single_request<Request> conversation;
    unsigned told{0};
    errc last{errc::none};

    template <typename To> counted(To to, Request const& asked) : conversation{to, asked} {}
    std::optional<request_frame> next() const { return conversation.next(); }
    void accept(result<response> const& outcome)
    {
        ++told;
        last = outcome.error();
        conversation.accept(outcome);
    }
    bool settled() const { return conversation.settled(); }
};

using counted_read = counted<read_holding_registers>;
using counted_stop = counted<write_single_register>;
constexpr read_holding_registers request{3201, 1};
constexpr write_single_register stop_word{8501, 0};

/// Asks its request at once, and has a time limit of its own.
struct limited_read : counted_read {
    instant limit;

    explicit limited_read(instant end) : counted_read{unit_id{1}, request}, limit{end} {}
    static void advance(instant) {}
    deadline poll_deadline() const { return settled() ? deadline{} : deadline{limit}; }
};

/// Asks its request so long after it was looked at first.
struct late_read : counted_read {
    duration pause;
    std::optional<instant> due{};
    bool is_due{false};

    explicit late_read(duration length) : counted_read{unit_id{1}, request}, pause{length} {}
    void advance(instant now)
    {
        due = due ? due : std::optional{now + pause};
        is_due = is_due or reached(now, *due);
    }
    deadline poll_deadline() const { return is_due ? deadline{} : due; }
    std::optional<request_frame> next() const { return is_due ? counted_read::next() : std::nullopt; }
};

} // namespace

TEST_CASE("a conversation whose port breaks is told once, whatever its request is")
{
    for (unsigned const reads : {0U, 1U}) {
        INFO("after " << reads << " reads");
        silent_port port;
        port.reads_left = reads;
        blocking_client line{port, timing};
        counted_read conversation{unit_id{1}, request};
        CHECK(line.run(conversation) == errc::device_vanished);
        CHECK(conversation.told == 1);
        CHECK(conversation.last == errc::cancelled);
    }
    silent_port port;
    port.reads_left = 0;
    blocking_client line{port, timing};
    counted_stop conversation{broadcast, stop_word}; // units still get their time for it
    CHECK(line.run(conversation) == errc::device_vanished);
    CHECK(conversation.told == 1);
    CHECK(conversation.last == errc::cancelled);
}

TEST_CASE("a conversation whose port broke before it asked is told nothing")
{
    silent_port port;
    port.is_broken = true;
    blocking_client line{port, timing};
    counted_read conversation{unit_id{1}, request};
    CHECK(line.run(conversation) == errc::device_vanished);
    CHECK(conversation.told == 0);
    CHECK_FALSE(conversation.settled());
}

TEST_CASE("a conversation that could not ask while a command took its time is not ahead for it")
{
    std::array<unsigned, 2> reads{};
    for (unsigned const has_tried : {0U, 1U}) {
        silent_port port;
        port.reads_left = 0;
        blocking_client line{port, timing};
        counted_stop everyone{broadcast, stop_word};
        REQUIRE_FALSE(line.run(everyone));
        counted_read conversation{unit_id{1}, request};
        if (has_tried == 1) {
            REQUIRE(line.run(conversation) == errc::device_vanished);
            REQUIRE(conversation.told == 0);
        }
        port.is_broken = false;
        port.reads_left.reset();
        port.clock = port.clock + milliseconds(200); // that time is over
        unsigned const before = port.reads;
        REQUIRE(line.run(conversation));
        REQUIRE(port.sent_at.size() == 4); // and two repetitions
        reads.at(has_tried) = port.reads - before;
    }
    CHECK(reads[0] == reads[1]);
}

TEST_CASE("a conversation that pauses is looked at when its pause ends, and not before")
{
    for (duration const pause : {milliseconds(3), milliseconds(30), milliseconds(3'000)}) {
        silent_port port;
        blocking_client line{port, timing};
        late_read conversation{pause};
        instant const begin = port.clock;
        REQUIRE(line.run(conversation));
        REQUIRE_FALSE(port.sent_at.empty());
        // The line has to be silent before it is looked at first.
        instant const due = begin + timing.t3_5() + pause;
        CHECK(port.sent_at.front() - due < milliseconds(1));
        CHECK(conversation.told == 1);
    }
    silent_port port;
    blocking_client line{port, timing};
    late_read conversation{milliseconds(3'000)};
    port.reads_left = 0; // breaks behind the request
    CHECK(line.run(conversation) == errc::device_vanished);
    CHECK(port.reads < 6);
}

TEST_CASE("a conversation whose unit was held asks as soon as the hold ends, whatever its own time limit is")
{
    silent_port port;
    blocking_client line{port, timing, {.retries = 0}};
    counted_read missed{unit_id{1}, request};
    REQUIRE(line.run(missed));
    REQUIRE(missed.last == errc::timed_out);
    instant const begin = port.clock;
    limited_read conversation{begin + milliseconds(20'000)};
    REQUIRE(line.run(conversation));
    REQUIRE(port.sent_at.size() == 2);
    CHECK(port.sent_at.back() - begin < milliseconds(250)); // late_response, and a little
}

TEST_CASE("the shortest of time-outs does not make a client look at its port again and again")
{
    for (duration const timeout : {duration{}, milliseconds(1)}) {
        silent_port port;
        blocking_client line{
            port, timing, {.response_timeout = timeout, .turnaround = milliseconds(2'000), .retries = 0}};
        CHECK(line.send_broadcast(stop_word));
        CHECK(port.reads < 10);
    }
}

TEST_CASE("a stop that has ended is sent again by a second run, and is no success where nobody answers")
{
    constexpr station<altivar::atv320::device> drive{unit_id{1}};
    altivar::stop order{drive};
    sim::bench bench{timing, drive};
    REQUIRE(bench.run(order).kind == altivar::outcome_kind::succeeded);
    silent_port port;
    blocking_client line{port, timing};
    CHECK(line.run(order).kind == altivar::outcome_kind::silent);
    CHECK_FALSE(port.sent_at.empty());
}
