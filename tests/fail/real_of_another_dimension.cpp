// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// A floating point amount compared with another dimension.
// EXPECT: these two measure different things, and do not compare
#include "meter.hpp"

void act()
{
#ifdef REFUSED
    static_cast<void>(real<kilowatt_hours>{12.5F} > 5_V);
#else
    static_cast<void>(real<kilowatt_hours>{12.5F} > 5_kWh);
#endif
}
