// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// How many requests a unit may leave unanswered before it counts as lost: docs/engine-rules.md, rule 40.
#include "client/command_desk.hpp"

#include "support/catch.hpp"

using namespace rtuwire;
using namespace rtuwire::test;

TEST_CASE("rule 40: a unit is lost by the first miss beyond those in a row that its commander tolerates")
{
    for (std::uint8_t tolerated = 0; tolerated < 3; ++tolerated) {
        INFO(unsigned{tolerated});
        command_desk<1> it;
        hand_commander one{3, tolerated};
        REQUIRE(it.runs(one) == errc::none);
        for (unsigned round = 0; round < 2; ++round) {
            for (unsigned i = 0; i < tolerated; ++i) {
                REQUIRE(it.misses(one, effect::enabling) != 0);
                CHECK(one.told == errc::timed_out);
                CHECK_FALSE(it.is_lost(3));
            }
            CHECK(it.does(one, effect::none) == errc::none); // a response to anything begins anew
            one.note_power(power_seen::off);
            it.see(one);
            REQUIRE(it.does(one, effect::resetting) == errc::none);
        }
        for (unsigned i = 0; i < tolerated; ++i) {
            REQUIRE(it.misses(one, effect::none) != 0);
        }
        CHECK(one.losses == 0);
        REQUIRE(it.misses(one, effect::enabling) != 0);
        CHECK(it.is_lost(3));
        CHECK(one.losses == 1);
    }
}

TEST_CASE("rule 40: misses before the rest was read are not counted behind it")
{
    command_desk<1> it;
    hand_commander one{3, 1};
    REQUIRE(it.runs(one) == errc::none);
    one.note_power(power_seen::off);
    it.see(one);
    REQUIRE(it.misses(one, effect::enabling) != 0);
    CHECK_FALSE(it.is_lost(3));
}

TEST_CASE("rule 40: a request that was repeated counts as a loss at once, and so does any miss behind it")
{
    command_desk<1> it{{.response_timeout = milliseconds(100), .late_response = {}, .retries = 1}};
    hand_commander one{3, 3};
    REQUIRE(it.runs(one) == errc::none);
    one.again = repetition::allowed;
    REQUIRE(it.says(one, effect::none));
    it.fail(one);
    REQUIRE(it.leaves());
    CHECK_FALSE(it.is_lost(3));
    it.fail(one);
    REQUIRE(one.told == errc::timed_out);
    CHECK(it.is_lost(3));
    it.pass(500'000);
    REQUIRE(it.misses(one, effect::stopping) != 0); // without a repetition
    CHECK(one.told == errc::timed_out);
    std::uint64_t const last = it.time;
    it.pass_until(last + 6'000'000 - 1); // the drive's time-out of 5 s, and 1 s
    CHECK(it.is_lost(3));
    it.pass(1);
    CHECK_FALSE(it.is_lost(3));
}
