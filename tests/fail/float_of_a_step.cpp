// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// A floating point register of a step instead of a unit: a meter that tells 5.2 A would be read as 0.52 A.
// EXPECT: a floating point number is of a unit, float32<amperes>
#include <rtuwire/client.hpp>

using namespace rtuwire;

#ifdef REFUSED
inline constexpr input_reg<float32<deciamperes>> load{.code = "I1", .address = 6};
#else
inline constexpr input_reg<float32<amperes>> load{.code = "I1", .address = 6};
#endif

static_assert(load.word_count == 2);
