// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Whose turn it is: docs/engine-rules.md, rules 22 and 23, sentence by sentence.
#include "client/hand_clock.hpp"

#include "support/catch.hpp"

using namespace rtuwire;
using namespace rtuwire::test;

namespace {

constexpr client_options once{.response_timeout = milliseconds(100), .late_response = milliseconds(30), .retries = 0};

/// Reads one register of its unit for ever.
struct plain_asker : series {
    explicit plain_asker(unsigned of) : series{[=](unsigned) { return read_of(of, 3201); }} {}
};

/// The same, asked at the last moment.
struct prompt_asker : plain_asker {
    static constexpr conversation_properties properties{.freshness = freshness::when_free};
    unsigned of;
    explicit prompt_asker(unsigned which) : plain_asker{which}, of{which} {}
    unit_id unit() const { return *unit_id::checked(of); }
};

/// A line in the hands of the test.
struct desk : hand_clock<client> {
    desk() : hand_clock{once} {}
    void on_line_activity() { link.receive(frame_bytes{std::byte{0x55}}, now()); }

    /// It comes by; whether its request was taken then.
    template <typename Conversation> bool asks(Conversation& conversation)
    {
        link.converse(conversation, now());
        return link.is_busy() and link.is_asked_by(conversation) and is_new(conversation);
    }
    /// What is under way leaves, and its unit answers; the outcome waits to be taken, on a quiet line.
    void be_answered()
    {
        byte_view const frame = link.poll_transmit();
        REQUIRE_FALSE(frame.empty());
        frame_bytes const asked{frame.begin(), frame.end()};
        time += office_line.characters(frame.size()).microseconds;
        link.sent(now());
        time += 5'000;
        link.receive(response_to(asked), now());
        pass(10'000);
        REQUIRE(link.is_quiet());
    }

private:
    template <typename Conversation> bool is_new(Conversation& conversation)
    {
        bool const is_it = last_asked_ != &conversation or last_number_ != conversation.number;
        last_asked_ = &conversation;
        last_number_ = conversation.number;
        return is_it;
    }
    void const* last_asked_{nullptr};
    unsigned last_number_{0};
};

} // namespace

TEST_CASE("rule 22: on a free line a conversation may ask, also before the line is quiet")
{
    for (bool const is_busy : {false, true}) {
        desk it;
        if (is_busy) {
            it.on_line_activity();
        }
        plain_asker conversation{1};
        CHECK(it.asks(conversation));
    }
}

TEST_CASE("rule 22: one that came by while a request was under way waits, a settled one does not")
{
    for (bool const is_settled : {false, true}) {
        INFO((is_settled ? "settled" : "not settled"));
        desk it;
        plain_asker first{1};
        plain_asker second{2};
        second.most = is_settled ? 0 : 2;
        REQUIRE(it.asks(first));
        CHECK_FALSE(it.asks(second));
        it.be_answered();
        CHECK(it.asks(first) == is_settled);
        CHECK(first.answered == 1);
        if (not is_settled) {
            CHECK(it.asks(second));
        }
    }
}

TEST_CASE("rule 22: so does one that came by while an outcome was not taken")
{
    desk it;
    plain_asker first{1};
    plain_asker second{2};
    REQUIRE(it.asks(first));
    it.be_answered();
    CHECK_FALSE(it.asks(second));
    CHECK_FALSE(it.asks(first));
    CHECK(first.answered == 1);
    CHECK(it.asks(second));
}

TEST_CASE("rule 22: a prompt one that came by on a busy line waits, and so does any that comes by then")
{
    desk it;
    prompt_asker prompt{1};
    plain_asker other{2};
    it.on_line_activity();
    CHECK_FALSE(it.asks(prompt));
    CHECK_FALSE(it.asks(other)); // it might, if nobody waited
    CHECK_FALSE(it.link.is_busy());
    it.pass(10'000);
    CHECK(it.asks(prompt));
}

TEST_CASE("rule 22: the one who asked last makes nobody wait")
{
    desk it;
    prompt_asker prompt{1};
    plain_asker other{2};
    REQUIRE(it.asks(prompt));
    it.be_answered();
    it.on_line_activity();
    CHECK_FALSE(it.asks(prompt)); // takes its outcome; the line is busy
    CHECK(prompt.answered == 1);
    CHECK(it.asks(other));
}

TEST_CASE("rule 22: a request that is taken makes that nobody waits")
{
    desk it;
    plain_asker first{1};
    plain_asker second{2};
    REQUIRE(it.asks(first));
    CHECK_FALSE(it.asks(second));
    it.be_answered();
    CHECK_FALSE(it.asks(first));
    REQUIRE(it.asks(second));
    it.be_answered();
    CHECK(it.asks(second)); // the first did not come by since
    CHECK(second.answered == 1);
}

TEST_CASE("rule 22: one that was held back waits when the time of its unit ends, the one who asked "
          "last does not")
{
    for (bool const is_last : {false, true}) {
        INFO((is_last ? "only the one who asked last was held back" : "another was held back"));
        desk it;
        plain_asker last{1};
        plain_asker other{1};
        plain_asker third{2};
        REQUIRE(it.asks(last));
        it.be_answered();
        it.link.hold(unit_id{1}, it.now() + milliseconds(50));
        CHECK_FALSE(it.asks(last));
        REQUIRE(last.answered == 1);
        if (not is_last) {
            CHECK_FALSE(it.asks(other));
        }
        it.pass(50'000);
        it.on_line_activity(); // where others wait, nobody asks before the line is quiet
        CHECK(it.asks(third) == is_last);
        if (not is_last) {
            it.pass(10'000);
            CHECK_FALSE(it.asks(last));
            CHECK(it.asks(other));
        }
    }
}

TEST_CASE("rule 23: while others wait, nobody asks before the line is quiet")
{
    desk it;
    plain_asker first{1};
    plain_asker second{2};
    REQUIRE(it.asks(first));
    CHECK_FALSE(it.asks(second));
    it.be_answered();
    it.on_line_activity();
    CHECK_FALSE(it.asks(first));
    CHECK(first.answered == 1);
    CHECK_FALSE(it.asks(second));
    CHECK_FALSE(it.link.is_busy());
    it.pass(office_line.t3_5().microseconds - 1);
    CHECK_FALSE(it.asks(first));
    CHECK_FALSE(it.asks(second));
    it.pass(1);
    CHECK_FALSE(it.asks(first));
    CHECK(it.asks(second));
}

TEST_CASE("rule 23: the one who asked last does not ask, but opens the turn, also where it is settled")
{
    for (bool const is_settled : {false, true}) {
        INFO((is_settled ? "settled" : "not settled"));
        desk it;
        plain_asker last{1};
        plain_asker other{2};
        last.most = is_settled ? 1 : 2;
        REQUIRE(it.asks(last));
        CHECK_FALSE(it.asks(other));
        it.be_answered();
        CHECK_FALSE(it.asks(last));
        CHECK(it.asks(other)); // in the same pass, at its first visit since
    }
}

TEST_CASE("rule 23: where the one who asked last is gone, the next asks at its second visit")
{
    desk it;
    plain_asker last{1};
    plain_asker other{2};
    REQUIRE(it.asks(last));
    CHECK_FALSE(it.asks(other));
    it.be_answered();
    it.on_line_activity();
    it.link.converse(last, it.now()); // takes its outcome, and is seen no more
    REQUIRE(last.answered == 1);
    it.pass(10'000);
    CHECK_FALSE(it.asks(other));
    deadline const due = it.link.poll_deadline();
    REQUIRE(due);
    CHECK(reached(it.now(), *due)); // a pass at once
    it.pass(0);
    CHECK(it.asks(other));
}

TEST_CASE("rule 21: the next in turn is the first behind the asker that comes by twice")
{
    desk it;
    plain_asker before{1};
    plain_asker asker{2};
    plain_asker behind{3};
    REQUIRE(it.asks(asker));
    CHECK_FALSE(it.asks(behind));
    CHECK_FALSE(it.asks(before)); // the pass after it
    CHECK_FALSE(it.asks(behind));
    it.be_answered();
    // The asker is gone. Those that come by before it in each pass do not take its turn.
    for (unsigned pass = 0; pass < 2; ++pass) {
        CHECK_FALSE(it.asks(before));
        CHECK(it.asks(behind) == (pass == 1));
    }
}

TEST_CASE("rule 21: a request that waits is not ended by one who finds its asker missing once")
{
    desk it;
    plain_asker away{1};
    plain_asker other{2};
    it.on_line_activity();
    REQUIRE(it.asks(away)); // it waits for silence
    it.pass(10'000);
    CHECK_FALSE(it.asks(other));
    it.pass(1);
    CHECK_FALSE(it.asks(away)); // its request may leave
    it.be_answered();
    it.link.converse(away, it.now());
    CHECK(away.answered == 1);
}
