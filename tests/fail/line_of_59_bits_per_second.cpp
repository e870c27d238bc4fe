// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// A line of 59 bit/s, on which a frame lasts longer than the times of a client have room for, as a constant.
// EXPECT: the_bit_rate_of_a_line_is_at_least_60
// ALONE
#include <rtuwire/rtu/line.hpp>

using namespace rtuwire;

#ifdef REFUSED
constexpr line_timing line{59, character_format::even_8_1};
#else
constexpr line_timing line{60, character_format::even_8_1};
#endif
static_assert(sizeof(line) > 0);
