// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Missing responses, and for how long a unit gets no new request: docs/engine-rules.md, rules 17 to 19, to the
// microsecond. The times here are sums of their own.
#include "client/hand_clock.hpp"

#include "support/catch.hpp"

#include <rtuwire/client/bus.hpp>

using namespace rtuwire;
using namespace rtuwire::detail;
using namespace rtuwire::test;

namespace {

constexpr std::uint64_t minute = 60'000'000;
constexpr std::uint64_t longest = 35 * minute;

/// A client in the hands of the test.
template <typename Link = client> struct hand : hand_clock<Link> {
    using hand_clock<Link>::link;
    using hand_clock<Link>::now;
    using hand_clock<Link>::pass;
    using hand_clock<Link>::time;

    explicit hand(client_options const& options) : hand_clock<Link>{options} {}

    /// A conversation comes by; whether a frame left. It has left when this returns.
    bool asks(series& conversation)
    {
        link.converse(conversation, now());
        std::size_t const size = link.poll_transmit().size();
        if (size == 0) {
            return false;
        }
        time += office_line.characters(size).microseconds;
        link.sent(now());
        return true;
    }
    void hear(frame_bytes const& bytes) { link.receive(bytes, now()); }
    bool is_held(std::uint8_t unit) const { return link.is_held(unit_id::checked(unit).value_or(unit_id{1})); }
};

/// How long the response to a read of one register takes on the line: seven characters of eleven bits.
constexpr std::uint64_t response_time = (7 * 11 * 1'000'000 + 19'199) / 19'200;

constexpr client_options patient{
    .response_timeout = milliseconds(100), .late_response = milliseconds(30), .retries = 2};
constexpr std::uint64_t waits = 100'000 + response_time;
constexpr std::uint64_t each = waits + 30'000;

series reader(unsigned unit, unsigned count = 1)
{
    return series{[=](unsigned number) { return read_of(unit, 3201 + number); }, count};
}

/// Passes up to the microsecond before `end`, and over it: the unit is held until just then.
template <typename Link> void check_held_until(hand<Link>& it, std::uint8_t unit, std::uint64_t end)
{
    REQUIRE(end > it.time);
    it.pass_until(end - 1);
    CHECK(it.is_held(unit));
    it.pass(1);
    CHECK_FALSE(it.is_held(unit));
}

} // namespace

TEST_CASE("rule 18: a unit that answered none of its sendings is held until it may have answered "
          "all, one behind "
          "the other")
{
    hand it{patient};
    series conversation = reader(1);
    std::uint64_t owed = 0;
    for (unsigned i = 0; i < 3; ++i) {
        REQUIRE(it.asks(conversation));
        owed = std::max(owed, it.time) + each;
        it.pass_until(it.time + waits);
    }
    it.link.converse(conversation, it.now());
    REQUIRE(conversation.last == errc::timed_out);
    check_held_until(it, 1, owed);
}

TEST_CASE("rule 18: after a response each other sending may take as long as the first took, and "
          "late_response")
{
    for (unsigned const unanswered : {1U, 2U}) {
        INFO(unanswered << " sendings without a response");
        hand it{patient};
        series conversation = reader(1);
        REQUIRE(it.asks(conversation));
        std::uint64_t const first = it.time;
        for (unsigned i = 0; i < unanswered; ++i) {
            it.pass_until(it.time + waits);
            REQUIRE(it.asks(conversation));
        }
        it.time += 20'000;
        it.hear(response_to(read_of(1, 3201)));
        std::uint64_t const answered = it.time;
        it.link.converse(conversation, it.now());
        REQUIRE(conversation.answered == 1);
        check_held_until(it, 1, answered + unanswered * (answered - first + 30'000));
    }
}

TEST_CASE("rule 18: where nobody called for a while, each counts as what the time limits of all sendings leave")
{
    hand it{patient};
    series conversation = reader(1);
    REQUIRE(it.asks(conversation));
    it.pass_until(it.time + waits);
    REQUIRE(it.asks(conversation));
    it.time += 10 * minute;
    it.hear(response_to(read_of(1, 3201)));
    std::uint64_t const answered = it.time;
    it.link.converse(conversation, it.now());
    REQUIRE(conversation.answered == 1);
    check_held_until(it, 1, answered + 2 * (100'000 + office_line.characters(8).microseconds + each) + 30'000);
}

TEST_CASE("rule 18: an exception and a damaged response are answers")
{
    for (bool const is_damaged : {false, true}) {
        hand it{patient};
        series conversation = reader(1);
        REQUIRE(it.asks(conversation));
        frame_bytes said = is_damaged ? response_to(read_of(1, 3201)) : framed({1, 0x83, 2});
        said.back() = is_damaged ? said.back() ^ std::byte{1} : said.back();
        for (unsigned i = 0; i < (is_damaged ? 3U : 1U); ++i) {
            it.time += 20'000;
            it.hear(said);
            it.pass(5'000); // what is damaged ends by silence
            it.link.converse(conversation, it.now());
            if (is_damaged and i < 2) {
                REQUIRE(it.asks(conversation));
            }
        }
        CHECK(conversation.last == (is_damaged ? errc::crc_mismatch : errc::illegal_data_address));
        CHECK_FALSE(it.is_held(1));
    }
}

TEST_CASE("rule 18: a frame that was handed out and not reported counts as sent at the end of its time")
{
    hand it{patient};
    series conversation = reader(1);
    it.link.converse(conversation, it.now());
    REQUIRE(it.link.poll_transmit().size() == 8);
    it.pass(0);
    std::uint64_t const limit = it.time + 100'000 + office_line.characters(8).microseconds;
    it.pass_until(limit);
    it.link.converse(conversation, it.now());
    REQUIRE(conversation.last == errc::transmit_stalled);
    check_held_until(it, 1, limit + each);
}

TEST_CASE("rule 18: what was never handed out is owed nothing")
{
    hand it{patient};
    it.hear({std::byte{0x55}});
    series conversation = reader(1);
    it.link.converse(conversation, it.now());
    it.link.cancel(it.now());
    it.link.converse(conversation, it.now());
    REQUIRE(conversation.last == errc::cancelled);
    CHECK_FALSE(it.is_held(1));
}

TEST_CASE("rules 17 and 18: sums of times stop at 35 minutes")
{
    constexpr client_options slow{
        .response_timeout = milliseconds(20 * 60'000), .late_response = milliseconds(20 * 60'000), .retries = 2};
    {
        hand it{slow};
        series conversation = reader(1);
        REQUIRE(it.asks(conversation));
        std::uint64_t const sent = it.time;
        it.link.cancel(it.now());
        it.link.converse(conversation, it.now());
        REQUIRE(conversation.last == errc::cancelled);
        check_held_until(it, 1, sent + longest);
    }
    {
        hand it{slow};
        series conversation = reader(1);
        REQUIRE(it.asks(conversation));
        it.pass_until(it.time + 20 * minute + response_time);
        REQUIRE(it.asks(conversation));
        std::uint64_t const sent = it.time; // the first owes for a quarter of an hour more
        it.link.cancel(it.now());
        it.link.converse(conversation, it.now());
        check_held_until(it, 1, sent + longest);
    }
    {
        hand it{slow};
        series conversation = reader(1);
        REQUIRE(it.asks(conversation));
        it.pass_until(it.time + 20 * minute + response_time);
        REQUIRE(it.asks(conversation));
        it.time += minute;
        it.hear(response_to(read_of(1, 3201)));
        it.link.converse(conversation, it.now());
        REQUIRE(conversation.answered == 1);
        check_held_until(it, 1, it.time + longest);
    }
}

TEST_CASE("rule 19: a held unit is asked nothing new by anybody, whatever it is; a broadcast waits "
          "for nobody")
{
    hand it{patient};
    it.link.hold(unit_id{1}, it.now() + milliseconds(500));
    series read = reader(1);
    series write{[](unsigned) { return write_of(1, 8602, 500); }, 1};
    series everyone{[](unsigned) { return write_of(0, 8602, 500); }, 1};
    for (unsigned i = 0; i < 5; ++i) {
        it.pass(50'000);
        CHECK_FALSE(it.asks(read));
        CHECK_FALSE(it.asks(write));
    }
    CHECK(it.asks(everyone));
    CHECK(read.number == 0); // they keep their requests, and are told nothing
    CHECK(write.number == 0);
    it.pass(300'000);
    it.link.converse(everyone, it.now());
    bool const is_read = it.asks(read) or it.asks(write) or it.asks(read);
    CHECK(is_read);
}

TEST_CASE("rule 19: a repetition waits, too, where its unit is held meanwhile")
{
    hand it{patient};
    series conversation = reader(1);
    REQUIRE(it.asks(conversation));
    std::uint64_t const until = it.time + waits + 60'000;
    it.link.hold(unit_id{1}, it.now() + microseconds(waits + 60'000));
    it.pass_until(it.time + waits);
    CHECK_FALSE(it.asks(conversation));
    it.pass_until(until - 1);
    CHECK_FALSE(it.asks(conversation));
    it.pass(1);
    CHECK(it.asks(conversation));
}

TEST_CASE("rule 19: of a unit's debts and what it is held for the later end counts")
{
    for (bool const is_hold_longer : {true, false}) {
        INFO((is_hold_longer ? "hold ends later" : "the debt ends later"));
        hand it{patient};
        series conversation = reader(1);
        REQUIRE(it.asks(conversation));
        std::uint64_t const owed = it.time + each;
        std::uint64_t const held = owed + (is_hold_longer ? 10'000 : 0) - (is_hold_longer ? 0 : 10'000);
        it.link.hold(unit_id{1}, instant{static_cast<std::uint32_t>(held)});
        it.link.cancel(it.now());
        it.link.converse(conversation, it.now());
        check_held_until(it, 1, std::max(owed, held));
    }
    hand it{patient};
    it.link.hold(unit_id{1}, it.now() + milliseconds(20));
    it.link.hold(unit_id{1}, it.now() + milliseconds(10));
    check_held_until(it, 1, it.time + 20'000);
}

TEST_CASE("rule 19: a client's one place stands for all units where two are held, until the later end")
{
    for (bool const is_first_later : {false, true}) {
        hand it{patient};
        it.link.hold(unit_id{1}, it.now() + milliseconds(is_first_later ? 40 : 20));
        CHECK_FALSE(it.is_held(2));
        it.link.hold(unit_id{2}, it.now() + milliseconds(is_first_later ? 20 : 40));
        CHECK(it.is_held(7));
        check_held_until(it, 7, it.time + 40'000);
        CHECK_FALSE(it.is_held(1));
        CHECK_FALSE(it.is_held(2));
    }
}

TEST_CASE("rule 19: a bus has a place for each slot, and the last stands for the rest")
{
    hand<bus<2>> it{patient};
    it.link.hold(unit_id{1}, it.now() + milliseconds(10));
    it.link.hold(unit_id{2}, it.now() + milliseconds(20));
    CHECK(it.is_held(1));
    CHECK(it.is_held(2));
    CHECK_FALSE(it.is_held(3));
    it.link.hold(unit_id{3}, it.now() + milliseconds(15));
    CHECK(it.is_held(7));
    check_held_until(it, 7, it.time + 20'000);
}

TEST_CASE("rule 19: one `advance` ends a request whose time is over, and then the debt that is over, too")
{
    constexpr client_options once{
        .response_timeout = milliseconds(100), .late_response = milliseconds(30), .retries = 0};
    hand it{once};
    series conversation = reader(1, 2);
    REQUIRE(it.asks(conversation));
    it.pass(each);
    CHECK_FALSE(it.is_held(1));
    CHECK(it.asks(conversation));
    CHECK(conversation.last == errc::timed_out);
}
