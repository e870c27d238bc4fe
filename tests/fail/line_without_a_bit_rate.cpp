// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// A line of 0 bit/s, as a constant.
// EXPECT: the_bit_rate_of_a_line_is_above_0
// ALONE
#include <rtuwire/rtu/line.hpp>

using namespace rtuwire;

#ifdef REFUSED
constexpr line_timing line{0, character_format::even_8_1};
#else
constexpr line_timing line{19'200, character_format::even_8_1};
#endif
static_assert(sizeof(line) > 0);
