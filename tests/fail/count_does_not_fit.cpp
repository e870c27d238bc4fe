// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// A count in parentheses that has more bits than the type: it would wrap round to another speed.
// EXPECT: this_amount_does_not_fit_the_target
#include <rtuwire/core/units.hpp>

using namespace rtuwire;

std::uint16_t steps()
{
#ifdef REFUSED
    constexpr decihertz wanted(70'000);
#else
    constexpr decihertz wanted(60'000);
#endif
    return wanted.count();
}
