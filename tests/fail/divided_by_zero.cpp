// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Amounts that no type holds, in constant expressions: divided by 0, and beyond 64 bits.
// EXPECT: amount
// CASES: 3
#include <rtuwire/core/units.hpp>

using namespace rtuwire;

constexpr auto longest = 9'223'372'036'854'775'806_s;
#if not defined(REFUSED)
constexpr auto half = longest / 2;
static_assert(half.count() == 4'611'686'018'427'387'903);
#elif REFUSED == 1
constexpr auto half = longest / 0;
#elif REFUSED == 2
constexpr auto twice = longest * 2;
#else
constexpr auto more = longest + 0.1_s;
#endif
