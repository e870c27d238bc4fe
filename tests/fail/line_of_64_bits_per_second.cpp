// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// A line of 64 bit/s, on which a frame lasts longer than the times of a client have room for, as a constant.
// EXPECT: the_bit_rate_of_a_line_is_at_least_65
// ALONE
#include <rtuwire/rtu/line.hpp>

using namespace rtuwire;

#ifdef REFUSED
constexpr line_timing line{64, character_format::even_8_2};
#else
constexpr line_timing line{65, character_format::even_8_2};
#endif
static_assert(sizeof(line) > 0);
