// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// A value above the maximum of a floating point register.
// EXPECT: value_is_above_the_register_maximum
#include "meter.hpp"

void act()
{
#ifdef REFUSED
    static_cast<void>(write<meter::energy>(unit, 1000.5_kWh));
#else
    static_cast<void>(write<meter::energy>(unit, 999.5_kWh));
#endif
}
