// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// A unit address that the line does not have.
// EXPECT: a_unit_address_is_1_to_247
#include <rtuwire/wire/unit_id.hpp>

using namespace rtuwire;

#ifdef REFUSED
constexpr unit_id unit{248};
#else
constexpr unit_id unit{247};
#endif
static_assert(unit.octet() > 0);
