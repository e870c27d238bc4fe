// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// A unit address that the line does not have: too high, that of everyone, more than a byte.
// EXPECT: a_unit_address_is_1_to_247
// CASES: 4
#include <rtuwire/wire/unit_id.hpp>

using namespace rtuwire;

#if not defined(REFUSED)
constexpr unit_id unit{247};
#elif REFUSED == 1
constexpr unit_id unit{248};
#elif REFUSED == 2
constexpr unit_id unit{0};
#elif REFUSED == 3
constexpr unit_id unit{256 + 7};
#else
unit_id unit{248}; // no constant
#endif
#if not defined(REFUSED) or REFUSED < 4
static_assert(unit.byte() > 0);
#endif
