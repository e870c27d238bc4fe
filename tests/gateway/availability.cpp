// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// How soon it is told that a device has fallen silent or is back, in simulated time, whatever the moment: held against sums of
// what a line does in between.
#include <algorithm>
#include <optional>

#include "support/catch.hpp"

#include "gateway/timed_line.hpp"

using namespace gateway_test;

namespace {

using duration = asked_line::clock::duration;

constexpr duration at_latest = 3s;

/// The device that is looked at, 0, and others; with the time-outs of a serial line and of its only repetition.
struct looked_at : rounds_on_line {
    explicit looked_at(double every, std::size_t others = 0, unsigned retries = 1)
        : rounds_on_line{[&] {
              line_plan one = plan_of(1 + others);
              one.choices.retries = retries;
              for (device_value& each : one.devices[0].values) {
                  each.every = every;
              }
              return one;
          }()}
    {
        line.timeout = 500ms;
        line.tries = 1 + retries;
        line.response = 20ms;
    }

    /// From now on.
    duration until_it_is(bool is_available)
    {
        auto const since = line.now();
        while (board.device(0)->is_available != is_available and line.now() - since < 60s) {
            rounds.step();
        }
        return line.now() - since;
    }
};

/// The longest, over moments that lie everywhere in a period.
struct longest_times {
    duration silent{0};
    duration back{0};

    template <typename Make> longest_times(duration period, Make make, std::optional<std::size_t> dead = {})
    {
        for (duration phase{0}; phase < period; phase += period / 41) {
            looked_at on = make();
            if (dead) {
                on.line.units[*dead].is_there = false;
            }
            on.run_for(30s);
            REQUIRE(on.board.device(0)->is_available);
            on.run_for(phase);
            on.line.units[0].is_there = false;
            silent = std::max(silent, on.until_it_is(false));
            on.run_for(20s + phase * 7);
            on.line.units[0].is_there = true;
            back = std::max(back, on.until_it_is(true));
        }
    }
};

} // namespace

TEST_CASE("a device that falls silent, or is back, is told within 3 s")
{
    for (std::size_t const others : {0U, 1U, 20U}) {
        for (double const every : {0.2, 1.0}) {
            for (unsigned const retries : {0U, 1U}) {
                CAPTURE(others, every, retries);
                longest_times const all{2s, [&] { return looked_at{every, others, retries}; }};
                CHECK(all.silent <= at_latest);
                CHECK(all.back <= at_latest);
                // What is read once a second is not missed at once.
                CHECK(all.silent >= 1s);
                duration const round = (1 + others) * 20ms;
                duration const period = std::chrono::duration_cast<duration>(std::chrono::duration<double>{every});
                CHECK(all.silent <= period + round + 2 * 500ms + 50ms);
            }
        }
    }
}

TEST_CASE("so it is where another device is silent already")
{
    longest_times const all{3s, [] { return looked_at{1.0, 20}; }, 7};
    CHECK(all.silent <= at_latest);
    // Both have their turns, between which the line is the others' for 2 s.
    CHECK(all.back <= 2 * (2s + 500ms) + 500ms);
}

TEST_CASE("devices that are back at the same moment are told as back together, within 3 s")
{
    duration longest{0};
    for (duration phase{0}; phase < 10s; phase += 241ms) {
        looked_at on{1.0, 5};
        on.run_for(30s);
        auto const have_all = [&](bool are_there) {
            for (std::size_t i = 0; i < 5; ++i) {
                on.line.units[i].is_there = are_there;
            }
        };
        have_all(false); // and the sixth stays
        on.run_for(20s + phase);
        have_all(true);
        auto const since = on.line.now();
        auto const are_all_back = [&] {
            bool are_back = true;
            for (std::size_t i = 0; i < 5; ++i) {
                are_back = are_back and on.board.device(i)->is_available;
            }
            return are_back;
        };
        while (not are_all_back() and on.line.now() - since < 60s) {
            on.rounds.step();
        }
        longest = std::max(longest, on.line.now() - since);
    }
    CHECK(longest <= at_latest);
    CHECK(longest >= 1s); // away ones are not asked all the time
}

TEST_CASE("a device that is read every 10 s is missed when it is read next, and told as back within 3 s")
{
    longest_times const all{10s, [] { return looked_at{10.0, 3}; }};
    CHECK(all.silent <= 10s + at_latest - 1s);
    CHECK(all.silent >= 10s);
    CHECK(all.back <= at_latest);
}

TEST_CASE("a device that falls silent while it is read is told within 3 s, and is not taken for one that has a hole")
{
    looked_at on{1.0, 3};
    on.run_for(5s);
    on.line.units[0].falls_silent = true;
    while (on.line.units[0].is_there) {
        on.rounds.step();
    }
    CHECK(on.until_it_is(false) <= at_latest - 1s); // the first second went with its own time-outs
}

TEST_CASE("a device that comes and goes fills no log, and none of its values is old")
{
    for (duration const half : {300ms, 700ms, 1'100ms, 2'300ms}) {
        looked_at on{1.0, 1};
        on.run_for(5s);
        static_cast<void>(on.board.take_events());
        unsigned told = 0;
        for (unsigned minutes = 0; minutes < 10; ++minutes) {
            unsigned lost = 0;
            for (auto const end = on.line.now() + 60s; on.line.now() < end;) {
                on.line.units[0].is_there = not on.line.units[0].is_there;
                on.line.units[0].held += 1;
                on.run_for(half);
                lost += on.count(event_kind::device_silent);
                slot_value const value = on.board.device(0)->values[0];
                if (value.state == value_state::valid) {
                    // Of its own round, at which the device was there.
                    CHECK(on.line.unix_time() - value.time <= 4'000'000);
                }
            }
            told = std::max(told, lost);
        }
        CAPTURE(half.count(), told);
        // Of losses in a minute the third takes two rounds of a second, the fourth three: eleven are 1 + 1 + 2 + ... + 10.
        CHECK(told <= 12);
    }
}

TEST_CASE("behind a quiet minute a device is missed as soon as ever")
{
    looked_at on{1.0};
    for (unsigned i = 0; i < 6; ++i) {
        on.run_for(5s);
        on.line.units[0].is_there = false;
        on.run_for(10s);
        on.line.units[0].is_there = true;
    }
    on.run_for(61s);
    on.line.units[0].is_there = false;
    CHECK(on.until_it_is(false) <= at_latest);
}
