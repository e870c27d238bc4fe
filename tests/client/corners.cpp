// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// A client, its bus and its conversations at the edges of their counts.
#include <rtuwire/client/bus.hpp>
#include <rtuwire/client/client.hpp>

#include <optional>

#include "support/catch.hpp"
#include "support/manual_unit.hpp"

#include <rtuwire/altivar/atv28.hpp>
#include <rtuwire/ask/access.hpp>
#include <rtuwire/ask/words_read.hpp>
#include <rtuwire/client/line/request.hpp>
#include <rtuwire/client/statistics.hpp>
#include <rtuwire/core/hex.hpp>

using namespace rtuwire;
using namespace rtuwire::detail;
using namespace rtuwire::altivar;

namespace {

constexpr client_options one_try{.response_timeout = milliseconds(50), .retries = 0};
constexpr auto refusal = "01 83 02 C0 F1"_hex;
constexpr auto damaged_of_1 = "01 03 02 12 34 B5 32"_hex;
constexpr auto damaged_of_2 = "02 03 02 12 34 F1 32"_hex;
constexpr auto too_long_of_1 = "01 03 04 12 34 56 78 81 07"_hex;
constexpr unit_id one{1};
constexpr station<atv28::device> drive{unit_id{1}};

/// A bus with one conversation, played by hand: each request is answered with `response`, if there is one.
template <typename Conversation> struct one_slot {
    bus<1> link;
    Conversation conversation;
    instant now{0};

    one_slot(Conversation const& asked, bus_options const& options)
        : link{test::line, one_try, options}, conversation{asked}
    {
        link.advance(now);
        now = now + milliseconds(10);
    }
    void transact(byte_view response)
    {
        while (true) {
            link.advance(now);
            link.converse(0, conversation, now);
            if (not link.poll_transmit().empty()) {
                break;
            }
            REQUIRE(link.poll_deadline());
            now = *link.poll_deadline();
        }
        now = now + milliseconds(5);
        link.sent(now);
        now = now + milliseconds(2);
        link.receive(response, now);
        now = now + (response.empty() ? milliseconds(200) : milliseconds(5));
        link.advance(now);
        link.converse(0, conversation, now);
    }
};

/// Asks the same for ever.
struct endless : asker {
    single_request<read_holding_registers> request{one, read_holding_registers{3201, 1}};
    std::optional<errc> last{};
    std::optional<request_frame> next() const { return request.next(); }
    void accept(result<response> const& outcome) { last = outcome.error(); }
    static constexpr bool settled() { return false; }
};

/// The same with a request that is made when it can leave.
struct prompt : endless {
    static constexpr conversation_properties properties{.freshness = freshness::when_free};
    static constexpr unit_id unit() { return one; }
};

/// Whether a request of this conversation was taken.
template <typename Conversation> bool is_taken(test::manual_unit& unit, Conversation& conversation)
{
    unit.link.converse(conversation, unit.now);
    return unit.link.is_busy();
}

} // namespace

TEST_CASE("a prompt request is made when the line is silent and its unit owes no response")
{
    test::manual_unit unit{one_try};
    prompt conversation;
    unit.link.receive("00"_hex, unit.now);
    CHECK_FALSE(is_taken(unit, conversation));
    unit.pass(test::line.t3_5());
    REQUIRE(is_taken(unit, conversation));
    REQUIRE(unit.transmit());
    unit.pass(milliseconds(100)); // no response: a late one is waited for
    CHECK_FALSE(is_taken(unit, conversation));
    REQUIRE(conversation.last == errc::timed_out);
    unit.pass(milliseconds(250));
    CHECK(is_taken(unit, conversation));
}

TEST_CASE("any other request is taken at once, and waits itself")
{
    test::manual_unit unit{one_try};
    endless conversation;
    unit.link.receive("00"_hex, unit.now);
    CHECK(is_taken(unit, conversation));
}

TEST_CASE("a request that is given up between two attempts leaves its unit in quarantine")
{
    test::manual_unit unit{{.response_timeout = milliseconds(50), .retries = 1}};
    REQUIRE(unit.ask(test::read_eta));
    unit.link.advance(unit.now = unit.now + milliseconds(60) + test::line.characters(8));
    REQUIRE(unit.transmissions == 1);
    unit.link.cancel(unit.now);
    CHECK(unit.fault() == errc::cancelled);
    CHECK_FALSE(unit.ask(test::read_next));
    unit.run(milliseconds(150));
    CHECK(unit.transmissions == 1);
    unit.run(milliseconds(60));
    CHECK(unit.transmissions == 2);
}

TEST_CASE("a request that nobody sends stalls, after the time that it and a response may take")
{
    test::manual_unit unit{{.response_timeout = milliseconds(50)}};
    REQUIRE(unit.link.start(request_frame{test::read_eta}, unit.now));
    unit.pass(microseconds(49'999) + test::line.characters(8));
    CHECK(unit.none_yet());
    unit.pass(microseconds(1));
    CHECK(unit.fault() == errc::transmit_stalled);
}

TEST_CASE("a request has 4 to 256 bytes")
{
    test::manual_unit unit;
    std::array<std::byte, 257> const bytes{};
    byte_view const all = bytes;
    CHECK(unit.link.start(request_frame{all.first(3)}, unit.now) == errc::frame_too_short);
    CHECK(unit.link.start(request_frame{all}, unit.now) == errc::frame_too_long);
    CHECK_FALSE(unit.link.is_busy());
    // Its response may be as long, and has no room beside it but on a host.
    CHECK(unit.link.start(request_frame{all.first(256)}, unit.now) == errc::buffer_too_small);
    test::basic_manual_unit<host_client> host;
    CHECK(host.link.start(request_frame{all.first(256)}, host.now));
    CHECK(unit.link.start(request_frame{all.first(4)}, unit.now));
}

TEST_CASE("a transmission that stalled may still be answered late")
{
    test::manual_unit unit{{.response_timeout = milliseconds(50)}};
    REQUIRE(unit.link.start(request_frame{test::read_eta}, unit.now));
    REQUIRE_FALSE(unit.link.poll_transmit().empty());
    unit.pass(milliseconds(0));
    unit.pass(milliseconds(100));
    REQUIRE(unit.fault() == errc::transmit_stalled);
    REQUIRE(unit.link.start(request_frame{test::read_eta}, unit.now));
    unit.pass(milliseconds(240)); // it may have left just now: its time-out, and 200 ms
    CHECK(unit.link.poll_transmit().empty());
    unit.pass(milliseconds(30));
    unit.pass(milliseconds(0)); // whoever came by before it had the turn
    CHECK_FALSE(unit.link.poll_transmit().empty());
}

TEST_CASE("only a damaged response of the unit itself is worth an early repetition")
{
    for (byte_view const heard : {byte_view{damaged_of_2}, byte_view{too_long_of_1}}) {
        test::manual_unit unit{{.response_timeout = milliseconds(500), .retries = 1}};
        REQUIRE(unit.ask(test::read_eta));
        unit.say(heard);
        unit.run(milliseconds(100));
        CHECK(unit.transmissions == 1);
    }
    test::manual_unit unit{{.response_timeout = milliseconds(500), .retries = 1}};
    REQUIRE(unit.ask(test::read_eta));
    unit.say(damaged_of_1);
    unit.run(milliseconds(60));
    CHECK(unit.transmissions == 2);
}

TEST_CASE("noise is skipped before a response, and not within it")
{
    test::manual_unit unit{{.max_leading_noise = 9}};
    REQUIRE(unit.ask(test::read_eta));
    unit.say("00"_hex);
    for (std::byte const byte : test::response_1234) {
        unit.say({&byte, 1});
    }
    CHECK(unit.has(0x1234));
}

TEST_CASE("a refusal is no silence, and 300 silences are no fewer than 255")
{
    one_slot<endless> it{{}, {.silent_share = 100}};
    for (unsigned i = 0; i < 300; ++i) {
        it.transact({});
    }
    CHECK(it.link.is_silent(0));
    it.transact(refusal);
    CHECK_FALSE(it.link.is_silent(0));
}

TEST_CASE("a silent unit is asked at least every ten minutes")
{
    client_options const slow{.response_timeout = milliseconds(60'000), .retries = 0};
    bus<1> link{test::line, slow, {.silent_share = 1}};
    endless conversation;
    instant now{0};
    instant asked{0};
    unsigned requests = 0;
    link.advance(now);
    for (unsigned i = 0; i < 200 and requests < 4; ++i) {
        now = link.poll_deadline() and not reached(now, *link.poll_deadline()) ? *link.poll_deadline()
                                                                               : now + milliseconds(10);
        link.advance(now);
        link.converse(0, conversation, now);
        if (not link.poll_transmit().empty()) {
            ++requests;
            CHECK(now - asked < milliseconds(700'000));
            asked = now;
            now = now + milliseconds(5);
            link.sent(now);
        }
    }
    CHECK(requests == 4);
}

TEST_CASE("a line whose unit refuses the probe has no echo, one without a unit is unknown")
{
    line_echo_probe refused{one};
    CHECK(refused.outcome() == errc::busy);
    refused.accept(errc::illegal_data_address);
    CHECK((refused.outcome() == result<bool>{false}));
    line_echo_probe silent{one};
    silent.accept(errc::timed_out);
    CHECK(silent.outcome() == errc::timed_out);
}

TEST_CASE("a unit that owes two responses is waited for alone")
{
    quarantine<1> owed;
    instant const now{0};
    owed.begin(3, now + milliseconds(10));
    owed.begin(3, now + milliseconds(20));
    CHECK(owed.covers(3));
    CHECK_FALSE(owed.covers(4));
    owed.begin(4, now + milliseconds(30));
    CHECK(owed.covers(5));
}

TEST_CASE("units beyond the table are counted for the line alone")
{
    unit_statistics<1> counts;
    counts.on_event(line_event::request, 1);
    for (std::uint8_t const unit : {std::uint8_t{1}, std::uint8_t{2}}) {
        instant const then = instant{7} + milliseconds(unit);
        counts.on_sent({}, frame_role::request, instant{7});
        counts.on_response(line_event::reply, errc::none, unit, then);
        counts.on_response(line_event::exception, errc::illegal_data_value, unit, then);
        counts.on_stray("01 02 03 04 05"_hex, true, unit);
    }
    CHECK(counts.line()[line_event::late] == 2);
    CHECK((*counts.unit(1))[line_event::late] == 1);
    CHECK(counts.line()[line_event::reply] == 2);
    CHECK(counts.line().worst_latency == milliseconds(2));
    REQUIRE(counts.unit(1) != nullptr);
    CHECK(counts.unit(1)->worst_latency == milliseconds(1));
    CHECK(counts.unit(2) == nullptr);
}

TEST_CASE("a conversation that is settled asks nothing, and says why")
{
    auto both = write_all<atv28::cmd, atv28::lfr>(drive, atv28::command_word{0}, 40_Hz);
    REQUIRE(both.next());
    both.accept(errc::timed_out);
    CHECK_FALSE(both.next());
    auto current = read<atv28::lcr>(drive);
    REQUIRE(current.next());
    current.accept(errc::illegal_data_address);
    CHECK_FALSE(current.next());
    CHECK(current.outcome() == errc::illegal_data_address);
}
