// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// What a result equals, and what it does not.
#include <rtuwire/core/result.hpp>

#include "support/catch.hpp"

#include <rtuwire/wire/raw.hpp>

using namespace rtuwire;

TEST_CASE("a result equals its like, its value or its error, and nothing else")
{
    result<int> const three{3}, four{4}, again{3};
    result<int> const busy{errc::busy}, late{errc::timed_out}, busy_too{errc::busy};
    CHECK((three == again));
    CHECK_FALSE((three == four));
    CHECK_FALSE((three == busy));
    CHECK((busy == busy_too));
    CHECK_FALSE((busy == late));
    CHECK((three == 3));
    CHECK_FALSE((three == 4));
    CHECK_FALSE((busy == 3));
    CHECK((busy == errc::busy));
    CHECK_FALSE((busy == errc::timed_out));
    CHECK_FALSE((three == errc::busy));
    CHECK(three.value_or(7) == 3);
    CHECK(busy.value_or(7) == 7);
    result<void> const done{}, failed{errc::busy};
    CHECK_FALSE((done == errc::busy));
    CHECK_FALSE((done == errc::none));
    CHECK((failed == errc::busy));
    CHECK_FALSE((failed == errc::timed_out));
}

TEST_CASE("a result equals a number of another type only where that is its value")
{
    result<std::uint16_t> const some{4'464};
    CHECK((some == 4'464L));
    CHECK_FALSE((some == 70'000)); // 4'464, cut off to 16 bits
    CHECK_FALSE((result<std::uint16_t>{errc::busy} == 0));
}

TEST_CASE("raw PDUs differ by function and by data")
{
    constexpr std::array<std::byte, 2> one{std::byte{1}}, two{std::byte{2}};
    raw_pdu const first{static_cast<function_code>(0x41), one};
    CHECK((first == raw_pdu{static_cast<function_code>(0x41), one}));
    CHECK_FALSE((first == raw_pdu{static_cast<function_code>(0x42), one}));
    CHECK_FALSE((first == raw_pdu{static_cast<function_code>(0x41), two}));
}
