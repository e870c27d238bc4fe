// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Noise that the receiver reports as a damaged byte, before a response.
#include "client_line.hpp"

#include "support/catch.hpp"

using namespace rtuwire;
using namespace rtuwire::test;

namespace {

/// What came of a request where so many damaged bytes come just before its response.
series after_damage(unsigned damaged, std::uint8_t skipped, bool is_own_damaged = false)
{
    client_options const once{.response_timeout = milliseconds(100), .retries = 0, .max_leading_noise = skipped};
    scripted_line<client> line{client{office_line, once}, office_line};
    series conversation{[](unsigned) { return read_of(1, 3201); }, 1};
    line.heard = [&](frame_bytes const& frame) {
        std::uint64_t when = line.time() + 5'000;
        for (unsigned i = 0; i < damaged; ++i) {
            line.arrive(when += line.length_of(1), {});
        }
        frame_bytes const response = response_to(frame);
        for (std::size_t i = is_own_damaged ? 1 : 0; i < response.size(); ++i) {
            line.arrive(when += line.length_of(1), {response[i]});
        }
    };
    line.run(1'000'000, [&](instant now) { line.link.converse(conversation, now); });
    conversation.make = {};
    return conversation;
}

} // namespace

TEST_CASE("defect: (e) noise that the receiver reports as damaged is skipped like any other")
{
    CHECK(after_damage(1, 1).answered == 1);
    CHECK(after_damage(2, 2).answered == 1);
    CHECK(after_damage(2, 3).answered == 1);
}

TEST_CASE("defect: (e) no more damaged bytes are skipped than wanted, and no byte of the response")
{
    CHECK(after_damage(1, 0).answered == 0);
    CHECK(after_damage(3, 2).answered == 0);
    for (std::uint8_t skipped = 0; skipped < 3; ++skipped) {
        series const conversation = after_damage(1, skipped, true);
        CHECK(conversation.number == 1);
        CHECK(conversation.answered == 0);
    }
}
