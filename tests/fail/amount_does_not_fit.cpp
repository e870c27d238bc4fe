// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// An amount that has more steps than the type has numbers.
// EXPECT: this_amount_does_not_fit_the_target
#include <rtuwire/core/units.hpp>

using namespace rtuwire;

#ifdef REFUSED
constexpr decihertz top = truncated_to<decihertz>(hertz{7'000});
#else
constexpr decihertz top = truncated_to<decihertz>(hertz{6'000});
#endif
static_assert(top.count() == 60'000);
