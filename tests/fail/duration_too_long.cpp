// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// A time that no deadline can be away.
// EXPECT: a_duration_is_at_most_35_minutes
#include <rtuwire/core/time.hpp>

using namespace rtuwire;
using namespace rtuwire::detail;

#ifdef REFUSED
constexpr duration limit = milliseconds(5'000'000);
#else
constexpr duration limit = milliseconds(2'100'000);
#endif
static_assert(limit == longest_duration);
