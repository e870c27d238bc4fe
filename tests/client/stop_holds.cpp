// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Which stop holds which unit, and from when to when: docs/engine-rules.md, rules 36 to 38.
#include "client/command_desk.hpp"

#include "support/catch.hpp"

using namespace rtuwire;
using namespace rtuwire::test;

namespace {

template <typename Desk, typename Conversation> void end(Desk& it, Conversation& stop)
{
    stop.note_stop_over();
    it.see(stop);
    it.pass(1);
}

template <typename Desk, typename Conversation> void begin(Desk& it, Conversation& stop)
{
    stop.note_stop();
    it.see(stop);
}

} // namespace

TEST_CASE("rule 37: while a stop holds its unit no order to it counts, and behind its end every "
          "new one does")
{
    command_desk<2> it;
    hand_commander stop{3}, other{4}, one{3}, apart{4};
    begin(it, stop);
    begin(it, other);
    CHECK(it.runs(one) == errc::overruled);
    CHECK(it.does(stop, effect::stopping) == errc::none);
    end(it, other);
    CHECK(it.runs(apart) == errc::none); // one unit's end is its own
    for (unsigned pass = 0; pass < 3; ++pass) {
        it.see(stop);
        CHECK(it.runs(one) == errc::overruled);
        one.note_order();
        CHECK(it.does(one, effect::rearranging) == errc::overruled);
        it.pass(1);
    }
    end(it, stop);
    CHECK(it.does(one, effect::enabling) == errc::overruled); // ordered while it was held
    CHECK(it.runs(one) == errc::none);
    for (unsigned pass = 0; pass < 3; ++pass) {
        it.see(stop); // over and still here
        it.pass(1);
        CHECK(it.does(one, effect::enabling) == errc::none);
    }
    CHECK(it.does(stop, effect::stopping) == errc::none);
    CHECK(it.does(one, effect::stopping) == errc::none); // held by nobody
}

TEST_CASE("rule 37: another stop's words are refused while a later one holds the unit")
{
    for (bool const is_everyone : {false, true}) { // everyone's stop beside them changes nothing
        command_desk<1> it;
        hand_commander old{3}, late{3}, bare{3};
        hand_for_all all{9};
        begin(it, old);
        begin(it, late);
        if (is_everyone) {
            begin(it, all);
        }
        it.see(old);
        CHECK(it.does(old, effect::stopping) == errc::overruled);
        CHECK(it.does(bare, effect::stopping) == errc::overruled);
        CHECK(it.does(late, effect::stopping) == errc::none);
        end(it, old);
        CHECK(it.does(old, effect::stopping) == errc::overruled);
        end(it, late);
        CHECK(it.does(old, effect::stopping) == errc::none);
        CHECK(it.does(bare, effect::stopping) == errc::none);
    }
}

TEST_CASE("rule 37: a stop that is gone holds on until another one has ended, or release")
{
    for (bool const is_released : {false, true}) {
        command_desk<1> it;
        hand_commander one{3}, other{3};
        {
            hand_commander stop{3};
            begin(it, stop);
        }
        it.pass(60'000'000);
        CHECK(it.runs(one) == errc::overruled);
        if (is_released) {
            it.link.motor_orders().release(3);
        } else {
            begin(it, other);
            end(it, other);
        }
        CHECK(it.does(one, effect::enabling) == errc::overruled);
        CHECK(it.runs(one) == errc::none);
    }
}

TEST_CASE("rule 37: a stop of everyone that is gone holds all units until release_all, behind "
          "which no older order counts")
{
    for (bool const has_place : {false, true}) {
        command_desk<1> it;
        hand_commander one{3};
        {
            hand_for_all all{9};
            begin(it, all);
        }
        it.pass(60'000'000);
        if (has_place) {
            CHECK(it.runs(one) == errc::overruled);
        } else {
            one.note_order();
            CHECK(it.does(one, effect::resetting) == errc::overruled);
        }
        it.link.motor_orders().release_all();
        CHECK(it.does(one, effect::resetting) == errc::overruled);
        CHECK(it.does(one, effect::enabling) == errc::overruled);
        CHECK(it.runs(one) == errc::none);
    }
}

TEST_CASE("rule 37: a stop of everyone is told of the ordered unit that it does not stop, and what its words mean")
{
    for (unsigned const listed : {3U, 9U}) {
        for (bool const is_confirmed : {false, true}) {
            command_desk<1> it;
            hand_commander one{3};
            REQUIRE(it.runs(one) == errc::none);
            if (is_confirmed) {
                one.note_meaning(8'501);
                it.see(one);
            }
            hand_for_all all{listed};
            begin(it, all);
            REQUIRE(it.says(all));
            CHECK(all.unlisted.size() == (listed == 3 ? 0U : 1U));
            for (unsigned const word : all.unlisted) {
                CHECK(word == (is_confirmed ? 8'501U : 0U));
            }
        }
    }
}

TEST_CASE("rule 37: a stop of everyone under way holds again behind release_all, as often as that is called")
{
    command_desk<1> it;
    hand_commander one{3};
    hand_for_all all{9};
    begin(it, all);
    for (unsigned pass = 0; pass < 3; ++pass) {
        it.link.motor_orders().release_all();
        it.see(all);
        CHECK(it.runs(one) == errc::overruled);
        it.pass(1);
    }
    end(it, all);
    it.see(all); // over and still here
    it.see(one);
    CHECK(it.runs(one) == errc::none);
}

TEST_CASE("rule 37: a stop of everyone holds all units behind the end of another one, up to its own")
{
    for (bool const sees_the_end : {false, true}) { // it visits in a pass behind the other one, or before it
        command_desk<1> it;
        hand_commander one{3};
        hand_for_all all{9}, other{10};
        begin(it, all);
        begin(it, other);
        it.pass(1);
        if (not sees_the_end) {
            it.see(all);
        }
        other.note_stop_over();
        it.see(other);
        if (sees_the_end) {
            it.see(all);
        }
        it.pass(1);
        for (unsigned pass = 0; pass < 3; ++pass) {
            CHECK(it.runs(one) == errc::overruled); // it visits before the stop
            it.see(all);
            it.pass(1);
        }
        end(it, all);
        it.see(one);
        CHECK(it.runs(one) == errc::none);
    }
}

TEST_CASE("rule 37: a stop of everyone that is gone holds nothing behind the end of another one")
{
    command_desk<1> it;
    hand_commander one{3};
    hand_for_all all{9}, other{10};
    begin(it, all);
    begin(it, other);
    it.see(all);
    it.pass(1);
    it.see(other); // from here on `all` is gone
    it.pass(1);
    end(it, other);
    CHECK(it.runs(one) == errc::none);
}

TEST_CASE("rule 38: what was taken for a unit and has not left does not leave once a stop of it has begun by a read")
{
    for (unsigned const stopped : {3U, 4U}) {
        command_desk<1> it;
        hand_commander one{3}, stop{stopped};
        one.note_order_to_run();
        one.wanted = effect::enabling;
        one.has_request = true;
        it.link.converse(one, it.now());
        begin(it, stop);
        CHECK(it.leaves() == (stopped == 4));
        it.see(one);
        CHECK((one.told == errc::overruled) == (stopped == 3));
    }
}

TEST_CASE("rule 36: an order whose place was another unit's meanwhile ends by its unit's own time-out, too")
{
    command_desk<1> it;
    hand_commander one{3};
    std::array<hand_commander, 3> others{hand_commander{4}, hand_commander{5}, hand_commander{6}};
    one.note_order_to_run();
    it.see(one);
    for (hand_commander& other : others) { // there are two places
        other.note_meaning(8'501);
        it.see(other);
    }
    REQUIRE(it.does(one, effect::enabling) == errc::none);
    CHECK(one.is_in_force());
    it.pass(4'900'000);
    it.see(one);
    CHECK(one.is_in_force());
    it.pass(2'000'000);
    it.see(one);
    CHECK_FALSE(one.is_in_force());
}

TEST_CASE("rule 37: a release of what no stop holds takes no order away")
{
    for (bool const is_for_all : {false, true}) {
        for (bool const has_ended : {false, true}) {
            command_desk<1> it;
            hand_commander one{3};
            if (has_ended) {
                hand_commander stop{3};
                begin(it, stop);
                end(it, stop);
            }
            REQUIRE(it.runs(one) == errc::none);
            if (is_for_all) {
                it.link.motor_orders().release_all();
            } else {
                it.link.motor_orders().release(3);
            }
            CHECK(it.does(one, effect::enabling) == errc::none);
        }
    }
}

TEST_CASE("rule 37: a stop that comes by holds its unit again behind a release")
{
    for (bool const is_for_all : {false, true}) {
        command_desk<1> it;
        hand_commander stop{3}, one{3};
        begin(it, stop);
        if (is_for_all) {
            it.link.motor_orders().release_all();
        } else {
            it.link.motor_orders().release(3);
        }
        it.see(stop);
        CHECK(it.runs(one) == errc::overruled);
        CHECK(it.does(stop, effect::stopping) == errc::none);
        end(it, stop);
        it.see(stop);
        it.see(one); // an order counts as older than what its commander has not seen
        CHECK(it.runs(one) == errc::none);
    }
}

TEST_CASE("rule 37: everyone's stop holds all units up to its end, and takes no order that comes "
          "behind it")
{
    command_desk<2> it;
    hand_commander one{3}, apart{4};
    hand_for_all idle{9}, all{9};
    REQUIRE(it.runs(one) == errc::none);
    it.see(idle); // which stops nobody
    it.pass(1);
    CHECK(it.does(one, effect::enabling) == errc::none);
    begin(it, all);
    for (unsigned pass = 0; pass < 3; ++pass) {
        CHECK(it.does(one, effect::enabling) == errc::overruled);
        CHECK(it.runs(one) == errc::overruled);
        CHECK(it.runs(apart) == errc::overruled);
        CHECK(it.does(one, effect::stopping) == errc::none);
        it.see(all);
        it.pass(1);
    }
    end(it, all);
    CHECK(it.does(one, effect::enabling) == errc::overruled);
    CHECK(it.runs(one) == errc::none);
    for (unsigned pass = 0; pass < 3; ++pass) {
        it.see(all);
        it.pass(1);
        CHECK(it.does(one, effect::enabling) == errc::none);
    }
    begin(it, all); // once more
    it.pass(1);
    CHECK(it.runs(one) == errc::overruled);
}

TEST_CASE("rule 37: where a unit has no place its stop holds all that have none, and gets the next place")
{
    command_desk<1> it;
    hand_commander one{3}, stop{4}, again{4}, apart{5};
    REQUIRE(it.runs(one) == errc::none);
    begin(it, stop);
    CHECK(it.does(one, effect::enabling) == errc::none); // it has its place
    CHECK(it.does(again, effect::enabling) == errc::overruled);
    CHECK(it.does(apart, effect::enabling) == errc::overruled);
    CHECK(it.does(stop, effect::stopping) == errc::none);
    CHECK(it.does(apart, effect::stopping) == errc::none); // nobody knows whose unit is held
    one.note_power(power_seen::off);
    it.see(one);
    apart.note_fault();
    it.see(apart); // which gets the place first
    CHECK(it.does(apart, effect::stopping) == errc::none);
    CHECK(it.runs(apart) == errc::overruled);
    it.see(stop);
    end(it, stop);
    it.see(apart);
    CHECK(it.runs(apart) == errc::none);
    apart.note_power(power_seen::off);
    it.see(apart);
    it.see(again);
    CHECK(it.runs(again) == errc::none);
}

TEST_CASE("rule 35: a unit that is ordered, held by a stop or lost keeps its place")
{
    enum class state { known, ordered, held, lost };
    for (unsigned const unit : {1U, 3U}) {
        for (state const what : {state::known, state::ordered, state::held, state::lost}) {
            INFO(unit << ' ' << static_cast<int>(what));
            command_desk<1> it;
            hand_commander one{unit}, other{4};
            if (what == state::ordered) {
                REQUIRE(it.runs(one) == errc::none);
            } else {
                begin(it, one);
            }
            if (what == state::lost) {
                REQUIRE(it.misses(one, effect::stopping) != 0);
            }
            if (what == state::known or what == state::lost) {
                end(it, one);
            }
            CHECK(it.is_lost(unit) == (what == state::lost));
            CHECK(it.runs(other) == (what == state::known ? errc::none : errc::too_many_ordered));
        }
    }
}

TEST_CASE("rule 38: what has not left when a stop comes by is told as overruled by its own unit's "
          "stop alone")
{
    for (bool const is_own : {false, true}) {
        command_desk<2> it;
        hand_commander one{3}, stop{is_own ? 3U : 4U};
        one.note_order_to_run();
        one.has_request = true;
        one.wanted = effect::enabling;
        it.link.converse(one, it.now()); // taken, and not fetched yet
        stop.note_stop();
        stop.has_request = true;
        stop.wanted = effect::stopping;
        it.link.converse(stop, it.now());
        REQUIRE(it.leaves());
        CHECK(it.left == write_of(stop.of(), 8'501, 0));
        it.hear(response_to(it.left));
        it.link.converse(one, it.now());
        CHECK(one.told == (is_own ? errc::overruled : errc::cancelled));
    }
}

TEST_CASE("rule 38: a stop's own word that is given up is told as cancelled")
{
    command_desk<2> it;
    hand_commander one{3};
    hand_for_all all{4};
    one.note_stop();
    one.has_request = true;
    one.wanted = effect::stopping;
    it.link.converse(one, it.now());
    all.note_stop();
    all.has_request = true;
    it.link.converse(all, it.now());
    REQUIRE(it.leaves());
    CHECK(it.left == write_of(0, 8'501, 0));
    it.link.converse(one, it.now());
    CHECK(one.told == errc::cancelled);
}

TEST_CASE("rule 38: of two stops that find the line free in one pass the first leaves, and the other behind it")
{
    command_desk<2> it;
    hand_commander one{3}, other{4};
    for (hand_commander* const each : {&one, &other}) {
        each->note_stop();
        each->has_request = true;
        each->wanted = effect::stopping;
        it.link.converse(*each, it.now());
    }
    REQUIRE(it.leaves());
    CHECK(it.left == write_of(3, 8'501, 0));
    it.hear(response_to(it.left));
    it.link.converse(one, it.now());
    CHECK(one.told == errc::none);
    it.link.converse(other, it.now());
    REQUIRE(it.leaves());
    CHECK(it.left == write_of(4, 8'501, 0));
}

TEST_CASE("rule 37: everyone's stop that begins in the pass in which another one ends holds all units")
{
    command_desk<2> it;
    hand_commander one{3};
    hand_for_all first{9}, second{9};
    begin(it, first);
    it.see(one);
    it.pass(10);
    first.note_stop_over();
    it.see(first);
    begin(it, second);
    it.pass(10);
    it.see(second);
    it.see(one);
    CHECK(it.runs(one) == errc::overruled);
}

TEST_CASE("rule 37: everyone's stop that has ended, and goes on coming by, keeps nobody else's hold")
{
    command_desk<2> it;
    hand_commander one{3};
    hand_for_all first{9}, second{9};
    begin(it, first);
    end(it, first);
    begin(it, second);
    it.pass(10);
    for (int pass = 0; pass < 3; ++pass) { // each says in every pass that it is over
        second.note_stop_over();
        it.see(second);
        first.note_stop_over();
        it.see(first);
        it.pass(10);
    }
    it.see(one);
    CHECK(it.runs(one) == errc::none);
}
