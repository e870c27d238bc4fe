// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Volts for a register of energy.
// EXPECT: this value measures something else than the register
#include "meter.hpp"

void act()
{
#ifdef REFUSED
    static_cast<void>(write<meter::energy>(unit, 12.5_V));
#else
    static_cast<void>(write<meter::energy>(unit, 12.5_kWh));
#endif
}
