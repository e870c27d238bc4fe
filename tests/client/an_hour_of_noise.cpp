// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Noise for an hour: every request ends in time, nothing of it is a value, and the first good exchange
// after it is one.
#include <rtuwire/client/client.hpp>

#include <array>

#include "support/catch.hpp"
#include "support/manual_unit.hpp"
#include "support/random.hpp"

using namespace rtuwire;
using test::manual_unit;
using test::read_eta;
using test::response_1234;

TEST_CASE("after an hour of noise the first good exchange succeeds")
{
    constexpr client_options patient{.response_timeout = milliseconds(100), .retries = 1};
    constexpr std::uint32_t longest_us = 3'000'000;
    manual_unit unit{patient};
    test::random random{7};
    std::uint64_t passed = 0;
    unsigned values = 0;
    std::uint32_t waited = 0;
    while (passed < 3'600'000'000U) {
        static_cast<void>(unit.link.start(request_frame{read_eta}, unit.now));
        std::array<std::byte, 32> noise{};
        random.fill(noise);
        instant const before = unit.now;
        unit.say(byte_view{noise}.first(1 + random.below(32)));
        unit.run(milliseconds(random.below(40)));
        std::uint32_t const took = (unit.now - before).microseconds;
        passed += took;
        waited += took;
        if (auto const outcome = unit.link.poll_outcome()) {
            values += outcome->has_value() ? 1U : 0U;
            waited = 0;
        }
        REQUIRE(waited < longest_us);
    }
    CHECK(values == 0);
    unit.run(milliseconds(1'000));
    static_cast<void>(unit.link.poll_outcome());
    unit.run(milliseconds(1'000));
    REQUIRE(unit.ask(read_eta));
    unit.say(response_1234);
    CHECK(unit.has(0x1234));
}
