// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// An amount that its type does not count, given to a variable outside of functions that is no constant.
// EXPECT: this_amount_
// CASES: 2
// ALONE
#include <rtuwire/client.hpp>

using namespace rtuwire;

#if not defined(REFUSED)
decihertz top = 50.5_Hz;
#elif REFUSED == 1
decihertz top = 50.05_Hz;
#else
decihertz top = 7'000_Hz;
#endif
