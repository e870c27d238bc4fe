// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// What a client does first, new or set up anew in its place, whatever the clock shows.
#include "defect/client_line.hpp"

#include "support/catch.hpp"

#include <rtuwire/ask/single_request.hpp>

using namespace rtuwire;
using namespace rtuwire::test;

namespace {

constexpr client_options once{.response_timeout = milliseconds(100), .late_response = milliseconds(30), .retries = 0};

series reads(unsigned unit, unsigned count = 1)
{
    return series{[=](unsigned) { return read_of(unit, 3201); }, count};
}

/// A client in the hands of the test, on a line that is silent.
struct desk {
    client link{office_line, once};
    std::uint64_t time;

    explicit desk(std::uint64_t begin = 0xFFFF'FFFFU - 5'000'000U) : time{begin} { settle(); }

    void settle()
    {
        link.advance(now());
        pass(1'000'000);
    }
    void set_up_anew()
    {
        link = client{office_line, once};
        settle();
    }
    instant now() const { return instant{static_cast<std::uint32_t>(time)}; }
    void pass(std::uint64_t length)
    {
        time += length;
        link.advance(now());
    }
    /// It comes by; whether a frame leaves then. It has left when this returns.
    bool asks(series& conversation)
    {
        link.converse(conversation, now());
        std::size_t const size = link.poll_transmit().size();
        if (size != 0) {
            time += office_line.characters(size).microseconds;
            link.sent(now());
        }
        return size != 0;
    }
    void be_answered(frame_bytes const& asked)
    {
        time += 5'000;
        link.receive(response_to(asked), now());
        pass(10'000);
    }
};

} // namespace

TEST_CASE("a client that nobody told of the time has nothing to do")
{
    CHECK_FALSE(client{office_line}.poll_deadline());
    CHECK_FALSE(host_client{office_line}.poll_deadline());
}

TEST_CASE("a client asks for a pass at once after a refusal, whatever the clock shows")
{
    for (std::uint64_t const begin : {0x1000ULL, 0x7FFF'0000ULL, 0x9000'0000ULL, 0xFFF0'0000ULL}) {
        INFO(begin);
        desk it{begin};
        series none{[](unsigned) { return frame_bytes{}; }, 1};
        CHECK_FALSE(it.asks(none));
        REQUIRE(none.last == errc::frame_too_short);
        deadline const due = it.link.poll_deadline();
        REQUIRE(due);
        CHECK(reached(it.now(), *due));
    }
}

TEST_CASE("a client that is set up anew while somebody waits lets the first that comes by ask")
{
    desk it;
    series first = reads(1);
    series second = reads(2);
    REQUIRE(it.asks(first));
    CHECK_FALSE(it.asks(second));
    it.set_up_anew();
    series third = reads(3);
    CHECK(it.asks(third));
}

TEST_CASE("a conversation that is begun anew keeps its turn, also on a client that was set up anew")
{
    for (bool const is_anew : {false, true}) {
        INFO((is_anew ? "set up anew" : "new"));
        desk it;
        if (is_anew) {
            it.set_up_anew();
        }
        series gone = reads(1);
        series next = reads(2);
        REQUIRE(it.asks(gone));
        it.be_answered(gone.frame); // and the one who asked does not come by any more
        unsigned visits = 0;
        for (bool has_asked = false; not has_asked and visits < 9; ++visits) {
            next.forget();
            has_asked = it.asks(next);
            it.pass(0);
        }
        // Marked, next in turn, and next once more.
        CHECK(visits == 3);
    }
}

TEST_CASE("a loop that comes late is called once more behind an outcome, for a conversation that is begun anew then")
{
    for (std::uint64_t const begin : {0x1000ULL, 0x7FFF'0000ULL, 0xFFF0'0000ULL}) {
        INFO(begin);
        desk it{begin};
        single_request once_a_round{unit_id{1}, read_holding_registers{.start = 3201, .count = 1}};
        unsigned rounds = 0;
        for (unsigned passes = 0; passes < 30 and rounds < 10;
             ++passes) { // that of README: no interrupt but the UART's
            it.link.advance(it.now());
            it.link.converse(once_a_round, it.now());
            if (once_a_round.settled()) {
                REQUIRE(once_a_round.outcome());
                ++rounds;
                once_a_round.again();
            }
            byte_view const frame = it.link.poll_transmit();
            if (not frame.empty()) {
                frame_bytes const asked{frame.begin(), frame.end()};
                it.time += office_line.characters(asked.size()).microseconds;
                it.link.sent(it.now());
                it.time += 4'000;
                it.link.receive(response_to(asked), it.now());
                it.time += 10'000; // until the loop gets to it: the line is silent by then
            } else {
                deadline const due = it.link.poll_deadline();
                REQUIRE(due); // else it sleeps for ever
                it.time += reached(it.now(), *due) ? 0 : (*due - it.now()).microseconds;
            }
        }
        CHECK(rounds == 10);
    }
}

TEST_CASE("where two units owe a response to a host's client, all are held")
{
    host_client link{office_line};
    instant const now{5};
    link.hold(unit_id{1}, now + milliseconds(100));
    CHECK_FALSE(link.is_held(unit_id{3}));
    link.hold(unit_id{2}, now + milliseconds(50));
    CHECK(link.is_held(unit_id{3}));
    link.advance(now + milliseconds(50));
    CHECK(link.is_held(unit_id{2}));
    link.advance(now + milliseconds(100));
    CHECK_FALSE(link.is_held(unit_id{1}));
    CHECK_FALSE(link.is_held(unit_id{3}));
}
