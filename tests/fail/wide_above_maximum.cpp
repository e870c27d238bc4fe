// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// A value above the maximum of a register of two words.
// EXPECT: value_is_above_the_register_maximum
#include "meter.hpp"

void act()
{
#ifdef REFUSED
    static_cast<void>(write<meter::budget>(unit, 6_kWh));
#else
    static_cast<void>(write<meter::budget>(unit, 5_kWh));
#endif
}
