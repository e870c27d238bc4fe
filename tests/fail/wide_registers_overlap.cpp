// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// A register in the second word of another.
// EXPECT: these_registers_overlap<energy, inside>
#include "meter.hpp"

inline constexpr reg<float32<kilowatt_hours>> energy{.code = "E1", .address = 10};
inline constexpr reg<count16> inside{.code = "E2", .address = 11};

void act()
{
#ifdef REFUSED
    static_cast<void>(table<energy, inside>::size);
#else
    static_cast<void>(table<energy>::size);
#endif
}
