// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// A literal for a register type that cannot hold it.
// EXPECT: this_amount_does_not_fit_the_target
// CASES: 3
#include <rtuwire/core/units.hpp>

using namespace rtuwire;

#if not defined(REFUSED)
decihertz top() { return 6'553.5_Hz; }
#elif REFUSED == 1
decihertz top() { return 6'553.6_Hz; }
#elif REFUSED == 2
decihertz top() { return -1_Hz; }
#else
signed_decihertz top() { return -3'276.9_Hz; }
#endif
