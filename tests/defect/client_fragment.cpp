// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// A piece of a response, or noise that looks like the start of one, is no response: the unit may still owe the whole,
// and it is waited for before the unit is asked anything else.
#include "client_line.hpp"

#include "support/catch.hpp"

using namespace rtuwire;
using namespace rtuwire::test;

namespace {

constexpr std::uint64_t time_out = 100'000;
constexpr std::uint64_t late = 200'000;
constexpr client_options once{.response_timeout = milliseconds(100), .late_response = milliseconds(200), .retries = 0};

/// A unit that says this 5 ms after each request, and the response itself 290 ms after it.
struct stammering {
    scripted_line<client> line;
    series conversation;
    unsigned wrong{0};

    stammering(frame_bytes const& piece, client_options const& options)
        : line{client{office_line, options}, office_line}, conversation{[](unsigned number) {
                                                                            return read_of(1, 3201 + number);
                                                                        },
                                                                        2}
    {
        line.heard = [this, piece](frame_bytes const& frame) {
            line.say(5'000, piece);
            line.say(290'000, response_to(frame));
        };
        conversation.took = [this](unsigned number, result<response> const& outcome) {
            wrong += outcome and u16_at(outcome->pdu(), 2) != 3201 + number ? 1U : 0U;
        };
        line.run(3'000'000, [this](instant now) { line.link.converse(conversation, now); });
    }
};

frame_bytes cut(frame_bytes const& whole, std::size_t size)
{
    return {whole.begin(), whole.begin() + static_cast<std::ptrdiff_t>(size)};
}

} // namespace

TEST_CASE("defect: A4 a piece of an answer pays no debt, so that the late answer is nobody else's")
{
    frame_bytes const value = response_to(read_of(1, 3201));
    frame_bytes const refusal = framed({1, 0x83, 2});
    REQUIRE(value.size() == 7);
    std::vector<frame_bytes> pieces{cut(refusal, 4)};
    for (std::size_t size = 4; size < value.size(); ++size) {
        pieces.push_back(cut(value, size));
    }
    for (frame_bytes const& piece : pieces) {
        INFO("a piece of " << piece.size() << " bytes");
        stammering it{piece, once};
        CHECK(it.wrong == 0);
        REQUIRE(it.line.departures.size() == 2);
        std::uint64_t const sent = it.line.departures[0].end;
        // The time of the longest response, seven bytes, and what comes on top of it.
        std::uint64_t const owed = sent + time_out + it.line.length_of(7) + late;
        CHECK(it.line.departures[1].begin >= owed);
        CHECK(it.line.departures[1].begin <= owed + 5'000);
    }
}

TEST_CASE("defect: A4 a piece of an answer is not worth an early repetition")
{
    client_options options = once;
    options.retries = 1;
    stammering const it{cut(response_to(read_of(1, 3201)), 5), options};
    REQUIRE(it.line.departures.size() >= 2);
    CHECK(it.line.departures[1].begin >= it.line.departures[0].end + time_out);
}

TEST_CASE("defect: A4 a damaged answer of the size that it tells is one")
{
    frame_bytes damaged = response_to(read_of(1, 3201));
    damaged[4] = damaged[4] ^ std::byte{1};
    scripted_line<client> line{client{office_line, once}, office_line};
    series conversation{[](unsigned number) { return read_of(1, 3201 + number); }, 2};
    line.heard = [&](frame_bytes const& frame) {
        line.say(5'000, line.departures.size() == 1 ? damaged : response_to(frame));
    };
    line.run(1'000'000, [&](instant now) { line.link.converse(conversation, now); });
    CHECK(conversation.answered == 1);
    REQUIRE(line.departures.size() == 2);
    CHECK(line.departures[1].begin < line.departures[0].end + 50'000);
}
