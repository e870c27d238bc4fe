// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Responses in pieces, with pauses as a network makes them: where nothing is lost silence means nothing.
#include "client_line.hpp"

#include "support/catch.hpp"

#include <rtuwire/client/bus.hpp>

using namespace rtuwire;
using namespace rtuwire::detail;
using namespace rtuwire::test;

namespace {

constexpr client_options once{.response_timeout = milliseconds(1'000), .retries = 0};
constexpr line_timing of_network = line_timing::without_wire().with_silence(milliseconds(5));
constexpr line_timing of_host = line_timing::host(9'600, character_format::none_8_1);

/// How a request ends whose response comes in pieces of `size` bytes, each `pause` microseconds behind the one before.
template <typename Link = client>
errc outcome(line_timing const& timing, frame_bytes const& asked, frame_bytes const& said, std::size_t size,
             std::uint64_t pause)
{
    scripted_line<Link> line{Link{timing, once}, timing};
    line.heard = [&](frame_bytes const&) {
        std::uint64_t after = 5'000;
        for (std::size_t at = 0; at < said.size(); at += size) {
            std::size_t const end = std::min(at + size, said.size());
            line.say(after,
                     {said.begin() + static_cast<std::ptrdiff_t>(at), said.begin() + static_cast<std::ptrdiff_t>(end)});
            after += pause;
        }
    };
    series conversation{[&](unsigned) { return asked; }, 1};
    line.run(2'500'000, [&](instant now) {
        if constexpr (requires { line.link.converse(conversation, now); }) {
            line.link.converse(conversation, now);
        } else {
            line.link.converse(0, conversation, now);
        }
    });
    REQUIRE(conversation.number == 1);
    CHECK(line.spinning < 3);
    return conversation.last;
}

/// A page of identification: its objects tell its end.
frame_bytes page() { return framed({5, 43, 14, 1, 1, 0, 0, 2, 0, 3, 'a', 'b', 'c', 1, 4, 'd', 'e', 'f', 'g'}); }

struct exchange {
    frame_bytes asked, said;
    errc good{errc::none};
};

std::vector<exchange> exchanges()
{
    frame_bytes const two = read_of(1, 0, 2);
    frame_bytes const many = read_of(3, 100, 60);
    return {{two, framed({1, 3, 4, 0, 1, 0, 2})}, // W19
            {many, response_to(many)},
            {write_of(7, 8501, 15), write_of(7, 8501, 15)},
            {framed({9, 1, 0, 0, 0, 9}), framed({9, 1, 2, 3, 1})},
            {framed({5, 43, 14, 1, 0}), page()},
            {framed({2, 24, 0, 9}), framed({2, 24, 0, 4, 0, 1, 1, 2})},
            {two, framed({1, 0x83, 2}), errc::illegal_data_address}};
}

} // namespace

TEST_CASE("defect: D37 without a wire a response of known length may come in pieces")
{
    for (exchange const& each : exchanges()) {
        for (std::size_t const size : {std::size_t{1}, std::size_t{4}, each.said.size() - 1}) {
            std::uint64_t const parts = (each.said.size() + size - 1) / size;
            std::uint64_t const pause = std::min<std::uint64_t>(120'000, 900'000 / parts);
            INFO("function " << at(each.asked, 1) << ", " << size << " bytes each " << pause << " us");
            CHECK(outcome(of_network, each.asked, each.said, size, pause) == each.good);
            CHECK(outcome<bus<2>>(of_network, each.asked, each.said, size, pause) == each.good);
        }
        CHECK(outcome(of_network, each.asked, each.said, each.said.size() - 1, 900'000) == each.good);
        CHECK(outcome(of_network, each.asked, each.said, each.said.size() - 1, 1'100'000) == errc::timed_out);
        if (each.good == errc::none) { // on a wire 120 ms are silence
            CHECK(outcome(of_host, each.asked, each.said, 4, 120'000) == errc::crc_mismatch);
        }
    }
}

TEST_CASE("defect: D37 what has no length, or the wrong CRC, ends by silence without a wire too")
{
    // Of a function without a rule, of a byte count that is too large, damaged, and a beginning of nothing.
    frame_bytes const asked = framed({1, 0x41, 5});
    CHECK(outcome(of_network, asked, framed({1, 0x41, 7, 8, 9}), 99, 0) == errc::none);
    CHECK(outcome(of_network, asked, framed({1, 0x41, 7, 8, 9}), 4, 120'000) != errc::none);
    frame_bytes damaged = framed({1, 3, 4, 0, 1, 0, 2});
    damaged[4] ^= std::byte{1};
    scripted_line<client> line{client{of_network, {.response_timeout = milliseconds(1'000), .retries = 1}}, of_network};
    line.heard = [&](frame_bytes const&) {
        line.say(5'000, line.departures.size() == 1 ? damaged : framed({1, 3, 4, 0, 1, 0, 2}));
    };
    series conversation{[](unsigned) { return read_of(1, 0, 2); }, 1};
    line.run(2'500'000, [&](instant now) { line.link.converse(conversation, now); });
    CHECK(conversation.last == errc::none);
    REQUIRE(line.departures.size() == 2);
    CHECK(line.departures[1].begin - line.departures[0].end < 200'000);
}

TEST_CASE("defect: D37 a request that was given up leaves nothing of its response for the next")
{
    for (bool const is_cancelled : {false, true}) {
        scripted_line<client> line{client{of_network, once}, of_network};
        line.heard = [&](frame_bytes const& frame) {
            line.say(5'000, line.departures.size() == 1 ? frame_bytes{std::byte{1}, std::byte{3}, std::byte{20}}
                                                        : response_to(frame));
        };
        series conversation{[](unsigned number) { return read_of(1, 7, 10 - number); }, 2};
        std::uint64_t const began = line.time();
        line.run(6'000'000, [&](instant now) {
            if (is_cancelled and line.departures.size() == 1 and line.time() > began + 100'000) {
                line.link.cancel(now);
            }
            line.link.converse(conversation, now);
        });
        CHECK(conversation.number == 2);
        CHECK(conversation.answered == 1);
        CHECK(line.spinning < 3);
    }
}
