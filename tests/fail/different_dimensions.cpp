// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Quantities of two dimensions compared, added and subtracted.
// EXPECT: these two measure different things
// CASES: 5
#include <rtuwire/altivar/atv12.hpp>

using namespace rtuwire;

#if not defined(REFUSED)
bool is_too_much(deciamperes now, deciamperes limit) { return now > limit; }
auto rest(deciamperes now) { return 3_A - now + 0.1_A; }
#elif REFUSED == 1
bool is_too_much(deciamperes now, decihertz limit) { return now > limit; }
#elif REFUSED == 2
bool is_too_much(deciamperes now) { return now >= 50_Hz; }
#elif REFUSED == 3
bool is_the_same(deciamperes now) { return now == 50_Hz; }
#elif REFUSED == 4
auto rest(deciamperes now) { return 50_Hz - now; }
#else
auto sum(deciamperes now) { return now + 50_Hz; }
#endif
