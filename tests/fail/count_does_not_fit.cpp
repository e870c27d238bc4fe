// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// A count in parentheses that has more bits than the type: it would wrap round to another speed.
// EXPECT: this_amount_does_not_fit_the_target
#include <rtuwire/core/units.hpp>

using namespace rtuwire;

std::uint16_t steps()
{
#ifdef REFUSED
    return decihertz(70'000).count();
#else
    return decihertz(60'000).count();
#endif
}
