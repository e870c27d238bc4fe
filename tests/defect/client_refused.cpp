// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// A conversation whose request is refused at once and that has another one, in a loop that sleeps until the deadline;
// and a bus whose silent share is no percentage.
#include "support/catch.hpp"

#include <array>
#include <optional>

#include <rtuwire/ask/single_request.hpp>
#include <rtuwire/client/bus.hpp>
#include <rtuwire/wire/registers.hpp>

using namespace rtuwire;

namespace {

constexpr line_timing timing{19'200, character_format::even_8_1};

/// First two bytes, which are no frame, then a request.
struct hasty : asker {
    std::array<std::byte, 8> frame{};
    unsigned refusals{0};
    bool is_over{false};

    hasty() { REQUIRE(encode_into(frame, unit_id{1}, read_holding_registers{.start = 0, .count = 1})); }
    std::optional<request_frame> next()
    {
        return request_frame{byte_view{frame}.first(refusals == 0 ? 2U : frame.size())};
    }
    void accept(result<response> const& outcome)
    {
        if (outcome == errc::frame_too_short) {
            ++refusals;
        } else {
            is_over = true;
        }
    }
    bool settled() const { return is_over; }
};

/// Passes until a frame leaves, each at the deadline of the one before; false where there is none.
template <typename Link, typename ComeBy> bool leaves(Link& link, ComeBy come_by)
{
    instant now{0xFFFF'FF00U};
    link.advance(now);
    now = now + milliseconds(100); // the line is quiet, and no time of its own is ahead
    link.advance(now);
    for (unsigned pass = 0; pass < 20; ++pass) {
        link.advance(now);
        come_by(now);
        if (not link.poll_transmit().empty()) {
            return true;
        }
        deadline const next = link.poll_deadline();
        if (not next) {
            return false;
        }
        now = reached(now, *next) ? now : *next;
    }
    return false;
}

} // namespace

TEST_CASE("defect: the next request of a conversation that was refused leaves without anybody waking the loop")
{
    client link{timing};
    hasty conversation;
    CHECK(leaves(link, [&](instant now) { link.converse(conversation, now); }));
    CHECK(conversation.refusals == 1);
    bus<2> many{timing};
    hasty slot;
    CHECK(leaves(many, [&](instant now) { many.converse(1, slot, now); }));
    CHECK(slot.refusals == 1);
}

TEST_CASE("defect: a silent share outside of 1 to 100 is the nearer of the two, and nothing ends by it")
{
    for (std::uint8_t const share : {std::uint8_t{0}, std::uint8_t{101}, std::uint8_t{255}}) {
        INFO(unsigned{share});
        bus<1> link{timing, {.response_timeout = milliseconds(100), .retries = 0}, {.silent_share = share}};
        instant now{0};
        unsigned asked = 0;
        single_request ask{unit_id{1}, read_holding_registers{.start = 0, .count = 1}};
        // Nobody answers for 30 s.
        for (unsigned pass = 0; pass < 30'000; ++pass) {
            now = now + milliseconds(1);
            link.advance(now);
            if (ask.settled()) {
                ask.again();
            }
            link.converse(0, ask, now);
            if (not link.poll_transmit().empty()) {
                ++asked;
                now = now + timing.characters(8);
                link.sent(now);
            }
        }
        // 1 % of 30 s are two time-outs or three; at 100 % it is asked all the time, but for what it may still owe.
        CHECK((share == 0 ? asked >= 2 and asked <= 5 : asked > 60));
    }
}
