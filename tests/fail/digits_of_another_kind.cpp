// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// A quantity that is not written in decimal digits: its digits would be counted as if it were.
// EXPECT: a quantity is written in decimal digits, as 50 or 1.3
// CASES: 4
#include <rtuwire/core/units.hpp>

using namespace rtuwire;

#if not defined(REFUSED)
constexpr auto amount = 1'250.9_Hz;
#elif REFUSED == 1
constexpr auto amount = 1e3_Hz;
#elif REFUSED == 2
constexpr auto amount = 0x50_Hz;
#elif REFUSED == 3
constexpr auto amount = 0b101_Hz;
#else
constexpr auto amount = 1.5e-1_Hz;
#endif
static_assert(amount.count() > 0);
