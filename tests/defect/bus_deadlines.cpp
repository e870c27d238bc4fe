// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// What is due is a deadline whoever comes by, and a slot that never asked anything holds up no silent one.
#include "client_line.hpp"

#include "support/catch.hpp"

#include <optional>

#include <rtuwire/client/bus.hpp>

using namespace rtuwire;
using namespace rtuwire::detail;
using namespace rtuwire::test;

namespace {

/// Reads a register of its unit for ever.
struct steady : asker {
    frame_bytes frame;

    explicit steady(unsigned unit) : frame{read_of(unit, 3201)} {}
    std::optional<request_frame> next() const { return request_frame{frame}; }
    static void accept(result<response> const&) {}
    static bool settled() { return false; }
};

/// Not settled, and has nothing to ask.
struct idle : asker {
    static std::optional<request_frame> next() { return std::nullopt; }
    static void accept(result<response> const&) {}
    static bool settled() { return false; }
};

constexpr auto second = milliseconds(1'000);

TEST_CASE("the end of a rest is a deadline while a stop of all is not settled")
{
    bus<1> link{office_line};
    link.set(0, {.least_idle = second});
    steady conversation{1};
    idle stop;
    instant now{0xFFFF'0000};
    link.advance(now);
    now = now + second;
    link.advance(now);
    link.converse(0, conversation, now);
    CHECK(not link.poll_transmit().empty());
    link.sent(now);
    now = now + milliseconds(10);
    link.receive(response_to(conversation.frame), now);
    link.advance(now);
    link.run_urgent(stop, now);
    link.converse(0, conversation, now);
    instant const told = now;
    for (unsigned i = 0; i < 4; ++i) { // the stop has its turn, and nobody is called at once any more
        now = now + milliseconds(100);
        link.advance(now);
        link.run_urgent(stop, now);
        link.converse(0, conversation, now);
    }
    CHECK(link.poll_deadline() == deadline{told + second});
}

TEST_CASE("a slot that never asked holds up no silent unit")
{
    bus<2> link{office_line, {.response_timeout = milliseconds(50), .retries = 0}, {.silent_share = 100}};
    link.set(1, {.longest_gap = second});
    steady dead{1};
    idle other;
    unsigned requests = 0;
    instant now{0x1000'0000};
    for (unsigned i = 0; i < 1'000; ++i, now = now + milliseconds(10)) {
        link.advance(now);
        link.converse(0, dead, now);
        link.converse(1, other, now);
        if (not link.poll_transmit().empty()) {
            ++requests;
            link.sent(now);
        }
    }
    CHECK(requests > 10);
}

TEST_CASE("who is to come by again is called at once, also behind a request that was disturbed")
{
    client link{office_line};
    steady first{1};
    steady other{2};
    instant now{0xFFFF'0000};
    link.advance(now);
    now = now + second;
    link.advance(now);
    link.converse(first, now);
    link.receive(frame_bytes{std::byte{0}}, now);
    now = now + office_line.t3_5();
    link.advance(now);
    link.converse(other, now);
    deadline const next = link.poll_deadline();
    CHECK((next and reached(now, *next)));
}

/// What a link names as its deadline where the one that asked is gone and another visits, so long after the last byte.
template <typename Link, typename Visit> deadline woken_after(duration quiet, duration held, Visit visit)
{
    constexpr retry_policy patient{.busy_pause = longest_duration};
    Link link{office_line};
    steady first{1};
    steady other{2};
    instant now{0xFFFF'0000};
    link.advance(now);
    now = now + second;
    link.advance(now);
    visit(link, 0, first, now, patient);
    CHECK(not link.poll_transmit().empty());
    link.sent(now);
    link.receive(framed({1, 0x83, 6}), now); // busy: it pauses
    now = now + second;
    link.advance(now);
    visit(link, 1, other, now, patient);
    now = now + duration{quiet.microseconds - second.microseconds};
    link.advance(now); // the pause is over: it waits
    link.hold(unit_id{3}, now + held);
    visit(link, 1, other, now, patient);
    deadline const next = link.poll_deadline();
    return next ? deadline{instant{next->microseconds - now.microseconds}} : next;
}

TEST_CASE("defect: D23 who is to come by again is called at once, however long the line was quiet")
{
    auto const on_client = [](client& link, std::size_t, steady& who, instant now, retry_policy const& with) {
        link.converse(who, now, with);
    };
    auto const on_bus = [](bus<2>& link, std::size_t slot, steady& who, instant now, retry_policy const& with) {
        link.set(slot, {.with = with});
        link.converse(slot, who, now);
    };
    for (duration const quiet : {longest_duration, duration{longest_duration.microseconds + 100'000'000U}}) {
        for (duration const held : {milliseconds(1), milliseconds(60'000), milliseconds(1'800'000)}) {
            INFO("quiet for " << quiet.microseconds << " us, another unit held for " << held.microseconds << " us");
            for (deadline const& next :
                 {woken_after<client>(quiet, held, on_client), woken_after<bus<2>>(quiet, held, on_bus)}) {
                CHECK((next and reached(instant{0}, *next)));
            }
        }
    }
}

} // namespace
