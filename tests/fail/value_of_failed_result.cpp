// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// A value read from a result that has none.
// EXPECT: a_failed_result_has_no_value
#include <rtuwire/wire/unit_id.hpp>

using namespace rtuwire;

#ifdef REFUSED
constexpr unit_id unit = *unit_id::checked(248);
#else
constexpr unit_id unit = *unit_id::checked(247);
#endif
static_assert(unit.byte() == 247);
