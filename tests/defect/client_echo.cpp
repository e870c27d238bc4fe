// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// A line that gives back what is sent, and a client that was not told so.
#include "client_line.hpp"

#include "support/catch.hpp"

#include <rtuwire/ask/words_read.hpp>

using namespace rtuwire;
using namespace rtuwire::detail;
using namespace rtuwire::test;

namespace {

constexpr client_options once{.response_timeout = milliseconds(100), .retries = 0};

using wire = scripted_line<client>;

/// From the handing over of a frame on: when the whole of it comes back, and when its response has arrived.
struct course {
    bool has_line_echo;
    std::uint64_t echo_after;
    std::uint64_t response_after; ///< 0 where the unit is gone
};

/// Runs a conversation of one request on such a line. The echo comes in two parts where `split` is not 0.
template <typename Conversation>
void run_on(wire& line, Conversation& conversation, course const& what, std::size_t split = 0)
{
    bool is_said = false;
    line.run(2'000'000, [&](instant now) {
        if (not conversation.settled()) {
            line.link.converse(conversation, now);
        }
        if (is_said or line.departures.empty()) {
            return;
        }
        is_said = true;
        departure const& frame = line.departures.front();
        if (what.has_line_echo) {
            auto const middle = frame.frame.begin() + static_cast<std::ptrdiff_t>(split);
            if (split != 0) {
                line.arrive(frame.begin + line.length_of(split) + 10, {frame.frame.begin(), middle});
            }
            line.arrive(frame.begin + what.echo_after, {middle, frame.frame.end()});
        }
        if (what.response_after != 0) {
            line.arrive(frame.begin + what.response_after, response_to(frame.frame));
        }
    });
    REQUIRE(is_said);
}

constexpr std::uint64_t while_sending = 4'580; ///< eight bytes take 4.584 ms
constexpr std::uint64_t behind_it = 4'700;
constexpr std::uint64_t answered = 14'000;

/// A request that nothing is known of but its bytes.
series one(frame_bytes const& frame)
{
    return series{[=](unsigned) { return frame; }, 1};
}

} // namespace

TEST_CASE("defect: D2 the probe finds an echo that comes while the request leaves or behind it")
{
    for (std::uint64_t const echo_after : {std::uint64_t{4'000}, while_sending, behind_it}) {
        for (std::uint64_t const response_after : {std::uint64_t{0}, answered}) {
            INFO("echo after " << echo_after << " us, answer after " << response_after << " us");
            wire line{client{office_line, once}, office_line};
            line_echo_probe probe{unit_id{1}};
            run_on(line, probe, {true, echo_after, response_after});
            REQUIRE(probe.settled());
            REQUIRE(probe.outcome());
            CHECK(*probe.outcome());
        }
    }
}

TEST_CASE("defect: D2 the probe finds no echo where there is none")
{
    wire line{client{office_line, once}, office_line};
    line_echo_probe probe{unit_id{1}};
    run_on(line, probe, {false, 0, answered});
    REQUIRE(probe.settled());
    REQUIRE(probe.outcome());
    CHECK_FALSE(*probe.outcome());
    wire dead{client{office_line, once}, office_line};
    line_echo_probe nobody{unit_id{1}};
    run_on(dead, nobody, {false, 0, 0});
    CHECK(nobody.outcome().error() == errc::timed_out);
}

TEST_CASE("defect: D2 the echo of a write that comes while it leaves is no success, wherever it is cut")
{
    frame_bytes const write = write_of(1, 8501, 7);
    for (std::size_t split = 0; split < 8; ++split) {
        for (std::uint64_t const echo_after : {while_sending, behind_it}) {
            if (split == 0 and echo_after == behind_it) {
                continue; // then it is the response that a unit would give
            }
            INFO("first part " << split << " bytes, rest after " << echo_after << " us");
            wire line{client{office_line, once}, office_line};
            series conversation = one(write);
            run_on(line, conversation, {true, echo_after, 0}, split);
            CHECK(conversation.number == 1);
            CHECK(conversation.answered == 0);
            if (echo_after == while_sending) {
                CHECK(conversation.last == errc::line_echo);
            }
        }
    }
}

TEST_CASE("defect: D2 a write without echo is confirmed by its response alone")
{
    wire line{client{office_line, once}, office_line};
    series conversation = one(write_of(1, 8501, 7));
    run_on(line, conversation, {false, 0, answered});
    CHECK(conversation.number == 1);
    CHECK(conversation.answered == 1);
}

TEST_CASE("defect: D2 once the probe has found an echo, the line is run with it and a dead unit "
          "stays dead")
{
    client_options with = once;
    with.has_line_echo = true;
    for (std::uint64_t const echo_after : {while_sending, behind_it}) {
        wire dead{client{office_line, with}, office_line};
        series stop = one(write_of(1, 8501, 7));
        run_on(dead, stop, {true, echo_after, 0});
        CHECK(stop.number == 1);
        CHECK(stop.last == errc::timed_out);
        wire alive{client{office_line, with}, office_line};
        series again = one(write_of(1, 8501, 7));
        run_on(alive, again, {true, echo_after, answered});
        CHECK(again.answered == 1);
    }
}
