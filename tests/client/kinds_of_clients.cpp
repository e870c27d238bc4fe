// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// What the three kinds of clients have room for, and what each of them does with bytes and requests at its edges:
// docs/engine-rules.md, rules 2, 4, 19 to 21, 26 and 35.
#include "client/command_desk.hpp"

#include "support/catch.hpp"

#include <rtuwire/client/bus.hpp>
#include <rtuwire/client/statistics.hpp>

using namespace rtuwire;
using namespace rtuwire::detail;
using namespace rtuwire::test;

namespace {

constexpr client_options once{.response_timeout = milliseconds(100), .late_response = {}, .retries = 0};

template <typename Link> struct hand {
    Link link{office_line, once};
    instant now{0};

    hand()
    {
        pass({});
        pass(milliseconds(1'000));
    }
    void pass(duration length)
    {
        now = now + length;
        link.advance(now);
    }
    template <typename Conversation> bool asks(Conversation& conversation)
    {
        link.converse(conversation, now);
        byte_view const frame = link.poll_transmit();
        if (frame.empty()) {
            return false;
        }
        left = frame_bytes{frame.begin(), frame.end()};
        now = now + office_line.characters(left.size());
        link.sent(now);
        return true;
    }
    void be_answered()
    {
        link.receive(response_to(left), now);
        pass(milliseconds(10));
    }
    frame_bytes left{};
};

/// Waits for its time.
struct timed : series {
    instant seen{0};
    timed() : series{[](unsigned) { return read_of(3, 3'201); }, 1} {}
    void advance(instant now) { seen = now; }
    static deadline poll_deadline() { return {}; }
};

series reader(unsigned unit, unsigned count = 1)
{
    return series{[=](unsigned) { return read_of(unit, 3'201); }, count};
}

template <typename Link> bool holds_all_by_two()
{
    hand<Link> it;
    it.link.hold(unit_id{3}, it.now + milliseconds(100));
    bool const is_one = it.link.is_held(unit_id{3}) and not it.link.is_held(unit_id{5});
    it.link.hold(unit_id{4}, it.now + milliseconds(100));
    return is_one and it.link.is_held(unit_id{5});
}

} // namespace

TEST_CASE("a client that commands no motor takes conversations with times as well")
{
    hand<client> it;
    timed conversation;
    CHECK(it.asks(conversation));
    CHECK(conversation.seen != instant{0});
}

TEST_CASE("rule 19: a client has one place for a unit that is held, a second one stands for all")
{
    CHECK(holds_all_by_two<client>());
    CHECK(holds_all_by_two<drive_client<2>>());
    CHECK(holds_all_by_two<host_client>());
}

TEST_CASE("rule 35: a host's client commands 32 units at once")
{
    hand<host_client> it;
    for (unsigned unit = 1; unit <= 33; ++unit) {
        hand_commander one{unit};
        one.note_order_to_run();
        one.has_request = true;
        one.wanted = effect::enabling;
        REQUIRE(it.asks(one) == (unit <= 32));
        if (unit <= 32) {
            it.be_answered();
            it.link.converse(one, it.now);
        }
        CHECK(one.told == (unit <= 32 ? errc::none : errc::too_many_ordered));
    }
}

TEST_CASE("rule 4: a request of 8 bytes leaves room for every response, one of 9 does not")
{
    for (bool const is_longer : {false, true}) {
        hand<client> it;
        series conversation{[=](unsigned) {
                                return is_longer ? framed({3, 0x41, 1, 2, 3, 4, 5}) : framed({3, 0x41, 1, 2, 3, 4});
                            },
                            1};
        CHECK(it.asks(conversation) == not is_longer);
        CHECK(conversation.last == (is_longer ? errc::buffer_too_small : errc::none));
    }
}

TEST_CASE("rule 2: a damaged byte behind the silence that ends a response is none of it")
{
    for (std::uint32_t const early : {0U, 1U}) {
        hand<client> it;
        series conversation{[](unsigned) { return framed({3, 0x41, 1}); }, 1}; // only silence ends its response
        REQUIRE(it.asks(conversation));
        it.now = it.now + milliseconds(5);
        it.link.receive(framed({3, 0x41, 7}), it.now);
        it.now = it.now + (office_line.frame_end() + office_line.characters(1));
        it.link.receive_error(instant{it.now.microseconds - early});
        it.pass(milliseconds(10));
        it.link.converse(conversation, it.now);
        CHECK(conversation.answered == (early == 0 ? 1 : 0));
    }
}

TEST_CASE("rule 20: who gives its request up is not told what came of it, also of the first one")
{
    hand<client> it;
    series conversation = reader(3);
    REQUIRE(it.asks(conversation));
    conversation.forget();
    it.be_answered();
    it.link.converse(conversation, it.now);
    CHECK(conversation.number == 0);
}

TEST_CASE("rule 21: who waits for its turn keeps it where it begins anew")
{
    hand<client> it;
    {
        series gone = reader(3);
        REQUIRE(it.asks(gone));
    }
    it.be_answered();
    series next = reader(4);
    for (unsigned pass = 1; pass <= 3; ++pass) {
        CHECK(it.asks(next) == (pass == 3)); // it finds the asker missing for the second time
        next.forget();
    }
}

TEST_CASE("rule 26: what begins with no unit's address is noise, also where all units are held")
{
    for (unsigned const byte : {247U, 248U, 255U}) {
        hand<basic_client<observed_by<line_statistics>>> it;
        it.link.hold(unit_id{3}, it.now + milliseconds(100));
        it.link.hold(unit_id{4}, it.now + milliseconds(100));
        it.link.receive(frame_bytes{static_cast<std::byte>(byte)}, it.now);
        CHECK(it.link.statistics().line()[line_event::late] == (byte == 247 ? 1 : 0));
        CHECK(it.link.statistics().line()[line_event::noise] == (byte == 247 ? 0 : 1));
    }
}

TEST_CASE("rule 29: a share of more than 100 percent is one of 100, which leaves nothing to the others")
{
    for (std::uint8_t const share : {std::uint8_t{100}, std::uint8_t{101}, std::uint8_t{200}}) {
        bus<1> link{office_line, once, {.silent_share = share}};
        series absent = reader(9, 5);
        instant now{0};
        link.advance(now);
        for (unsigned asked = 0; asked < 3; ++asked) {
            now = now + milliseconds(200);
            link.advance(now);
            link.converse(0, absent, now);
            link.advance(now);
            link.converse(0, absent, now);
            CHECK_FALSE(link.poll_transmit().empty());
            link.sent(now);
        }
        CHECK(link.is_silent(0));
    }
}
