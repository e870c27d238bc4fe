// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// An amount multiplied by a number with a fraction.
// EXPECT: an amount is multiplied by integers only: 3 * speed / 2
// CASES: 2
#include <rtuwire/core/units.hpp>

using namespace rtuwire;

#if not defined(REFUSED)
auto faster(decihertz now) { return 3 * now / 2; }
#elif REFUSED == 1
auto faster(decihertz now) { return now * 1.5; }
#else
auto faster(decihertz now) { return 1.5 * now; }
#endif
