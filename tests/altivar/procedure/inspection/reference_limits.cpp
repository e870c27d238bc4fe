// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// What 0.1 Hz is in rpm, and whether a drive was told a guess of it; which limit it keeps to: against numbers worked out by hand.
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

/// LSP 10.0 Hz and HSP 10.1 Hz of a motor of two pairs of poles: 300 and 303 rpm.
constexpr reference_limits narrow{100, 101, 60, 2};
constexpr reference_write hertz(std::uint16_t word) { return {401, word}; }
constexpr reference_write rpm(std::uint16_t word) { return {8602, word, true}; }

STATIC_CHECK(narrow.kept_for(hertz(99)) == 100 and narrow.kept_for(hertz(102)) == 101);
STATIC_CHECK(narrow.kept_for(rpm(299)) == 100 and narrow.kept_for(rpm(304)) == 101);
STATIC_CHECK(narrow.kept_for(hertz(0xFF9D)) == 100 and narrow.kept_for(rpm(0xFED0)) == 101); // -99 and -304
STATIC_CHECK(reference_limits{}.kept_for(hertz(99)) == 0);
STATIC_CHECK(reference_limits{.per_hertz = 60, .pairs = 2}.kept_for(rpm(299)) == 0);
STATIC_CHECK(reference_limits{.lowest = 100, .highest = 101}.kept_for(rpm(299)) == 0);

} // namespace
