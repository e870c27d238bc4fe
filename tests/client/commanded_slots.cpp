// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Conversations that command motors in the slots of a bus: docs/engine-rules.md, rules 28 to 32.
#include "client/command_desk.hpp"

#include "support/catch.hpp"

#include <rtuwire/altivar/atv320.hpp>
#include <rtuwire/altivar/procedure/motion/broadcast_freewheel.hpp>
#include <rtuwire/ask/single_request.hpp>
#include <rtuwire/client/bus.hpp>
#include <rtuwire/wire/registers.hpp>

using namespace rtuwire;
using namespace rtuwire::detail;
using namespace rtuwire::test;

namespace {

constexpr client_options once{.response_timeout = milliseconds(100), .late_response = {}, .retries = 0};
constexpr bus_options half{.silent_share = 50, .silent_after = 1};

/// Not settled while it has nothing to ask, as a cycle is.
struct cycle : hand_commander {
    using hand_commander::hand_commander;
    static bool settled() { return false; }
};

struct bus_desk {
    bus<2> link{office_line, once, half};
    instant now{0};

    bus_desk()
    {
        pass({});
        pass(milliseconds(1'000));
    }
    void pass(duration length)
    {
        now = now + length;
        link.advance(now);
    }
    template <typename Conversation> bool asks(std::size_t slot, Conversation& conversation)
    {
        link.converse(slot, conversation, now);
        byte_view const frame = link.poll_transmit();
        if (frame.empty()) {
            return false;
        }
        left = frame_bytes{frame.begin(), frame.end()};
        now = now + office_line.characters(frame.size());
        link.sent(now);
        return true;
    }
    bool says(cycle& conversation, effect what)
    {
        conversation.has_request = true;
        conversation.wanted = what;
        return asks(0, conversation);
    }
    void be_answered()
    {
        now = now + milliseconds(5);
        link.receive(response_to(left), now);
        pass(milliseconds(5));
    }

    frame_bytes left{};
};

} // namespace

TEST_CASE("rule 28: a commander rests like any other, but for its words that stop")
{
    bus_desk it;
    it.link.set(0, {.with = {.response_timeout = milliseconds(100)}, .least_idle = milliseconds(500)});
    cycle one{3};
    one.note_order_to_run();
    REQUIRE(it.says(one, effect::enabling));
    it.be_answered();
    it.asks(0, one);
    REQUIRE(one.told == errc::none);
    it.pass(milliseconds(499));
    CHECK_FALSE(it.says(one, effect::enabling));
    CHECK(it.says(one, effect::stopping));
    it.be_answered();
    it.asks(0, one);
    it.pass(milliseconds(500));
    CHECK(it.says(one, effect::enabling));
}

TEST_CASE("rule 29: a commander asks its silent unit now and then, but for its words that stop")
{
    bus_desk it;
    cycle one{3};
    REQUIRE(it.says(one, effect::none));
    it.pass(milliseconds(200));
    it.asks(0, one);
    REQUIRE(one.told == errc::timed_out);
    REQUIRE(it.link.is_silent(0));
    it.pass(milliseconds(10));
    CHECK_FALSE(it.says(one, effect::none));
    CHECK(it.says(one, effect::stopping));
    it.be_answered();
    it.asks(0, one);
    CHECK_FALSE(it.link.is_silent(0));
    CHECK(it.says(one, effect::none));
}

TEST_CASE("rules 29 and 41: neither a silent unit nor the rest of a slot holds back the broadcast that takes the power")
{
    bus_desk it;
    it.link.set(0, {.with = {.response_timeout = milliseconds(100)}, .least_idle = milliseconds(500)});
    cycle one{3};
    REQUIRE(it.says(one, effect::none));
    it.pass(milliseconds(200));
    it.asks(0, one);
    REQUIRE(it.link.is_silent(0));
    it.pass(milliseconds(10));
    auto all = altivar::broadcast_freewheel<altivar::atv320::device>();
    CHECK(it.asks(0, all));
}

TEST_CASE(
    "rule 42: what was told its outcome while another's request is under way says at its next visit that it ended")
{
    bus_desk it;
    single_request ask{unit_id{7}, read_holding_registers{3'201, 1}};
    auto all = altivar::broadcast_freewheel<altivar::atv320::device>();
    auto const visit = [&] {
        it.link.converse(0, ask, it.now);
        it.link.converse(1, all, it.now);
    };
    visit();
    REQUIRE(it.link.poll_transmit()[0] == std::byte{0}); // the broadcast came before the request that had not left
    it.link.sent(it.now);
    it.pass(milliseconds(1));
    visit();
    REQUIRE(ask.settled());
    REQUIRE(ask.outcome().error() == errc::cancelled);
    it.pass(milliseconds(1));
    CHECK(it.link.has_turn());
    visit();
    CHECK(ask.outcome().error() == errc::used_already);
    it.pass(milliseconds(1));
    CHECK_FALSE(it.link.has_turn());
}

TEST_CASE("rule 31: a silent unit is asked only where that ends before two thirds of an ordered "
          "drive's time-out")
{
    // The drive's time-out is 5 s, so 3.33 s; the silent unit has 2 s and the time of 512 characters, 0.29 s.
    for (bool const is_late : {false, true}) {
        INFO(is_late);
        bus_desk it;
        it.link.set(1, {.with = {.response_timeout = milliseconds(2'000), .retries = 0}});
        cycle one{3};
        series absent{[](unsigned) { return read_of(9, 3'201); }};
        REQUIRE(it.asks(1, absent));
        it.pass(milliseconds(2'300));
        it.asks(1, absent);
        REQUIRE(it.link.is_silent(1));
        it.asks(0, one);
        it.pass(milliseconds(10'000)); // the others had their share
        one.note_order_to_run();
        instant const asked = it.now;
        REQUIRE(it.says(one, effect::enabling));
        it.be_answered();
        it.asks(0, one);
        REQUIRE(one.told == errc::none);
        it.pass((asked + milliseconds(is_late ? 1'041 : 1'039)) - it.now);
        it.asks(0, one);
        CHECK(it.asks(1, absent) == not is_late);
    }
}

TEST_CASE("rule 32: a stop in a slot takes the line from no urgent stop, and leaves when that is over")
{
    auto const meet = [](auto& urgent, frame_bytes const& words) {
        bus_desk it;
        hand_commander stop{3};
        stop.note_stop();
        stop.wanted = effect::stopping;
        stop.has_request = true;
        urgent.has_request = true;
        it.link.run_urgent(urgent, it.now);
        CHECK(it.asks(0, stop)); // in this pass: at its end the frame leaves
        CHECK(it.left == words);
        CHECK_FALSE(urgent.told);
        CHECK_FALSE(stop.told);
        for (int pass = 0; pass < 100 and not stop.told; ++pass) {
            if (it.left == words and words[0] != std::byte{0}) {
                it.be_answered();
            } else {
                it.pass(milliseconds(5));
            }
            it.link.run_urgent(urgent, it.now);
            if (urgent.told == errc::none) {
                urgent.note_stop_over();
            }
            if (it.asks(0, stop)) {
                CHECK(it.left == write_of(3, 8'501, 0));
                it.be_answered();
            }
        }
        CHECK(urgent.told == errc::none);
        CHECK(stop.told == errc::none);
    };
    hand_for_all everyone{9};
    everyone.note_stop();
    meet(everyone, write_of(0, 8'501, 0));
    hand_commander other{4};
    other.note_stop();
    other.wanted = effect::stopping;
    meet(other, write_of(4, 8'501, 0));
}

TEST_CASE("rule 32: one that is urgent keeps the slots from asking, whatever else comes first in the pass")
{
    for (bool const is_last : {false, true}) { // it comes behind one that has settled
        INFO(is_last);
        bus_desk it;
        hand_commander urgent{4};
        urgent.goes_on = true; // and has nothing to say now
        single_request settled{broadcast, write_single_register{8501, 0}};
        it.link.run_urgent(settled, it.now);
        REQUIRE_FALSE(it.link.poll_transmit().empty());
        it.link.sent(it.now);
        it.pass(milliseconds(200));
        it.link.run_urgent(settled, it.now);
        REQUIRE(settled.settled());
        it.pass(milliseconds(200));
        series poll{[](unsigned) { return read_of(5, 3'201); }};
        if (is_last) {
            it.link.run_urgent(settled, it.now);
        }
        it.link.run_urgent(urgent, it.now);
        if (not is_last) {
            it.link.run_urgent(settled, it.now);
        }
        CHECK_FALSE(it.asks(1, poll));
        it.pass(milliseconds(5));
        it.link.run_urgent(settled, it.now);
        CHECK(it.asks(1, poll)); // up to the next `advance`
    }
}

TEST_CASE("rule 32: a stop in a slot ends no urgent request that has not left")
{
    bus_desk it;
    hand_commander stop{3};
    stop.note_stop();
    stop.wanted = effect::stopping;
    stop.has_request = true;
    it.link.receive(frame_bytes{std::byte{0x55}}, it.now); // the line is not quiet
    single_request urgent{broadcast, write_single_register{8501, 0}};
    it.link.run_urgent(urgent, it.now);
    CHECK_FALSE(it.asks(0, stop));
    it.pass(milliseconds(10));
    it.link.run_urgent(urgent, it.now);
    CHECK(it.asks(0, stop)); // at the end of this pass the urgent one leaves
    CHECK(it.left == write_of(0, 8'501, 0));
    CHECK_FALSE(urgent.settled());
}
