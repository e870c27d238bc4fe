// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// A conversation that stays away while its request is under way loses it to the others on the line. When it comes
// by later it is told so, once, and sends nothing of its own accord that may be sent only once.
#include "client_line.hpp"

#include "support/catch.hpp"

#include <rtuwire/client/bus.hpp>

using namespace rtuwire;
using namespace rtuwire::detail;
using namespace rtuwire::test;

namespace {

constexpr client_options once{.response_timeout = milliseconds(100), .retries = 0};

/// Writes a value that may be sent once, keeps asking for it until it is told something, and keeps what it is told.
struct careful : asker {
    frame_bytes frame;
    std::vector<errc> told{};

    explicit careful(unsigned unit) : frame{write_of(unit, 8602, 500)} {}
    std::optional<request_frame> next() const
    {
        return settled() ? std::nullopt : std::optional{request_frame{frame, repetition::never}};
    }
    void accept(result<response> const& outcome) { told.push_back(outcome.error()); }
    bool settled() const { return not told.empty(); }
};

/// A bus whose first two slots come by, or whose urgent conversation and second slot do.
struct urgent_bus : bus<2> {
    using bus<2>::bus;
};

template <typename Conversation> void converse(client& link, std::size_t, Conversation& conversation, instant now)
{
    link.converse(conversation, now);
}
template <typename Conversation> void converse(bus<2>& link, std::size_t index, Conversation& conversation, instant now)
{
    link.converse(index, conversation, now);
}
template <typename Conversation>
void converse(urgent_bus& link, std::size_t index, Conversation& conversation, instant now)
{
    if (index == 0) {
        link.run_urgent(conversation, now);
    } else {
        link.converse(index, conversation, now);
    }
}

/// What became of one write whose conversation goes away after so long, and comes back after a second.
struct life {
    std::vector<errc> told;
    std::ptrdiff_t sent;
    unsigned others;
};

template <typename Link> life away_after(std::uint64_t stays, bool answers, bool is_busy_line)
{
    scripted_line<Link> line{Link{office_line, once}, office_line};
    careful conversation{1};
    series other{[](unsigned) { return read_of(2, 3201); }};
    line.heard = [&](frame_bytes const& frame) {
        if (answers or at(frame, 0) != 1) {
            line.say(5'000, response_to(frame));
        }
    };
    if (is_busy_line) {
        line.link.receive(frame_bytes{std::byte{0x55}}, line.now());
    }
    std::uint64_t const start = line.time();
    line.alarm = start + 1'000'000;
    line.run(2'000'000, [&](instant now) {
        if (line.time() <= start + stays or line.time() >= line.alarm) {
            converse(line.link, 0, conversation, now);
        }
        if (line.time() > start + stays) {
            converse(line.link, 1, other, now);
        }
    });
    auto const sent = std::count_if(line.departures.begin(), line.departures.end(),
                                    [&](departure const& each) { return each.frame == conversation.frame; });
    return {conversation.told, sent, other.answered};
}

template <typename Link> void is_told_once()
{
    for (bool const answers : {true, false}) {
        // Away before the response, or the time-out, is there.
        for (std::uint64_t stays = 0; stays <= 12'000; stays += 1'000) {
            INFO((answers ? "answered" : "not answered") << ", away after " << stays << " us");
            life const found = away_after<Link>(stays, answers, false);
            CHECK(found.told == std::vector{errc::cancelled});
            CHECK(found.sent == 1);
            CHECK(found.others > 40);
        }
    }
    // Away before the line lets the request leave: then it never does.
    for (std::uint64_t stays = 0; stays < 2'000; stays += 500) {
        INFO("on a busy line, away after " << stays << " us");
        life const found = away_after<Link>(stays, true, true);
        CHECK(found.told == std::vector{errc::cancelled});
        CHECK(found.sent == 0);
        CHECK(found.others > 40);
    }
}

} // namespace

TEST_CASE("defect: A2 a client tells an asker that was away that its request was dropped, once")
{
    is_told_once<client>();
}

TEST_CASE("defect: A2 a bus tells an asker that was away that its request was dropped, once")
{
    is_told_once<bus<2>>();
}

TEST_CASE("defect: A2 a bus tells its urgent conversation that was away the same") { is_told_once<urgent_bus>(); }

TEST_CASE("defect: A2 an asker that was away while nobody else came by gets its outcome")
{
    scripted_line<client> line{client{office_line, once}, office_line};
    careful conversation{1};
    line.heard = [&](frame_bytes const& frame) { line.say(5'000, response_to(frame)); };
    line.run(2'000, [&](instant now) { line.link.converse(conversation, now); });
    line.run(1'000'000, [](instant) {});
    line.run(2'000, [&](instant now) { line.link.converse(conversation, now); });
    CHECK(conversation.told == std::vector{errc::none});
    CHECK(line.departures.size() == 1);
}

namespace {

/// The other comes by until the request is dropped, and no more.
template <typename Link> life comes_back_alone(bool is_busy_line)
{
    scripted_line<Link> line{Link{office_line, once}, office_line};
    careful conversation{1};
    series other{[](unsigned) { return read_of(2, 3201); }};
    line.heard = [&](frame_bytes const& frame) { line.say(5'000, response_to(frame)); };
    if (is_busy_line) {
        line.link.receive(frame_bytes{std::byte{0x55}}, line.now());
    }
    bool has_asked = false;
    bool is_dropped = false;
    line.run(1'000'000, [&](instant now) {
        if (not has_asked or is_dropped) {
            converse(line.link, 0, conversation, now);
            has_asked = true;
        } else {
            converse(line.link, 1, other, now);
            is_dropped = not line.link.is_busy() or other.number > 0;
        }
    });
    auto const sent = std::count_if(line.departures.begin(), line.departures.end(),
                                    [&](departure const& each) { return each.frame == conversation.frame; });
    return {conversation.told, sent, other.number};
}

} // namespace

TEST_CASE("defect: A2 an asker that comes back before anybody else has asked is told the same")
{
    for (bool const is_busy_line : {false, true}) {
        INFO((is_busy_line ? "on a busy line" : "on a quiet line"));
        life const found = comes_back_alone<client>(is_busy_line);
        CHECK(found.told == std::vector{errc::cancelled});
        CHECK(found.sent == (is_busy_line ? 0 : 1));
    }
}

TEST_CASE("defect: H1 who is told that its request was dropped asks again, also where another's outcome lay there")
{
    scripted_line<client> line{client{office_line, once}, office_line};
    series away{[](unsigned number) { return read_of(1, 3201 + number); }, 2};
    series other{[](unsigned) { return read_of(2, 3201); }, 1};
    line.heard = [&](frame_bytes const& frame) { line.say(5'000, response_to(frame)); };
    line.run(2'000, [&](instant now) { line.link.converse(away, now); });
    line.run(1'000'000, [&](instant now) {
        if (line.departures.size() < 2) {
            line.link.converse(other, now);
        }
    });
    REQUIRE(line.departures.size() == 2);
    // The one that was dropped comes by first; the loop sleeps as long as the client says.
    line.run(1'000'000, [&](instant now) {
        line.link.converse(away, now);
        line.link.converse(other, now);
    });
    CHECK(other.answered == 1);
    CHECK(away.number == 2); // cancelled, and a response
    CHECK(away.answered == 1);
    CHECK(line.spinning <= 3);
}

TEST_CASE("defect: H2 a client that is set up anew in its place gives nobody the outcome of another")
{
    scripted_line<client> line{client{office_line, once}, office_line};
    series before{[](unsigned) { return read_of(1, 100); }, 1};
    series after{[](unsigned) { return read_of(1, 200); }, 1};
    std::vector<unsigned> values{};
    after.took = [&](unsigned, result<response> const& outcome) {
        values.push_back(outcome ? static_cast<unsigned>(outcome->pdu()[3]) : 0);
    };
    line.link.converse(before, line.now());
    line.link = client{office_line, once};
    line.link.advance(line.now());
    line.heard = [&](frame_bytes const& frame) { line.say(5'000, response_to(frame)); };
    line.run(1'000'000, [&](instant now) {
        line.link.converse(after, now);
        line.link.converse(before, now);
    });
    CHECK(before.last == errc::cancelled);
    CHECK(values == std::vector{200U});
}
