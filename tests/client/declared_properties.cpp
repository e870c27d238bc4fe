// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// What a conversation declares is what a client does, and nothing else: a `unit()` by itself means nothing.
#include <rtuwire/client/client.hpp>

#include <cstdint>
#include <optional>

#include "client/hand_clock.hpp"

#include "support/catch.hpp"

using namespace rtuwire;
using namespace rtuwire::test;

namespace {

constexpr client_options twice{.response_timeout = milliseconds(100), .late_response = {}, .retries = 1};

/// Reads one register of unit 1 once, counts how often its request was wanted, and has a `unit()`.
struct with_unit : asker {
    frame_bytes frame{read_of(1, 3201)};
    unsigned wanted{0};
    std::optional<errc> told;

    static unit_id unit() { return unit_id{1}; }
    std::optional<request_frame> next()
    {
        if (settled()) {
            return std::nullopt;
        }
        ++wanted;
        return request_frame{frame};
    }
    void accept(result<response> const& outcome) { told = outcome.error(); }
    bool settled() const { return told.has_value(); }
};
struct when_free : with_unit {
    static constexpr conversation_properties properties{.freshness = freshness::when_free};
};
struct sent_once : with_unit {
    static constexpr conversation_properties properties{.repetition = repetition::never};
};

using line = hand_clock<client>;

/// Whether a request was taken on a busy line.
template <typename Conversation> bool asks_on_a_busy_line(Conversation& conversation)
{
    line it{twice};
    it.link.receive(frame_bytes{std::byte{0x55}}, it.now());
    it.link.converse(conversation, it.now());
    return it.link.is_busy();
}

/// How often the request leaves where no response comes.
template <typename Conversation> unsigned sendings(Conversation conversation)
{
    line it{twice};
    unsigned count = 0;
    for (unsigned i = 0; i < 50; ++i) {
        it.link.converse(conversation, it.now());
        if (not it.link.poll_transmit().empty()) {
            it.link.sent(it.now());
            ++count;
        }
        it.pass(20'000);
    }
    CHECK(conversation.told == errc::timed_out);
    return count;
}

} // namespace

TEST_CASE("a unit() without a property does not make a conversation wait for a quiet line")
{
    with_unit ordinary;
    CHECK(asks_on_a_busy_line(ordinary));
    CHECK(ordinary.wanted == 1);
    when_free fresh;
    CHECK_FALSE(asks_on_a_busy_line(fresh));
    CHECK(fresh.wanted == 0);
}

TEST_CASE("a unit() without a property does not keep a request from being made while the unit is held")
{
    line it{twice};
    it.link.hold(unit_id{1}, it.now() + milliseconds(50));
    with_unit ordinary;
    it.link.converse(ordinary, it.now());
    CHECK(ordinary.wanted == 1); // its request is made, and stays with it
    CHECK_FALSE(it.link.is_busy());
    when_free fresh;
    it.link.converse(fresh, it.now());
    CHECK(fresh.wanted == 0);
    CHECK_FALSE(it.link.is_busy());
}

TEST_CASE("a request is sent again unless its conversation declares that none is")
{
    CHECK(sendings(with_unit{}) == 2);
    CHECK(sendings(when_free{}) == 2);
    CHECK(sendings(sent_once{}) == 1);
}
