// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// A listener on lines whose traffic is known: each frame is said to be what it was, by exact times, in the lumps of an
// adapter, and behind damage.
#include <rtuwire/trace/line_listener.hpp>

#include <algorithm>
#include <map>
#include <vector>

#include "support/catch.hpp"
#include "trace/listener/heard_list.hpp"
#include "trace/listener/made_exchange.hpp"
#include "trace/listener/made_line.hpp"

using namespace rtuwire;
using namespace listening;

TEST_CASE("a listener says of every frame on a good line what it is")
{
    for (std::uint32_t seed = 1; seed <= 20; ++seed) {
        made_line line{seed};
        for (int i = 0; i < 300; ++i) {
            line.add_any();
        }
        heard_list const heard = hear_by_bytes(line);
        INFO("seed " << seed);
        REQUIRE(first_difference(heard.frames, line.truth()) == "");
        REQUIRE(heard.unanswered == line.unanswered());
        REQUIRE(heard.damaged_bytes == 0);
    }
}

TEST_CASE("a listener behind an adapter that lumps bytes says the same of all that has a length rule")
{
    for (unsigned const lump : {1U, 4U, 16U}) {
        for (std::uint32_t seed = 1; seed <= 20; ++seed) {
            made_line line{seed};
            for (int i = 0; i < 300; ++i) {
                line.add_with_rule();
            }
            heard_list const heard = hear_in_lumps(line, milliseconds(lump));
            INFO("seed " << seed << ", lumps of " << lump << " ms");
            REQUIRE(first_difference(heard.frames, line.truth()) == "");
            REQUIRE(heard.damaged_bytes == 0);
        }
    }
}

TEST_CASE("behind damage, noise and a join in the middle a listener is right again after the next silence")
{
    std::size_t right = 0;
    for (std::uint32_t seed = 1; seed <= 40; ++seed) {
        made_line line{seed};
        for (int i = 0; i < 200; ++i) {
            line.add_any();
        }
        line.damage_bytes(100);
        line.add_noise();
        line.cut_front();
        heard_list const heard = hear_by_bytes(line);
        INFO("seed " << seed);
        // What was not damaged is there, in its order and with its request.
        auto at = heard.frames.begin();
        for (heard_entry const& each : line.whole_truth()) {
            at = std::find(at, heard.frames.end(), each);
            REQUIRE(at != heard.frames.end());
            ++right;
        }
    }
    CHECK(right > 5'000);
}

TEST_CASE("requests in one lump just behind another one waited for no negative time")
{
    exchange_maker maker{7};
    line_listener tap{line_timing::host(19'200, character_format::even_8_1), milliseconds(300)};
    std::vector<duration> waited;
    auto const take = [&](heard_frame const& it) {
        if (it.is_unanswered) {
            waited.push_back(it.response_time);
        }
    };
    auto const first = maker.make(5, 3, false).request;
    auto lump = maker.make(6, 3, false).request;
    auto const last = maker.make(7, 3, false).request;
    lump.insert(lump.end(), last.begin(), last.end());
    tap.receive(first, instant{1'000'000}, take);
    tap.receive(lump, instant{1'001'000}, take);
    REQUIRE(waited.size() == 2);
    CHECK(waited[0] == duration{});
    CHECK(waited[1] < milliseconds(10));
}

TEST_CASE("a response after its time is late, and has its request")
{
    exchange_maker maker{7};
    made_exchange const made = maker.make(5, 3, false);
    heard_list heard;
    line_listener tap{line_timing{19'200, character_format::even_8_1}, milliseconds(300)};
    auto const take = [&heard](heard_frame const& it) { heard.take(it); };
    tap.receive(made.request, instant{1'000'000}, take);
    tap.advance(instant{1'400'000}, take);
    CHECK(heard.unanswered == 1);
    tap.receive(made.response, instant{1'500'000}, take);
    REQUIRE(heard.frames.size() == 2);
    CHECK(heard.frames[1].verdict == frame_verdict::late);
    CHECK(heard.frames[1].request == made.request);
}

TEST_CASE("a response time runs from the last byte of the request to the first of the response")
{
    exchange_maker maker{8};
    made_exchange const made = maker.make(5, 3, false);
    line_timing const timing{19'200, character_format::even_8_1};
    line_listener tap{timing};
    duration seen{};
    auto const take = [&seen](heard_frame const& it) { seen = it.response_time; };
    tap.receive(made.request, instant{1'000'000}, take);
    instant at = instant{1'000'000} + milliseconds(5);
    for (std::byte const each : made.response) {
        tap.receive({&each, 1}, at, take);
        at = at + timing.characters(1);
    }
    CHECK(seen == milliseconds(5));
}

TEST_CASE("a byte that arrived damaged spoils its frame and no other")
{
    exchange_maker maker{9};
    made_exchange const one = maker.make(5, 3, false);
    made_exchange const other = maker.make(6, 3, false);
    heard_list heard;
    line_listener tap{line_timing{19'200, character_format::even_8_1}};
    auto const take = [&heard](heard_frame const& it) { heard.take(it); };
    instant at{1'000'000};
    auto const hear = [&](bytes const& all) { tap.receive(all, at, take), at = at + milliseconds(200); };
    bytes const half{one.request.begin(), one.request.begin() + 4};
    bytes const rest{one.request.begin() + 5, one.request.end()};
    tap.receive(half, at, take);
    tap.receive_error(at, take);
    hear(rest);
    tap.advance(at, take);
    CHECK(heard.damaged_bytes == 7);
    hear(other.request);
    hear(other.response);
    REQUIRE(heard.frames.size() == 2);
    CHECK(heard.frames[1].request == other.request);
    // One that is damaged in front of a frame, with nothing before it, is over with the silence.
    tap.receive_error(at, take);
    at = at + milliseconds(200);
    hear(one.request);
    CHECK(heard.frames.size() == 3);
}
