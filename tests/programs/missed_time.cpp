// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// How a program notices that it did not run.
#include "support/catch.hpp"

#include <chrono>

#include "../../tools/support/missed_time.hpp"

using tool::missed_time;
using namespace std::chrono_literals;

TEST_CASE("motion law: S37 a clock that jumped by more than a third of the time-out is noticed once")
{
    constexpr std::chrono::nanoseconds third = 3s;
    missed_time watch{third, 100s};
    CHECK_FALSE(watch.is_too_long(100s + 10ms));
    CHECK_FALSE(watch.is_too_long(103s + 10ms));
    CHECK(watch.is_too_long(106s + 11ms));
    CHECK_FALSE(watch.is_too_long(106s + 20ms));
    // Longer than a clock of 32 bits of microseconds takes to come round.
    CHECK(watch.is_too_long(106s + 20ms + 4'294'967'296us));
}

TEST_CASE("motion law: S37 a clock that goes back is taken for a jump")
{
    missed_time watch{3s, 100s};
    CHECK(watch.is_too_long(99s));
}

TEST_CASE("motion law: S37 the clock that is asked goes on by itself")
{
    auto const before = rtuwire::host_time();
    missed_time watch{3s};
    CHECK_FALSE(watch.is_too_long());
    CHECK(rtuwire::host_time() >= before);
    CHECK(before > 0s);
}
