// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// A program that does not call its client for any time, because it had nothing to ask or was stopped: what was in force
// before is over, and the next request leaves as from a client that is new.
#include "client_line.hpp"
#include "long_pauses.hpp"

#include "support/catch.hpp"

#include <algorithm>
#include <type_traits>
#include <utility>
#include <vector>

#include <rtuwire/altivar/atv320.hpp>
#include <rtuwire/altivar/cyclic/cyclic.hpp>
#include <rtuwire/altivar/procedure/inspection/watch.hpp>
#include <rtuwire/altivar/procedure/motion/broadcast_stop.hpp>
#include <rtuwire/altivar/procedure/motion/start.hpp>
#include <rtuwire/client/blocking.hpp>
#include <rtuwire/client/bus.hpp>
#include <rtuwire/wire/registers.hpp>

using namespace rtuwire;
using namespace rtuwire::detail;
using namespace rtuwire::test;

namespace {

constexpr client_options twice{.response_timeout = milliseconds(100), .retries = 1};
constexpr read_holding_registers request{3201, 1};

/// A port with a clock of 64 bits, moved on by hand, and a unit behind it that answers after 5 ms, or is silent.
struct moved_port {
    std::uint64_t time{0xFFFF'FFFFU - 3'000'000U};
    bool is_silent{false};
    std::vector<std::uint64_t> departures{};
    frame_bytes coming{};
    std::uint64_t comes_at{0};

    instant now() const { return instant{static_cast<std::uint32_t>(time)}; }
    result<void> write(byte_view bytes, instant)
    {
        departures.push_back(time);
        time += office_line.characters(bytes.size()).microseconds;
        if (not is_silent) {
            coming = response_to(frame_bytes(bytes.begin(), bytes.end()));
            comes_at = time + 5'000 + office_line.characters(coming.size()).microseconds;
        }
        return {};
    }
    result<byte_span> read(byte_span place, instant until)
    {
        auto const left = static_cast<std::int32_t>(until.microseconds - now().microseconds);
        std::uint64_t const end = time + static_cast<std::uint64_t>(std::max(left, 0));
        if (coming.empty() or comes_at > end) {
            time = end;
            return place.first(0);
        }
        time = std::max(time, comes_at);
        std::copy(coming.begin(), coming.end(), place.begin());
        return place.first(std::exchange(coming, {}).size());
    }
};

} // namespace

TEST_CASE("defect: D23 a waiting client that was not used for any time asks at once")
{
    moved_port fresh;
    blocking_client unused{fresh, office_line, twice};
    std::uint64_t const begin = fresh.time;
    REQUIRE(unused.ask(unit_id{1}, request));
    std::uint64_t const at_once = fresh.departures.back() - begin;
    for (std::uint64_t const pause : long_pauses) {
        for (bool const was_silent : {false, true}) {
            INFO("not used for " << pause << " us, the unit was " << (was_silent ? "silent" : "there"));
            moved_port port;
            blocking_client line{port, office_line, twice};
            port.is_silent = was_silent;
            CHECK(line.ask(unit_id{1}, request).has_value() != was_silent);
            port.is_silent = false;
            port.time += pause;
            std::uint64_t const start = port.time;
            CHECK(line.ask(unit_id{1}, request));
            CHECK(port.departures.back() - start <= at_once);
            CHECK(port.time - start < 50'000);
        }
    }
}

TEST_CASE(
    "defect: D23 what was in force is kept over a short pause, and after one of whole turns no longer than before")
{
    constexpr std::uint64_t wrap = std::uint64_t{1} << 32U;
    for (std::uint64_t const turns : {0U, 1U, 2U}) {
        moved_port port;
        blocking_client line{port,
                             office_line,
                             {.response_timeout = milliseconds(100), .late_response = milliseconds(900), .retries = 0}};
        port.is_silent = true;
        CHECK(line.ask(unit_id{1}, request) == errc::timed_out);
        port.is_silent = false;
        std::uint64_t const asked = port.departures.back();
        port.time += turns * wrap + 50'000;
        std::uint64_t const start = port.time;
        CHECK(line.ask(unit_id{1}, request));
        std::uint64_t const held = port.departures.back() - asked - turns * wrap;
        CHECK(held >= 1'000'000); // R + L
        CHECK(port.departures.back() - start < 1'000'000);
    }
}

namespace {

template <typename Link> void visit(Link& link, std::size_t, series& conversation, instant now)
{
    link.converse(conversation, now);
}
void visit(bus<2>& link, std::size_t slot, series& conversation, instant now)
{
    link.converse(slot, conversation, now);
}

/// Two units, of which the second is silent up to the pause.
template <typename Link> struct two_units {
    scripted_line<Link> line{Link{office_line, twice}, office_line};
    series first{[](unsigned) { return read_of(1, 3201); }};
    series second{[](unsigned) { return read_of(2, 3201); }};
    bool is_whole{false};

    two_units()
    {
        line.heard = [this](frame_bytes const& frame) {
            if (at(frame, 0) == 1 or is_whole) {
                line.say(5'000, response_to(frame));
            }
        };
    }
    void run(std::uint64_t length)
    {
        line.run(length, [this](instant now) {
            visit(line.link, 0, first, now);
            visit(line.link, 1, second, now);
        });
    }
};

/// Stopped after so long for a pause: which of the units are answered within two seconds of it.
template <typename Link> std::pair<bool, bool> goes_on_after(std::uint64_t ran, std::uint64_t pause)
{
    two_units<Link> it;
    it.run(ran);
    it.is_whole = true;
    it.line.stop(pause);
    unsigned const first = it.first.answered;
    unsigned const second = it.second.answered;
    it.run(2'000'000);
    return {it.first.answered > first, it.second.answered > second};
}

/// Stopped at many moments: whatever was under way, it goes on as after a minute. A client asks both units again; a bus
/// asks the second one later, where the stopped time counts as time that this unit cost.
template <typename Link> void goes_on_after_any_pause()
{
    for (std::uint64_t ran = 1'000; ran < 1'500'000; ran += 13'700) {
        auto const usual = goes_on_after<Link>(ran, minute);
        CHECK(usual.first);
        CHECK((usual.second or std::is_same_v<Link, bus<2>>));
        for (std::uint64_t const pause : long_pauses) {
            INFO("stopped for " << pause << " us after " << ran << " us");
            CHECK(goes_on_after<Link>(ran, pause) == usual);
        }
    }
}

} // namespace

TEST_CASE("defect: D23 a client, a drive client and a bus whose program was stopped go on, whatever was under way")
{
    goes_on_after_any_pause<client>();
    goes_on_after_any_pause<drive_client<2>>();
    goes_on_after_any_pause<bus<2>>();
}

namespace {

/// A unit that answers the second sending of each request only. How many requests it answered within two seconds of a
/// pause: without one, five of them.
template <typename Link> unsigned answered_after(std::uint64_t ran, std::uint64_t pause)
{
    scripted_line<Link> line{Link{office_line, twice}, office_line};
    series reads{[](unsigned number) { return read_of(1, 3201 + number % 7); }};
    unsigned frames = 0;
    line.heard = [&](frame_bytes const& frame) {
        if (++frames % 2 == 0) {
            line.say(5'000, response_to(frame));
        }
    };
    auto const converse = [&](instant now) { visit(line.link, 0, reads, now); };
    line.run(ran, converse);
    line.stop(pause);
    unsigned const before = reads.answered;
    line.run(2'000'000, converse);
    return reads.answered - before;
}

/// The longest that its time limits allow: two sendings, each with 100 ms to leave, 100 ms for its response and 200 ms for
/// a late one, and once more 200 ms; less than 1.1 s with all frames.
template <typename Link> void is_answered_after_any_pause()
{
    for (std::uint64_t ran = 1'000; ran < 900'000; ran += 3'700) {
        for (std::uint64_t const pause : long_pauses) {
            INFO("stopped for " << pause << " us after " << ran << " us");
            CHECK(answered_after<Link>(ran, pause) >= 2);
        }
    }
}

} // namespace

TEST_CASE("defect: D23 a pause in the middle of a request counts as no time that its unit takes")
{
    is_answered_after_any_pause<client>();
    is_answered_after_any_pause<bus<2>>();
}

TEST_CASE("defect: D23 a unit that the user holds is free once the hold is over, whoever looks")
{
    for (std::uint64_t const pause : long_pauses) {
        INFO("stopped for " << pause << " us");
        scripted_line<client> line{client{office_line, twice}, office_line};
        line.link.hold(unit_id{1}, line.now() + milliseconds(30'000));
        line.run(1'000, [](instant) {});
        CHECK(line.link.is_held(unit_id{1}));
        line.stop(pause);
        line.run(1'000, [](instant) {});
        CHECK_FALSE(line.link.is_held(unit_id{1}));
    }
}

namespace {

constexpr station<altivar::atv320::device> motor{unit_id{3}};

instant after(std::uint64_t pause) { return instant{static_cast<std::uint32_t>(0xFFFF'0000U + pause)}; }

} // namespace

TEST_CASE("defect: D23 a start that nobody visited for any time is late, and orders nothing")
{
    for (std::uint64_t const pause : long_pauses) {
        for (bool const asks : {false, true}) {
            INFO("not visited for " << pause << " us, " << (asks ? "with a request" : "without one"));
            altivar::start go{motor, 50_Hz};
            go.advance(after(0));
            if (asks) {
                REQUIRE(go.next());
                go.advance(after(pause)); // its client did not hear the outcome yet
                go.accept(errc::timed_out);
            }
            go.advance(after(pause));
            CHECK(go.settled());
            CHECK_FALSE(go.succeeded());
        }
    }
}

TEST_CASE("defect: D23 a watch and a cycle that nobody visited for any time are due")
{
    for (std::uint64_t const pause : long_pauses) {
        INFO("not visited for " << pause << " us");
        altivar::watch watched{motor};
        altivar::cyclic cycle{motor};
        watched.advance(after(0));
        cycle.advance(after(0));
        REQUIRE(watched.next());
        REQUIRE(cycle.next());
        watched.accept(errc::timed_out);
        cycle.accept(errc::timed_out);
        CHECK_FALSE(watched.next());
        watched.advance(after(pause));
        cycle.advance(after(pause));
        CHECK(watched.next());
        CHECK(cycle.next());
    }
}

TEST_CASE("defect: D23 the last round of a broadcast stop comes after any time")
{
    for (std::uint64_t const pause : long_pauses) {
        INFO("not visited for " << pause << " us");
        altivar::broadcast_stop all{motor};
        all.advance(after(0));
        for (unsigned sent = 0; all.next(); ++sent) {
            REQUIRE(sent < 20);
            all.accept(response{});
        }
        REQUIRE(all.is_urgent());
        all.advance(after(pause));
        CHECK(all.next());
    }
}
