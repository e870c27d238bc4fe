// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// A floating point amount compared with a plain number.
// EXPECT: a plain number is no amount: give it a unit, as in 50_Hz
#include "meter.hpp"

void act()
{
#ifdef REFUSED
    static_cast<void>(real<kilowatt_hours>{12.5F} > 5);
#else
    static_cast<void>(real<kilowatt_hours>{12.5F} > 5_kWh);
#endif
}
