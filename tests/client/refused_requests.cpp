// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Requests that cannot be asked, and rounds that fail: the conversation is told, and nothing is kept.
#include <rtuwire/ask/poller.hpp>
#include <rtuwire/client/bus.hpp>
#include <rtuwire/client/client.hpp>
#include <rtuwire/client/statistics.hpp>

#include <optional>

#include "support/catch.hpp"
#include "support/manual_unit.hpp"

#include <rtuwire/altivar/atv12.hpp>
#include <rtuwire/ask/words_read.hpp>
#include <rtuwire/core/hex.hpp>
#include <rtuwire/wire/serial_line/file_records.hpp>

using namespace rtuwire;
using namespace rtuwire::altivar;

namespace {

/// Asks with a frame that is none.
struct bad_request : asker {
    std::optional<errc> told{};

    static std::optional<request_frame> next() { return request_frame{byte_view{}}; }
    void accept(result<response> const& outcome) { told = outcome.error(); }
    bool settled() const { return told.has_value(); }
};

using plan = read_plan<atv12::device, atv12::eta, atv12::acc>;

/// What comes of a request that a board's client takes, up to the moment where it leaves: busy, while it is under way.
template <typename Request> errc taken(Request const& request)
{
    test::manual_unit unit;
    single_request ask{unit_id{1}, request};
    unit.link.converse(ask, unit.now);
    return unit.transmit() == (ask.outcome() == errc::busy) ? ask.outcome().error() : errc::none;
}

} // namespace

TEST_CASE("a board's client has room for records, up to its 264 bytes")
{
    CHECK((taken(read_file_record{file_run{4, 1, 1}}) == errc::busy));
    CHECK((taken(read_file_record{file_run{4, 1, 121}}) == errc::busy));
    CHECK((taken(read_file_record{file_run{4, 1, 1}, file_run{4, 2, 1}}) == errc::buffer_too_small));
    CHECK((taken(write_file_record{4, 7, register_block<1>{}}) == errc::busy));
    // 132 bytes each way, then 134.
    CHECK((taken(write_file_record{4, 7, register_block<60>{}}) == errc::busy));
    CHECK((taken(write_file_record{4, 7, register_block<61>{}}) == errc::buffer_too_small));
}

TEST_CASE("a frame that is none is refused, by a client and by a bus")
{
    client link{test::line};
    instant now{0};
    link.advance(now);
    now = now + milliseconds(10);
    link.advance(now);
    bad_request conversation;
    link.converse(conversation, now);
    CHECK(conversation.told == errc::frame_too_short);
    CHECK_FALSE(link.is_busy());
    link.sent(now); // nothing was

    bus<1> many{test::line};
    many.advance(now);
    now = now + milliseconds(10);
    many.advance(now);
    bad_request other;
    many.converse(0, other, now);
    CHECK(other.told == errc::frame_too_short);
}

TEST_CASE("a round that fails leaves the last whole snapshot")
{
    poller<plan> panel{*station<atv12::device>::checked(1)};
    panel.accept(errc::timed_out);
    CHECK(panel.outcome() == errc::timed_out);
    CHECK_FALSE(panel.next());
    panel.again();
    constexpr std::array<std::byte, 6> two_words{std::byte{3}, std::byte{4}};
    panel.accept(result<response>{response{two_words}});
    CHECK(panel.outcome() == errc::wrong_length);
    panel.again();
    panel.accept(result<response>{response{byte_view{two_words}.first(3)}});
    CHECK_FALSE(panel.outcome());
    CHECK(panel.latest().get<atv12::acc>().count() == 0);
}

TEST_CASE("a probe of a line tells what it found")
{
    line_echo_probe probe{*unit_id::checked(1)};
    CHECK_FALSE(probe.settled());
    CHECK(probe.outcome() == errc::busy);
    probe.accept(errc::line_echo);
    CHECK(probe.settled());
    CHECK(probe.outcome() == true);
}

TEST_CASE("a station outside its device's range is refused when running too")
{
    CHECK(station<atv12::device>::checked(0) == errc::invalid_unit);
    CHECK(station<atv12::device>::checked(248) == errc::invalid_unit);
    CHECK(station<atv12::device>::checked(247));
}

TEST_CASE("giving up where nothing is asked changes nothing, and twice is once")
{
    test::manual_unit unit;
    unit.link.cancel(unit.now);
    CHECK_FALSE(unit.link.poll_outcome());
    unit.ask(test::read_eta);
    unit.link.cancel(unit.now);
    unit.link.cancel(unit.now);
    CHECK(unit.fault() == errc::cancelled);

    // Before it was sent nothing is owed: the unit is asked at once.
    test::manual_unit other;
    static_cast<void>(other.link.start(request_frame{test::read_eta}, other.now));
    other.link.cancel(other.now);
    CHECK(other.fault() == errc::cancelled);
    CHECK(other.ask(test::read_eta));
}

TEST_CASE("two units that owe a response hold everybody back")
{
    test::manual_unit unit{{.response_timeout = milliseconds(50), .retries = 0}};
    constexpr auto other = "02 03 0C 81 00 01 D7 41"_hex;
    constexpr auto third = "03 03 0C 81 00 01 D6 90"_hex;
    unit.ask(test::read_eta);
    unit.run(milliseconds(70));
    CHECK(unit.fault() == errc::timed_out);
    REQUIRE(unit.ask(other));
    unit.run(milliseconds(70));
    CHECK(unit.fault() == errc::timed_out);
    CHECK_FALSE(unit.ask(third));
}

TEST_CASE("statistics start again")
{
    line_statistics counts;
    counts.on_event(line_event::jam, 1);
    counts.on_response(line_event::exception, errc::illegal_function, 1, instant{0} + milliseconds(1));
    counts.on_sent({}, frame_role::request, instant{5});
    counts.reset();
    CHECK(counts.line()[line_event::jam] == 0);
    CHECK(counts.line().worst_latency == duration{});
    counts.on_response(line_event::reply, errc::none, 1, instant{9}); // to the request that was under way
    CHECK(counts.line().worst_latency == microseconds(4));
}
