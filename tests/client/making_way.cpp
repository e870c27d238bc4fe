// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// How a word that stops gets the line, and what becomes of what is under way: docs/engine-rules.md, rules 38 and 40.
#include "client/command_desk.hpp"

#include "support/catch.hpp"

using namespace rtuwire;
using namespace rtuwire::test;

namespace {

constexpr client_options eager{.response_timeout = milliseconds(100), .late_response = {}, .retries = 2};

/// A stop of unit 3 that has a word to say.
struct stop_of_3 : hand_commander {
    stop_of_3() : hand_commander{3}
    {
        note_stop();
        has_request = true;
        wanted = effect::stopping;
    }
};

series reader(unsigned unit)
{
    return series{[=](unsigned) { return read_of(unit, 3'201); }};
}

bool is_word(frame_bytes const& frame) { return frame == write_of(3, 8'501, 0); }

} // namespace

TEST_CASE("rule 38: while a stop waits for the line nobody else asks, whoever comes by first and "
          "how often")
{
    for (bool const is_last : {false, true}) { // the other is the one who asked last
        INFO(is_last);
        command_desk<1> it;
        series other = reader(4), before = reader(5);
        series& asker = is_last ? other : before;
        asker.most = 1;
        it.link.converse(asker, it.now());
        REQUIRE(it.leaves());
        it.hear(response_to(it.left));
        it.link.converse(asker, it.now());
        asker.most = 10;
        REQUIRE(asker.answered == 1);
        it.link.receive(frame_bytes{std::byte{0x55}}, it.now());
        it.link.advance(it.now());
        stop_of_3 stop;
        it.link.converse(stop, it.now());
        for (unsigned pass = 0; pass < 4; ++pass) {
            it.link.receive(frame_bytes{std::byte{0x55}}, it.now());
            it.pass(100);
            it.link.converse(other, it.now());
            CHECK_FALSE(it.link.is_busy());
            it.link.converse(stop, it.now());
        }
        it.pass(10'000);
        it.link.converse(other, it.now());
        CHECK_FALSE(it.link.is_busy());
        it.link.converse(stop, it.now());
        CHECK(it.leaves());
        CHECK(is_word(it.left));
    }
}

TEST_CASE("rule 38: where a stop is gone another asks when it comes by for the second time")
{
    for (bool const is_last : {false, true}) {
        INFO(is_last);
        command_desk<1> it;
        series other = reader(4);
        if (is_last) {
            it.link.converse(other, it.now());
            REQUIRE(it.leaves());
            it.hear(response_to(it.left));
        }
        it.link.receive(frame_bytes{std::byte{0x55}}, it.now());
        it.link.advance(it.now());
        {
            stop_of_3 stop;
            it.link.converse(stop, it.now());
        }
        it.pass(10'000);
        it.link.converse(other, it.now());
        CHECK_FALSE(it.leaves());
        it.pass(0);
        it.link.converse(other, it.now());
        if (is_last) { // which opens the turn for others, and there are none
            CHECK_FALSE(it.leaves());
            it.link.converse(other, it.now());
        }
        CHECK(it.leaves());
    }
}

TEST_CASE("rule 38: a stop drops what nobody comes for any more when it is next for the second time")
{
    command_desk<1> it;
    {
        series gone = reader(4);
        it.link.converse(gone, it.now());
        REQUIRE(it.leaves());
        it.hear(response_to(it.left));
    }
    stop_of_3 stop;
    for (unsigned pass = 1; pass <= 3; ++pass) {
        it.link.converse(stop, it.now());
        CHECK(it.leaves() == (pass == 3));
        it.pass(0);
    }
}

TEST_CASE("rule 38: what is under way for another unit is not repeated when a stop waits")
{
    for (bool const is_unready : {false, true}) {
        command_desk<1> it{eager};
        series other = reader(4);
        it.link.converse(other, it.now());
        REQUIRE(it.leaves());
        stop_of_3 stop;
        it.link.converse(stop, it.now());
        REQUIRE_FALSE(it.leaves());
        if (is_unready) {
            it.hear(framed({4, 0x83, 6})); // busy: the unit asks for time
        } else {
            it.pass(200'000);
        }
        it.link.converse(other, it.now());
        CHECK(other.number == 1);
        CHECK(other.last == (is_unready ? errc::server_device_busy : errc::timed_out));
        it.link.converse(stop, it.now());
        CHECK(it.leaves());
        CHECK(is_word(it.left));
    }
}

TEST_CASE("rule 38: a request to the stopped unit is given up unless its response has begun to arrive")
{
    for (bool const is_arriving : {false, true}) {
        INFO(is_arriving);
        command_desk<1> it;
        series other = reader(3);
        it.link.converse(other, it.now());
        REQUIRE(it.leaves());
        frame_bytes const response = response_to(it.left);
        stop_of_3 stop;
        it.time += 5'000;
        if (is_arriving) {
            it.link.receive(frame_bytes{response.begin(), response.begin() + 3}, it.now());
        }
        it.pass(100);
        it.link.converse(stop, it.now());
        CHECK(it.leaves() == not is_arriving);
        if (is_arriving) {
            it.link.receive(frame_bytes{response.begin() + 3, response.end()}, it.now());
            it.pass(5'000);
        }
        it.link.converse(other, it.now());
        CHECK(other.last == (is_arriving ? errc::none : errc::cancelled));
    }
}

TEST_CASE("rule 38: a response that comes in lumps, as an adapter hands it over, has begun until its line is silent")
{
    constexpr std::uint32_t rates[] = {19'200, 115'200};
    for (std::uint32_t const rate : rates) {
        for (bool const rests_first : {true, false}) { // the silence before sending, or none
            for (bool const is_whole : {true, false}) {
                INFO(rate << " bit/s, " << rests_first << ", " << is_whole);
                line_timing const host = line_timing::host(rate, character_format::even_8_1);
                command_desk<1> it{{}, rests_first ? host : host.with_silence(duration{})};
                series other{[](unsigned) { return read_of(3, 3'201, 60); }};
                it.link.converse(other, it.now());
                REQUIRE(it.leaves());
                frame_bytes const response = response_to(it.left);
                it.time += 40'000;
                it.link.receive(frame_bytes{response.begin(), response.begin() + 62}, it.now());
                stop_of_3 stop;
                it.pass(16'000);
                it.link.converse(stop, it.now());
                CHECK_FALSE(it.leaves());
                if (is_whole) {
                    it.link.receive(frame_bytes{response.begin() + 62, response.end()}, it.now());
                    it.pass(5'000);
                    it.link.converse(other, it.now());
                    CHECK(other.answered == 1);
                } else { // the rest was lost: no longer than until the frame is over
                    deadline const next = it.link.poll_deadline();
                    REQUIRE(next);
                    it.pass((*next - it.now()).microseconds);
                }
                it.link.converse(stop, it.now());
                CHECK(it.leaves());
                CHECK(is_word(it.left));
            }
        }
    }
}

TEST_CASE("rule 24: a stop that waits for silence while a response is awaited gets a pass when the line is silent")
{
    command_desk<1> it;
    series other = reader(3);
    it.link.converse(other, it.now());
    REQUIRE(it.leaves());
    it.time += 5'000;
    it.link.receive(response_to(framed({5, 3, 0, 1, 0, 1})), it.now()); // whole, of another unit
    stop_of_3 stop;
    it.pass(100);
    it.link.converse(stop, it.now());
    REQUIRE_FALSE(it.leaves());
    // A loop that sleeps until there is something to do.
    deadline const next = it.link.poll_deadline();
    REQUIRE(next);
    duration const wait = *next - it.now();
    CHECK(wait <= office_line.t3_5());
    it.pass(wait.microseconds);
    it.link.converse(stop, it.now());
    CHECK(it.leaves());
    CHECK(is_word(it.left));
}

TEST_CASE("rule 38: a response that is there reaches its asker before the stop says its word")
{
    command_desk<1> it;
    series other = reader(3);
    it.link.converse(other, it.now());
    REQUIRE(it.leaves());
    it.hear(response_to(it.left));
    stop_of_3 stop;
    it.link.converse(stop, it.now());
    CHECK_FALSE(it.leaves());
    it.link.converse(other, it.now());
    CHECK(other.answered == 1);
    it.link.converse(stop, it.now());
    CHECK(it.leaves());
    CHECK(is_word(it.left));
}

TEST_CASE("rule 38: a stop's word does not leave before the request that is leaving has left")
{
    command_desk<1> it;
    series other = reader(3);
    it.link.converse(other, it.now());
    REQUIRE_FALSE(it.link.poll_transmit().empty());
    stop_of_3 stop;
    for (unsigned pass = 0; pass < 3; ++pass) {
        it.pass(1'000);
        it.link.converse(stop, it.now());
        CHECK(it.link.poll_transmit().empty());
    }
    it.link.sent(it.now());
    it.pass(5'000);
    it.link.converse(stop, it.now());
    CHECK(it.leaves());
}

TEST_CASE("rule 40: a request that was given up counts where it had left, and is none that was repeated")
{
    for (unsigned const sendings : {0U, 1U, 2U}) {
        for (std::uint8_t tolerated = 0; tolerated < 2; ++tolerated) {
            INFO(sendings << " times, " << unsigned{tolerated} << " tolerated");
            command_desk<1> it{eager};
            hand_commander one{3, tolerated};
            REQUIRE(it.runs(one) == errc::none);
            one.again = repetition::allowed;
            one.has_request = true;
            one.wanted = effect::none;
            it.link.converse(one, it.now());
            for (unsigned i = 0; i < sendings; ++i) {
                REQUIRE(it.leaves());
                if (i + 1 < sendings) {
                    it.fail(one);
                }
            }
            it.link.cancel(one, it.now());
            it.link.converse(one, it.now());
            CHECK(one.told == errc::cancelled);
            CHECK(it.is_lost(3) == (sendings != 0 and tolerated == 0));
        }
    }
}

TEST_CASE("rule 40: one that was cancelled counts also where a stop comes by before its asker")
{
    for (unsigned const stopped : {3U, 4U}) { // its unit, another one
        for (bool const has_left : {false, true}) {
            INFO(stopped << ' ' << has_left);
            command_desk<2> it;
            hand_commander one{3};
            REQUIRE(it.runs(one) == errc::none);
            series poll = reader(3);
            it.link.converse(poll, it.now());
            if (has_left) {
                REQUIRE(it.leaves());
                it.pass(5'000);
            }
            it.link.cancel(it.now());
            hand_commander stop{stopped};
            stop.note_stop();
            stop.wanted = effect::stopping;
            CHECK(it.says(stop));
            CHECK(it.is_lost(3) == has_left);
        }
    }
}

TEST_CASE("rule 40: a request that a stop cuts short does not count, whoever comes by first and when")
{
    for (bool const has_left : {false, true}) {
        for (bool const is_stop_first : {false, true}) {
            INFO(has_left << ' ' << is_stop_first);
            command_desk<1> it;
            hand_commander one{3};
            REQUIRE(it.runs(one) == errc::none);
            series poll = reader(3);
            it.link.converse(poll, it.now());
            REQUIRE_FALSE(it.link.poll_transmit().empty());
            it.pass(4'000);
            if (has_left) {
                it.link.sent(it.now());
                it.pass(5'000);
            }
            stop_of_3 stop;
            it.link.converse(stop, it.now());
            if (not has_left) {
                it.link.sent(it.now());
                it.pass(5'000);
            }
            if (is_stop_first) {
                it.link.converse(stop, it.now());
            }
            it.link.converse(poll, it.now());
            CHECK(poll.last == errc::cancelled);
            it.link.converse(stop, it.now());
            CHECK_FALSE(it.is_lost(3));
            CHECK(it.leaves());
            CHECK(is_word(it.left));
            CHECK(stop.losses == 0);
        }
    }
}

TEST_CASE("rule 40: a response to a repetition is a response")
{
    command_desk<1> it{eager};
    hand_commander one{3};
    REQUIRE(it.runs(one) == errc::none);
    one.again = repetition::allowed;
    REQUIRE(it.says(one, effect::none));
    it.fail(one);
    REQUIRE(it.leaves());
    it.hear(response_to(it.left));
    it.link.converse(one, it.now());
    CHECK(one.told == errc::none);
    CHECK_FALSE(it.is_lost(3));
}

TEST_CASE("rule 38: the repetition of a stop's word does not wait for what its unit owes to an earlier request")
{
    constexpr client_options owing{
        .response_timeout = milliseconds(100), .late_response = milliseconds(800), .retries = 2};
    command_desk<1> it{owing};
    series poll = reader(3);
    it.link.converse(poll, it.now());
    REQUIRE(it.leaves());
    stop_of_3 stop;
    stop.again = repetition::allowed;
    it.link.converse(stop, it.now()); // the poll's response is given up, and may still come for 0.9 s
    it.pass(5'000);
    it.link.converse(stop, it.now());
    REQUIRE(it.leaves());
    REQUIRE(is_word(it.left));
    it.link.advance(it.now());
    std::uint64_t const said = it.time;
    it.left = {};
    while (it.time - said < 1'000'000 and not it.leaves()) {
        it.pass(1'000);
        it.link.converse(stop, it.now());
    }
    CHECK(is_word(it.left));
    CHECK(it.time - said < 150'000); // the response time-out, the response's own time, the silence
}
