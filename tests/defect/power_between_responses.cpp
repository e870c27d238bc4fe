// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// A drive that loses its power and has it back between two requests, so that no response is missing. An ATV320 comes back in
// its saved I/O profile, with a reference at its terminals, where each word with bit 0 runs it. It may turn until that was
// read; no word keeps it turning.
#include "defect/powered_drive.hpp"
#include "support/catch.hpp"

#include <cstdint>

#include <rtuwire/altivar/atv320.hpp>
#include <rtuwire/altivar/cyclic/cyclic.hpp>
#include <rtuwire/altivar/procedure/motion/start.hpp>
#include <rtuwire/altivar/procedure/motion/stop.hpp>

using namespace rtuwire;
using namespace rtuwire::detail;
using namespace rtuwire::altivar;

namespace {

/// The drive, and how long it turned from the last loss of it on.
struct cut_off : test::taken_over {
    std::uint32_t turning_ms{0};

    /// An end by halt keeps the power.
    bool turns() { return drive().motor().frequency() != 0; }

    void lose_power()
    {
        drive().power_cycle(now());
        turning_ms = 0;
    }
    template <typename Conversation> void go_on(Conversation& whom, std::uint32_t for_ms)
    {
        for (std::uint32_t at = 0; at < for_ms; at += 5) {
            pass(whom, milliseconds(5));
            turning_ms += turns() ? 5U : 0U;
        }
    }
};

constexpr std::uint32_t longest_run_ms = 400;            ///< some exchanges, and a look
constexpr std::uint32_t longest_run_of_cycle_ms = 2'300; ///< ten exchanges, and its ramp

} // namespace

TEST_CASE("defect: no start keeps a drive turning that lost its power between two of its requests")
{
    unsigned cut = 0;
    for (std::uint32_t after_ms = 0; after_ms < 600; after_ms += 5) {
        cut_off it;
        start go{it.drive_at, 30_Hz};
        it.go_on(go, after_ms);
        if (go.settled()) {
            break;
        }
        INFO("without power after " << after_ms << " ms");
        it.lose_power();
        it.go_on(go, 40'000); // in the I/O profile no word leads out of "switched on"
        CHECK(go.settled());
        CHECK_FALSE(it.turns());
        CHECK(it.turning_ms < longest_run_ms);
        ++cut;
    }
    CHECK(cut > 30);
}

TEST_CASE("defect: no stop keeps a drive turning that lost its power between two of its words")
{
    for (stop_by const how : {stop_by::ramp, stop_by::quick_stop, stop_by::halt}) {
        for (std::uint32_t after_ms = 0; after_ms < 2'400; after_ms += 15) {
            cut_off it;
            start go{it.drive_at, 30_Hz};
            it.finish(go);
            REQUIRE(go.running());
            it.poll(milliseconds(3'000), milliseconds(300));
            stop rest{it.drive_at, how};
            it.go_on(rest, after_ms);
            if (rest.settled()) {
                break;
            }
            INFO("stop " << static_cast<int>(how) << ", without power after " << after_ms << " ms");
            it.lose_power();
            it.go_on(rest, 40'000);
            CHECK(rest.settled());
            CHECK_FALSE(it.turns());
            CHECK(it.turning_ms < longest_run_ms);
        }
    }
}

TEST_CASE("defect: no stop of a cycle keeps a drive turning that lost its power between two of its words")
{
    for (stop_by const how : {stop_by::ramp, stop_by::quick_stop, stop_by::halt}) {
        for (std::uint32_t after_ms = 0; after_ms < 1'500; after_ms += 15) {
            cut_off it;
            cyclic<atv320::device> loop{it.drive_at};
            it.go_on(loop, 2'000);
            REQUIRE(loop.run(900_rpm));
            it.go_on(loop, 3'000);
            REQUIRE(loop.control().is_running());
            loop.stop(how);
            it.go_on(loop, after_ms);
            INFO("stop " << static_cast<int>(how) << ", without power after " << after_ms << " ms");
            it.lose_power();
            it.go_on(loop, 8'000);
            CHECK_FALSE(it.turns());
            CHECK(it.turning_ms < longest_run_ms);
        }
    }
}

TEST_CASE("defect: no cycle goes on behind a loss of power between two of its exchanges")
{
    for (bool const by_function_23 : {true, false}) {
        for (std::uint32_t after_ms = 0; after_ms < 700; after_ms += 5) {
            cut_off it;
            cyclic<atv320::device> loop{it.drive_at, {.by_function_23 = by_function_23}};
            it.go_on(loop, 2'000);
            REQUIRE(loop.run(900_rpm));
            it.go_on(loop, after_ms);
            INFO((by_function_23 ? "function 23" : "functions 3 and 16")
                 << ", without power after " << after_ms << " ms");
            it.lose_power();
            it.go_on(loop, 4'000);
            CHECK_FALSE(loop.control().is_ordered());
            CHECK_FALSE(it.turns());
            CHECK(it.turning_ms < longest_run_of_cycle_ms);
        }
    }
}

TEST_CASE("defect: a slow cycle does not go on behind a loss of power between two of its exchanges")
{
    for (std::uint32_t after_ms = 0; after_ms < 2'100; after_ms += 50) {
        cut_off it;
        cyclic<atv320::device> loop{it.drive_at,
                                    {.period = milliseconds(2'000), .enable_timeout = milliseconds(20'000)}};
        it.go_on(loop, 5'000);
        REQUIRE(loop.run(900_rpm));
        it.go_on(loop, 14'000 + after_ms);
        REQUIRE(loop.control().is_running());
        INFO("without power after " << after_ms << " ms");
        it.lose_power();
        it.go_on(loop, 6'000);
        CHECK_FALSE(loop.control().is_ordered());
        CHECK(it.turning_ms == 0); // it was read before any word
    }
}

TEST_CASE("defect: a cycle orders nothing behind a loss of power without another check")
{
    cut_off it;
    cyclic<atv320::device> loop{it.drive_at};
    it.go_on(loop, 2'000);
    REQUIRE(loop.run(900_rpm));
    it.go_on(loop, 3'000);
    it.lose_power();
    it.go_on(loop, 2'000);
    CHECK_FALSE(loop.run(900_rpm)); // its words are those of the I/O profile
    it.go_on(loop, 2'000);
    CHECK_FALSE(it.turns());
}
