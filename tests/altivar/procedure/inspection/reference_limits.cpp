// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// What 0.1 Hz is in rpm: against numbers worked out by hand.
#include <rtuwire/altivar/procedure/inspection/reference_limits.hpp>

#include "support/proof.hpp"

using namespace rtuwire;
using namespace rtuwire::altivar;

namespace {

constexpr std::uint16_t least_of(std::uint16_t per_hertz, std::uint16_t pairs)
{
    reference_limits limits{};
    limits.per_hertz = per_hertz;
    limits.pairs = pairs;
    return limits.least_speed();
}

STATIC_CHECK(reference_limits{}.least_speed() == 6);
STATIC_CHECK(least_of(60, 1) == 6);
STATIC_CHECK(least_of(60, 2) == 3);
STATIC_CHECK(least_of(60, 4) == 2); // 1.5
STATIC_CHECK(least_of(110, 1) == 11);
STATIC_CHECK(least_of(111, 1) == 12);

} // namespace
