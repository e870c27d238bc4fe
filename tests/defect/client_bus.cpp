// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// A bus is fair to every silent unit, goes on without a conversation that is gone, sleeps where there is nothing to
// do, and wakes for all its conversations.
#include "client_line.hpp"

#include "support/catch.hpp"

#include <map>
#include <optional>

#include <rtuwire/client/bus.hpp>

using namespace rtuwire;
using namespace rtuwire::detail;
using namespace rtuwire::test;

namespace {

constexpr client_options patient{.response_timeout = milliseconds(100), .retries = 1};

/// Passes at once that the turns may take behind an outcome, before the next request leaves.
constexpr unsigned few = 2;

/// A bus whose units from `first_dead` on say nothing; the others answer after 5 ms.
template <std::size_t Slots> struct office {
    scripted_line<bus<Slots>> line{bus<Slots>{office_line, patient}, office_line};
    std::vector<series> conversations{};
    std::map<unsigned, unsigned> requests{};
    std::function<bool(unsigned)> is_dead{[](unsigned) { return false; }};

    office()
    {
        for (unsigned unit = 1; unit <= Slots; ++unit) {
            conversations.emplace_back([=](unsigned) { return read_of(unit, 3201); });
        }
        line.heard = [this](frame_bytes const& frame) {
            ++requests[at(frame, 0)];
            if (at(frame, 0) != 0 and not is_dead(at(frame, 0))) {
                line.say(5'000, response_to(frame));
            }
        };
    }

    void come_by(instant now)
    {
        for (std::size_t i = 0; i < Slots; ++i) {
            line.link.converse(i, conversations[i], now);
        }
    }
    void run(std::uint64_t length)
    {
        line.run(length, [&](instant now) { come_by(now); });
    }
};

/// A conversation that asks once each period, and sleeps in between.
struct clocked : series {
    duration period;
    instant due;
    bool is_due{false};

    clocked(std::function<frame_bytes(unsigned)> maker, duration every, instant first, unsigned count = 0xFFFF'FFFF)
        : series{std::move(maker), count}, period{every}, due{first}
    {}
    void advance(instant now)
    {
        if (not is_due and reached(now, due)) {
            is_due = true;
            due = now + period;
        }
    }
    deadline poll_deadline() const { return is_due or settled() ? deadline{} : deadline{due}; }
    std::optional<request_frame> next() { return is_due ? series::next() : std::nullopt; }
    void accept(result<response> const& outcome)
    {
        is_due = false;
        series::accept(outcome);
    }
};

template <std::size_t Slots> void probes_all(unsigned first_dead)
{
    office<Slots> it;
    it.is_dead = [=](unsigned unit) { return unit >= first_dead; };
    it.run(540'000'000);
    unsigned least = 0xFFFF'FFFF;
    unsigned most = 0;
    for (unsigned unit = first_dead; unit <= Slots; ++unit) {
        least = std::min(least, it.requests[unit]);
        most = std::max(most, it.requests[unit]);
    }
    INFO(Slots << " slots, dead from unit " << first_dead << " on: " << least << " to " << most << " probes");
    CHECK(least > 0);
    CHECK(10 * least >= 8 * most);
    unsigned answered = 0;
    for (series const& each : it.conversations) {
        answered += each.answered;
    }
    CHECK(answered > 25'000);
}

} // namespace

TEST_CASE("defect: D7 every silent unit is probed")
{
    probes_all<3>(2);
    probes_all<3>(3);
    probes_all<30>(29);
    probes_all<30>(16);
    probes_all<30>(2);
}

TEST_CASE("defect: D7 a bus whose units are all silent finds each when it comes back")
{
    for (unsigned back = 1; back <= 5; ++back) {
        INFO("unit " << back);
        office<5> it;
        bool is_back = false;
        it.is_dead = [&](unsigned unit) { return not(is_back and unit == back); };
        it.run(60'000'000);
        is_back = true;
        // Five time-outs of 104 ms at a tenth of the line.
        it.run(6'000'000);
        CHECK(it.conversations[back - 1].answered > 0);
    }
}

TEST_CASE("defect: H3 silent units that may not be kept waiting do not wait for each other")
{
    office<3> all;
    for (std::size_t slot = 0; slot < 2; ++slot) {
        all.line.link.set(
            slot, {.with = {.response_timeout = milliseconds(100), .retries = 1}, .longest_gap = milliseconds(2'000)});
    }
    std::uint64_t const back = all.line.time() + 60'000'000;
    all.is_dead = [&](unsigned unit) { return unit < 3 and all.line.time() < back; };
    all.run(60'000'000);
    CHECK(all.requests[1] > 5);
    CHECK(all.requests[2] > 5);
    // They are found within what the share of the silent ones allows: ten time-outs each.
    all.run(30'000'000);
    CHECK(all.conversations[0].answered > 100);
    CHECK(all.conversations[1].answered > 100);
}

TEST_CASE("defect: H5 a silent unit that found no gap is asked when nobody needs one any more")
{
    for (std::size_t const silent : {0U, 1U}) {
        INFO("slot " << silent);
        office<2> both;
        std::size_t const live = 1 - silent;
        both.is_dead = [&](unsigned unit) { return unit == silent + 1; };
        both.line.link.set(live, {.with = {.response_timeout = milliseconds(100), .retries = 1},
                                  .longest_gap = milliseconds(200)}); // shorter than a time-out
        both.conversations[live].most = 2'000;
        both.run(60'000'000);
        CHECK(both.conversations[live].answered == 2'000);
        CHECK(both.requests[static_cast<unsigned>(silent) + 1] > 5);
        CHECK(both.line.spinning <= few);
    }
}

TEST_CASE("defect: D8 a bus with nothing to do sleeps, whatever slots are in use")
{
    for (std::size_t used = 0; used <= 5; ++used) {
        INFO(used << " of 5 slots in use");
        office<5> it;
        it.line.spinning_limit = 10'000;
        for (series& each : it.conversations) {
            each.most = 3;
        }
        it.line.run(1'000'000, [&](instant now) {
            for (std::size_t i = 0; i < used; ++i) {
                it.line.link.converse(i, it.conversations[i], now);
            }
        });
        CHECK(it.line.spinning <= few);
        CHECK(it.line.restless <= 3 * used);
        unsigned const passes = it.line.passes;
        it.line.restless = 0;
        it.line.run(60'000'000, [&](instant now) {
            for (std::size_t i = 0; i < used; ++i) {
                it.line.link.converse(i, it.conversations[i], now);
            }
        });
        CHECK(it.line.passes - passes <= 1);
        CHECK(it.line.restless == 0);
        CHECK_FALSE(it.line.link.poll_deadline());
    }
}

TEST_CASE("defect: D8 a bus whose slots pause, or are silent, sleeps until one of them has "
          "something to do")
{
    for (unsigned const dead : {0U, 1U, 3U}) {
        INFO(dead << " dead units of 3, 6 slots");
        scripted_line<bus<6>> line{bus<6>{office_line, patient}, office_line};
        line.spinning_limit = 10'000;
        unsigned requests = 0;
        line.heard = [&](frame_bytes const& frame) {
            ++requests;
            if (at(frame, 0) > dead) {
                line.say(5'000, response_to(frame));
            }
        };
        std::vector<clocked> conversations;
        for (unsigned unit = 1; unit <= 3; ++unit) {
            conversations.emplace_back([=](unsigned) { return read_of(unit, 3201); }, milliseconds(500), line.now());
        }
        line.run(60'000'000, [&](instant now) {
            for (std::size_t i = 0; i < conversations.size(); ++i) {
                line.link.converse(i, conversations[i], now);
            }
        });
        CHECK(line.spinning <= few);
        CHECK(line.restless <= few * requests);
        for (std::size_t i = dead; i < 3; ++i) {
            CHECK(conversations[i].answered > 100);
        }
        // Each byte that leaves is one pass of this line; beyond them a handful for each request.
        CHECK(line.passes < requests * (8 + 12) + 200);
    }
}

TEST_CASE("defect: D8 with a full bus and dead units no pass is asked for without reason")
{
    office<30> it;
    it.line.spinning_limit = 10'000;
    it.is_dead = [](unsigned unit) { return unit % 3 == 0; };
    it.run(60'000'000);
    CHECK(it.line.spinning <= few);
    CHECK(it.line.restless <= it.line.departures.size());
}

TEST_CASE("defect: D9 a slot that is dropped with its request under way does not stop the others")
{
    for (bool const answers : {true, false}) {
        for (bool const is_replaced : {true, false}) {
            for (std::uint64_t dropped = 0; dropped <= 20'000; dropped += 1'000) {
                INFO((answers ? "unit answers, " : "unit is dead, ")
                     << (is_replaced ? "replaced, " : "gone, ") << "dropped after " << dropped << " us");
                office<3> it;
                it.is_dead = [&](unsigned unit) { return unit == 1 and not answers; };
                bool is_dropped = false;
                series another{[](unsigned) { return read_of(1, 8601); }};
                it.line.run(30'000'000, [&](instant now) {
                    if (not it.line.departures.empty()) {
                        it.line.alarm = it.line.departures[0].begin + dropped;
                        is_dropped = is_dropped or it.line.time() >= it.line.alarm;
                    }
                    if (not is_dropped) {
                        it.line.link.converse(0, it.conversations[0], now);
                    } else if (is_replaced) {
                        it.line.link.converse(0, another, now);
                    }
                    it.line.link.converse(1, it.conversations[1], now);
                    it.line.link.converse(2, it.conversations[2], now);
                });
                REQUIRE(is_dropped);
                CHECK(it.conversations[1].answered > 400);
                CHECK(it.conversations[2].answered > 400);
                CHECK(it.line.spinning <= few);
                if (is_replaced and answers) {
                    CHECK(another.answered > 400);
                    CHECK(it.conversations[0].number <= 1);
                }
            }
        }
    }
}

TEST_CASE("defect: D9 the urgent conversation may be dropped with its request under way")
{
    for (std::uint64_t dropped = 0; dropped <= 120'000; dropped += 6'000) {
        INFO("dropped after " << dropped << " us");
        office<2> it;
        series everyone{[](unsigned) { return write_of(0, 8501, 0); }, 1};
        bool is_dropped = false;
        it.line.run(30'000'000, [&](instant now) {
            if (not it.line.departures.empty()) {
                it.line.alarm = it.line.departures[0].begin + dropped;
                is_dropped = is_dropped or it.line.time() >= it.line.alarm;
            }
            if (not is_dropped) {
                it.line.link.run_urgent(everyone, now);
            }
            it.come_by(now);
        });
        REQUIRE(is_dropped);
        REQUIRE(it.line.departures[0].frame == write_of(0, 8501, 0));
        CHECK(it.conversations[0].answered > 600);
        CHECK(it.conversations[1].answered > 600);
    }
}

TEST_CASE("defect: D10 the urgent conversation's own deadline wakes the bus")
{
    for (bool const others : {false, true}) {
        INFO((others ? "with" : "without") << " conversations that are over");
        office<3> it;
        it.line.spinning_limit = 10'000;
        for (series& each : it.conversations) {
            each.most = 1;
        }
        std::uint64_t const start = it.line.time();
        clocked urgent{[](unsigned) { return write_of(0, 8501, 0); }, milliseconds(700),
                       it.line.now() + milliseconds(300), 5};
        it.line.run(10'000'000, [&](instant now) {
            it.line.link.run_urgent(urgent, now);
            if (others) {
                it.come_by(now);
            }
        });
        CHECK(urgent.number == 5);
        CHECK(it.line.restless <= 1); // the pass behind its end, in which it might have been begun anew
        std::size_t seen = 0;
        for (departure const& each : it.line.departures) {
            if (each.frame == write_of(0, 8501, 0)) {
                std::uint64_t const due = start + 300'000 + 700'000 * seen;
                CHECK(each.begin >= due);
                CHECK(each.begin <= due + 5'000);
                ++seen;
            }
        }
        CHECK(seen == 5);
    }
}
