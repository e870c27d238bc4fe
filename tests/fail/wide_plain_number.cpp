// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// A plain number for a floating point register.
// EXPECT: a plain number is no setting: give it a unit (3_s), or name an enumerator or bits
#include "meter.hpp"

void act()
{
#ifdef REFUSED
    static_cast<void>(write<meter::energy>(unit, 12.5F));
#else
    static_cast<void>(write<meter::energy>(unit, 12.5_kWh));
#endif
}
