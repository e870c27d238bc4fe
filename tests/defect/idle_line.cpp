// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// A line on which nothing happens for longer than an instant can be told from the past (35 minutes), or for longer
// than the clock counts (71.6 minutes): what comes then is heard and answered as on the first day.
#include "client_line.hpp"

#include "support/catch.hpp"

#include <rtuwire/client/bus.hpp>
#include <rtuwire/core/hex.hpp>
#include <rtuwire/rtu/framer.hpp>
#include <rtuwire/server/server.hpp>

using namespace rtuwire;
using namespace rtuwire::detail;
using namespace rtuwire::test;

namespace {

constexpr std::uint64_t minute = 60'000'000;
constexpr std::uint64_t wrap = std::uint64_t{1} << 32U;

/// On both sides of each edge: 35 minutes, half the counter, the whole counter, and one and a half.
constexpr std::array<std::uint64_t, 12> idle_times{
    34 * minute,      35 * minute + 1,  wrap / 2 - 1, wrap / 2 + 1,      wrap / 2 + minute,
    50 * minute,      wrap - 1,         wrap + 1,     wrap + 5 * minute, wrap + wrap / 2 + minute,
    107 * minute + 1, 2 * wrap + minute};

constexpr client_options once{.response_timeout = milliseconds(100), .retries = 0};

/// How the noise comes.
enum class noise { none, bytes, damaged };

template <typename Link> void converse(Link& link, series& conversation, instant now)
{
    link.converse(conversation, now);
}
void converse(bus<2>& link, series& conversation, instant now) { link.converse(1, conversation, now); }

/// A request is answered, nothing happens for so long, there is noise, and another is answered.
template <typename Link> void goes_on_after(std::uint64_t idle, noise what)
{
    INFO("idle for " << idle << " us, noise " << static_cast<int>(what));
    scripted_line<Link> line{Link{office_line, once}, office_line};
    line.heard = [&](frame_bytes const& frame) { line.say(5'000, response_to(frame)); };
    series before{[](unsigned) { return read_of(1, 3201); }, 1};
    line.run(100'000, [&](instant now) { converse(line.link, before, now); });
    REQUIRE(before.answered == 1);
    line.run(idle, [](instant) {});
    if (what != noise::none) {
        line.say(0, what == noise::bytes ? frame_bytes{std::byte{0x55}, std::byte{0xAA}} : frame_bytes{});
    }
    std::uint64_t const start = line.time();
    series after{[](unsigned) { return read_of(1, 3201); }, 1};
    line.run(100'000, [&](instant now) { converse(line.link, after, now); });
    CHECK(after.answered == 1);
    REQUIRE(line.departures.size() >= 2);
    CHECK(line.departures[1].begin <= start + 5'000);
}

} // namespace

TEST_CASE("defect: A3 a client hears and asks after any idle time")
{
    for (std::uint64_t const idle : idle_times) {
        for (noise const what : {noise::none, noise::bytes, noise::damaged}) {
            goes_on_after<client>(idle, what);
            goes_on_after<bus<2>>(idle, what);
        }
    }
}

namespace {

constexpr auto read_0 = "01 03 00 00 00 01 84 0A"_hex;
constexpr auto says_1111 = "01 03 02 11 11 74 18"_hex;

/// A server whose loop sleeps as long as it says, but no longer than its header allows.
struct sleeping_server {
    server node{unit_id{1}, office_line};
    word_bank<1> bank{};
    std::uint64_t time{0xFFFF'FFFFU - 3'000'000U};

    sleeping_server()
    {
        static_cast<void>(bank.set(0, 0x1111));
        pass();
        sleep(10'000);
    }
    instant now() const { return instant{static_cast<std::uint32_t>(time)}; }
    byte_view pass()
    {
        node.serve(bank, now());
        return node.poll_transmit();
    }
    /// What it sends meanwhile.
    byte_view sleep(std::uint64_t length)
    {
        std::uint64_t const end = time + length;
        byte_view sent{};
        while (time < end) {
            std::uint64_t next = std::min(end, time + 35 * minute);
            if (deadline const due = node.poll_deadline()) {
                auto const left = static_cast<std::int32_t>(due->microseconds - now().microseconds);
                next = std::min(next, time + static_cast<std::uint64_t>(std::max(left, 1)));
            }
            time = next;
            byte_view const frame = pass();
            sent = frame.empty() ? sent : frame;
        }
        return sent;
    }
    bool answers()
    {
        time += office_line.characters(read_0.size()).microseconds;
        node.receive(read_0, now());
        static_cast<void>(pass());
        byte_view const frame = sleep(10'000);
        bool const is_right = same_bytes(frame, says_1111);
        time += office_line.characters(frame.size()).microseconds;
        node.sent(now());
        return is_right;
    }
};

} // namespace

TEST_CASE("defect: A3 a server hears and answers after any idle time")
{
    for (std::uint64_t const idle : idle_times) {
        for (noise const what : {noise::none, noise::bytes, noise::damaged}) {
            INFO("idle for " << idle << " us, noise " << static_cast<int>(what));
            sleeping_server it;
            REQUIRE(it.answers());
            it.sleep(idle);
            if (what == noise::bytes) {
                it.node.receive("55 AA"_hex, it.now());
            } else if (what == noise::damaged) {
                it.node.receive_error(it.now());
            }
            it.sleep(20'000);
            CHECK(it.answers());
        }
    }
}

TEST_CASE("defect: A3 a framer whose line was quiet ends the next frame by silence after any time")
{
    for (std::uint64_t const idle : idle_times) {
        INFO("idle for " << idle << " us");
        framer<direction::response> cutter{office_line};
        std::uint64_t time = 0;
        auto const now = [&] { return instant{static_cast<std::uint32_t>(time)}; };
        cutter.advance(now());
        time += 1'000'000;
        cutter.advance(now());
        REQUIRE(cutter.is_quiet());
        REQUIRE_FALSE(cutter.poll_deadline());
        time += idle;
        CHECK(cutter.receive("55 AA"_hex, now()) == 2);
        REQUIRE(cutter.poll_deadline() == deadline{now() + office_line.t3_5()});
        time += office_line.frame_end().microseconds;
        cutter.advance(now());
        CHECK(cutter.is_quiet());
        auto const noise_ended = cutter.poll_frame();
        REQUIRE(noise_ended);
        CHECK(noise_ended->error() == errc::frame_too_short);
        time += 10'000;
        CHECK(cutter.receive(says_1111, now()) == says_1111.size());
        auto const frame = cutter.poll_frame();
        REQUIRE(frame);
        CHECK(frame->has_value());
    }
}

namespace {

/// A bus of two: its first unit needs rest between two requests, its second says nothing.
struct resting_bus {
    scripted_line<bus<2>> line{bus<2>{office_line, once}, office_line};
    series first{[](unsigned) { return read_of(1, 3201); }};
    series second{[](unsigned) { return read_of(2, 3201); }};

    resting_bus()
    {
        line.link.set(0,
                      {.with = {.response_timeout = milliseconds(100), .retries = 0}, .least_idle = milliseconds(300)});
        line.heard = [this](frame_bytes const& frame) {
            if (at(frame, 0) == 1) {
                line.say(5'000, response_to(frame));
            }
        };
    }
    void run(std::uint64_t length)
    {
        line.run(length, [this](instant now) {
            line.link.converse(0, first, now);
            line.link.converse(1, second, now);
        });
    }
};

} // namespace

TEST_CASE("defect: A3 a bus asks a unit that rested, and one that is silent, after any idle time")
{
    for (std::uint64_t const idle : idle_times) {
        // Nobody comes by from some moment of a rest, and of the time between two probes, on.
        for (std::uint64_t const ran : {2'000'000U, 2'100'000U, 2'200'000U, 2'300'000U, 2'400'000U}) {
            INFO("idle for " << idle << " us after " << ran << " us");
            resting_bus it;
            it.run(ran);
            REQUIRE(it.line.link.is_silent(1));
            it.line.run(idle, [](instant) {});
            unsigned const answered = it.first.answered;
            unsigned const failed = it.second.number;
            // At a tenth of the line a time-out of 104 ms is paid within 1.04 s.
            it.run(1'500'000);
            CHECK(it.first.answered >= answered + 3);
            CHECK(it.second.number > failed);
        }
    }
}
