// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// A number without a unit compared with a quantity, or added to it.
// EXPECT: a plain number is no amount: give it a unit, as in 50_Hz
// CASES: 5
#include <rtuwire/altivar/atv12.hpp>

using namespace rtuwire;

#if not defined(REFUSED)
bool is_fast(decihertz now) { return now > 50_Hz; }
#elif REFUSED == 1
bool is_fast(decihertz now) { return now > 500; }
#elif REFUSED == 2
bool is_fast(decihertz now) { return 500 < now; }
#elif REFUSED == 3
bool is_fast(decihertz now) { return now == 500; }
#elif REFUSED == 4
auto faster(decihertz now) { return now + 10; }
#else
auto slower(decihertz now) { return now - 10; }
#endif
