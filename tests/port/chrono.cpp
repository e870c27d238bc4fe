// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Between our time and std::chrono's.
#include <rtuwire/port/chrono.hpp>

#include "support/proof.hpp"

using namespace rtuwire;
using namespace rtuwire::detail;
using namespace std::chrono_literals;

namespace {

STATIC_CHECK(to_duration(1500us) == microseconds(1'500));
STATIC_CHECK(to_duration(2s) == milliseconds(2'000));
STATIC_CHECK(to_duration(1999ns) == microseconds(1));
STATIC_CHECK(to_duration(-1s) == duration{});
STATIC_CHECK(to_duration(35min) == longest_duration);
STATIC_CHECK(to_chrono(milliseconds(5)) == 5ms);

} // namespace

TEST_CASE("a time of std::chrono that is too long becomes the longest")
{
    int const volatile hours = 24;
    CHECK(to_duration(std::chrono::hours{hours}) == longest_duration);
}

TEST_CASE("the steady clock does not go back")
{
    instant const before = steady_now();
    instant const after = steady_now();
    CHECK(reached(after, before));
}
