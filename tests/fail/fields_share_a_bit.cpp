// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Two fields of a word on one bit.
// EXPECT: two fields of this word share a bit
#include "meter.hpp"

inline constexpr field<count16, 0, 4> gear{};
inline constexpr field<count16, 4, 2> upper{};
inline constexpr field<count16, 3, 2> lower{};

void act()
{
#ifdef REFUSED
    static_cast<void>(packed<gear, lower>{}.bits);
#else
    static_cast<void>(packed<gear, upper>{}.bits);
#endif
}
