// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Which orders to move a motor a client takes: docs/engine-rules.md, rules 35 and 36, sentence by sentence.
#include "client/command_desk.hpp"

#include "support/catch.hpp"

using namespace rtuwire;
using namespace rtuwire::test;

TEST_CASE("rule 35: a unit is ordered from a request that enables or resets until its rest was read")
{
    for (effect const what : {effect::enabling, effect::resetting}) {
        command_desk<2> it;
        hand_commander one{3};
        one.note_order();
        CHECK_FALSE(it.is_ordered(3));
        REQUIRE(it.does(one, what) == errc::none);
        CHECK(it.is_ordered(3));
        CHECK_FALSE(it.is_ordered(4));
        CHECK(it.does(one, effect::stopping) == errc::none);
        CHECK(it.is_ordered(3)); // a word is no proof
        one.note_power(power_seen::off);
        it.see(one);
        CHECK_FALSE(it.is_ordered(3));
        CHECK(it.does(one, what) == errc::none); // the same order goes on
        CHECK(it.is_ordered(3));
    }
}

TEST_CASE("rule 35: where all places are taken by ordered units another one is not ordered, and is later")
{
    command_desk<2> it;
    hand_commander one{3}, two{4}, three{5};
    CHECK(it.runs(one) == errc::none);
    CHECK(it.runs(two) == errc::none);
    CHECK(it.runs(three) == errc::too_many_ordered);
    CHECK_FALSE(it.is_ordered(5));
    two.note_power(power_seen::off);
    it.see(two);
    CHECK(it.does(three, effect::enabling) == errc::none);
    CHECK((it.is_ordered(3) and it.is_ordered(5)));
    CHECK(it.runs(two) == errc::too_many_ordered);
}

TEST_CASE("rule 36: an order that is older than a stop of its unit moves nothing, a newer one does")
{
    command_desk<2> it;
    hand_commander one{3}, other{3}, apart{4};
    REQUIRE(it.runs(one) == errc::none);
    REQUIRE(it.runs(apart) == errc::none);
    other.note_stop();
    REQUIRE(it.does(other, effect::stopping) == errc::none);
    CHECK(it.does(one, effect::enabling) == errc::overruled);
    CHECK(it.does(one, effect::resetting) == errc::overruled);
    other.note_stop_over();
    it.see(other);
    it.pass(1);
    CHECK(it.does(one, effect::enabling) == errc::overruled);
    CHECK(it.does(one, effect::resetting) == errc::overruled);
    CHECK(it.does(apart, effect::enabling) == errc::none);
    CHECK(it.runs(one) == errc::none);
}

TEST_CASE("rule 36: an order to one copy of a client that was never used moves nothing through another copy")
{
    static constexpr orders<1> unused{};
    static constinit orders<1> one{unused}, other{unused};
    hand_commander who{3};
    who.note_order_to_run();
    one.take_note_of(who, instant{1});
    CHECK(one.check(who, effect::enabling) == errc::none);
    other.take_note_of(who, instant{2});
    CHECK(other.check(who, effect::enabling) == errc::overruled);
}

TEST_CASE("rule 36: an order that was given before its commander saw a stop, a loss or a fault is "
          "older than it")
{
    enum class event { none, stop, fault, everyone };
    for (event const what : {event::none, event::stop, event::fault, event::everyone}) {
        INFO(static_cast<int>(what));
        command_desk<2> it;
        hand_commander one{3}, other{3};
        hand_for_all all{9};
        it.see(one);
        if (what == event::stop) {
            other.note_stop();
            it.see(other);
            other.note_stop_over();
        } else if (what == event::fault) {
            other.note_fault();
        } else if (what == event::everyone) {
            all.note_stop();
            it.see(all);
            all.note_stop_over();
            it.see(all);
        }
        it.see(other);
        it.pass(what == event::everyone or what == event::stop ? 1 : 0);
        errc const expected = what == event::none ? errc::none : errc::overruled;
        CHECK(it.runs(one) == expected);
        CHECK(it.runs(one) == errc::none); // it has seen it now
    }
}

TEST_CASE("rule 36: of two orders to run the later one counts, and an order that was refused "
          "replaces none")
{
    command_desk<2> it;
    hand_commander one{3}, two{3};
    REQUIRE(it.runs(one) == errc::none);
    REQUIRE(it.runs(two) == errc::none);
    CHECK(it.does(one, effect::enabling) == errc::overruled);
    CHECK(it.does(one, effect::resetting) == errc::none); // which is no order to run
    one.note_order();
    CHECK(it.does(one, effect::enabling) == errc::none);
    CHECK(it.does(two, effect::enabling) == errc::none); // one did not order to run this time
    two.note_fault();
    it.see(two);
    CHECK(it.runs(one) == errc::overruled); // given before it saw the fault
    CHECK(it.runs(two) == errc::none);
    one.note_order();
    CHECK(it.does(one, effect::resetting) == errc::none);
    CHECK(it.does(two, effect::enabling) == errc::none);
}

TEST_CASE("rule 36: an order to do something else than to run replaces none, also the first of its "
          "commander")
{
    command_desk<2> it;
    hand_commander one{3}, two{3};
    REQUIRE(it.runs(one) == errc::none);
    two.note_order();
    REQUIRE(it.does(two, effect::resetting) == errc::none);
    CHECK(it.does(one, effect::enabling) == errc::none);
}

TEST_CASE("rule 36: a fault that was read takes older orders to enable, not one to reset it")
{
    command_desk<2> it;
    hand_commander one{3}, other{3};
    REQUIRE(it.runs(one) == errc::none);
    other.note_fault();
    it.see(other);
    CHECK(it.does(one, effect::enabling) == errc::overruled);
    CHECK(it.does(one, effect::resetting) == errc::none);
    CHECK(it.runs(one) == errc::none);
    it.see(other); // told once
    CHECK(it.does(one, effect::enabling) == errc::none);
}

TEST_CASE("who came by before another read a fault knows of it until that is heeded, and who is new "
          "knows of none")
{
    command_desk<2> it;
    hand_commander one{3}, other{3}, late{3};
    CHECK_FALSE(one.was_stopped());
    it.see(one);
    CHECK_FALSE(one.was_stopped());
    other.note_fault();
    it.see(other);
    for (unsigned pass = 0; pass < 2; ++pass) {
        it.see(one);
        CHECK(one.was_stopped());
    }
    one.heed_stop();
    it.see(one);
    CHECK_FALSE(one.was_stopped());
    it.see(late);
    CHECK_FALSE(late.was_stopped());
}

TEST_CASE("rule 36: nothing is enabled without an order where a fault, a loss or another order came")
{
    for (unsigned const what : {0U, 1U, 2U, 3U}) {
        INFO(what);
        command_desk<1> it;
        hand_commander none{3}, other{3};
        if (what == 1) {
            other.note_fault();
            it.see(other);
        } else if (what == 2) {
            REQUIRE(it.runs(other) == errc::none);
        } else if (what == 3) {
            REQUIRE(it.misses(other, effect::resetting) != 0);
            REQUIRE(it.is_lost(3));
            REQUIRE(it.does(other, effect::stopping) == errc::none);
        }
        errc const expected = what == 0 ? errc::none : what == 3 ? errc::unit_lost : errc::overruled;
        CHECK(it.does(none, effect::enabling) == expected);
        CHECK(it.does(none, effect::enabling) == expected);
    }
}

TEST_CASE("rule 36: who came by before another rearranged its unit moves nothing until it has noted it")
{
    command_desk<1> it;
    hand_commander one{3}, other{3}, late{3};
    it.see(one);
    other.note_order();
    REQUIRE(it.does(other, effect::rearranging) == errc::none);
    CHECK(it.runs(one) == errc::overruled);
    one.note_order();
    CHECK(it.does(one, effect::resetting) == errc::overruled);
    one.note_arrangement();
    CHECK(it.does(one, effect::resetting) == errc::none);
    CHECK(it.does(one, effect::enabling) == errc::none);
    CHECK(it.runs(late) == errc::none);                            // which has read nothing before
    CHECK(it.does(other, effect::rearranging) == errc::overruled); // of a drive that stands alone
}

TEST_CASE("rule 36: a unit that lost its place is overruled, or was rearranged, as before")
{
    for (unsigned const what : {0U, 1U, 2U, 3U}) {
        INFO(what);
        command_desk<1> it;
        hand_commander one{3}, other{3}, apart{4};
        REQUIRE(it.runs(one) == errc::none);
        if (what == 1) {
            other.note_stop();
            it.see(other);
            other.note_stop_over();
        } else if (what == 2) {
            other.note_fault();
        }
        it.see(other);
        it.pass(1);
        other.note_power(power_seen::off);
        it.see(other);
        other.note_order();
        if (what == 3) {
            REQUIRE(it.does(other, effect::rearranging) == errc::none);
        }
        REQUIRE(it.runs(apart) == errc::none);
        REQUIRE_FALSE(it.is_ordered(3));
        apart.note_power(power_seen::off);
        it.see(apart);
        it.see(one);
        CHECK(it.does(one, effect::enabling) == (what == 0 ? errc::none : errc::overruled));
    }
}
