// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// A time below zero.
// EXPECT: a_duration_is_not_negative
#include <rtuwire/core/time.hpp>

using namespace rtuwire;

#ifdef REFUSED
constexpr duration limit = milliseconds(-1);
#else
constexpr duration limit = milliseconds(0);
#endif
static_assert(limit == duration{});
