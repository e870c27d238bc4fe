// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Quantities of two dimensions compared, and one given for the other.
// EXPECT: frequency
// EXPECT: current
// CASES: 2
#include <rtuwire/altivar/atv12.hpp>

using namespace rtuwire;

#if not defined(REFUSED)
bool is_too_much(deciamperes now, deciamperes limit) { return now > limit; }
deciamperes copy(deciamperes other) { return other; }
#elif REFUSED == 1
bool is_too_much(deciamperes now, decihertz limit) { return now > limit; }
#else
deciamperes copy(decihertz other) { return other; }
#endif
