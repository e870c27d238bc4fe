// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// A reserved address that is an ordinary one, that of everyone, or more than a byte.
// EXPECT: a_reserved_address_is_248_to_255
// CASES: 3
#include <rtuwire/wire/unit_id.hpp>

using namespace rtuwire;

#if not defined(REFUSED)
constexpr unit_id unit = unit_id::reserved(248);
#elif REFUSED == 1
constexpr unit_id unit = unit_id::reserved(247);
#elif REFUSED == 2
constexpr unit_id unit = unit_id::reserved(0);
#else
constexpr unit_id unit = unit_id::reserved(256);
#endif
static_assert(unit.byte() == 248);
