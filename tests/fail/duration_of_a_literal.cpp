// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Literals that are no duration: below zero, above 35 minutes, between microseconds.
// EXPECT: a_duration_
// CASES: 3
#include <rtuwire/core/time.hpp>
#include <rtuwire/core/units.hpp>

using namespace rtuwire;

#if not defined(REFUSED)
duration wait() { return 2'100_s; }
duration step() { return 0.000001_s; }
#elif REFUSED == 1
duration wait() { return -1_s; }
#elif REFUSED == 2
duration wait() { return 2'100.1_s; }
#else
duration wait() { return 0.0000001_s; }
#endif
