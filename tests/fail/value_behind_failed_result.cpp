// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// The same through the arrow, also where nothing is checked when the program runs.
// EXPECT: a_failed_result_has_no_value
#define RTUWIRE_CHECKED 0
#include <rtuwire/wire/unit_id.hpp>

using namespace rtuwire;

#ifdef REFUSED
constexpr std::uint8_t address = unit_id::checked(0)->byte();
#else
constexpr std::uint8_t address = unit_id::checked(1)->byte();
#endif
static_assert(address == 1);
