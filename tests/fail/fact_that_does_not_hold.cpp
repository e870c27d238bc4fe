// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// A proof names the fact that does not hold.
// EXPECT: this_fact_does_not_hold
// EXPECT: two and two are four
#include "../support/fact.hpp"

namespace {

#ifdef REFUSED
constexpr int sum = 5;
#else
constexpr int sum = 4;
#endif

constexpr bool adds()
{
    using rtuwire::test::is;
    return is(sum > 0, "a sum is above zero") and is(2 + 2 == sum, "two and two are four");
}
static_assert(adds());

} // namespace
