// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// What 0.1 Hz is in rpm, and whether a drive was told a guess of it: against numbers worked out by hand.
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

constexpr std::uint16_t minus_1 = 0xFFFF, minus_6 = 0xFFFA;
constexpr bool is_guessed(std::uint16_t per_hertz, std::uint16_t told, std::uint16_t asked, bool is_speed = true)
{
    reference_limits limits{};
    limits.per_hertz = per_hertz;
    return limits.is_guessed({8602, told, is_speed}, {8602, asked, is_speed});
}

STATIC_CHECK(is_guessed(0, minus_6, minus_1));
STATIC_CHECK(not is_guessed(0, minus_6, minus_6));
STATIC_CHECK(not is_guessed(1, minus_6, minus_1)); // it was read: as many steps of the drive
STATIC_CHECK(not is_guessed(60, minus_6, minus_1));
STATIC_CHECK(not is_guessed(0, minus_6, minus_1, false));

} // namespace
