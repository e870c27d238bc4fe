// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// A quantity of one dimension given for another.
// EXPECT: frequency
// EXPECT: current
// CASES: 2
#include <rtuwire/altivar/atv12.hpp>

using namespace rtuwire;

#if not defined(REFUSED)
deciamperes copy(deciamperes other) { return other; }
#elif REFUSED == 1
deciamperes copy(decihertz other) { return other; }
#else
deciamperes copy() { return 50_Hz; }
#endif
