// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// A discrete input is switched.
// EXPECT: an input register or discrete input is read-only: no function writes it
#include "meter.hpp"

void act()
{
#ifdef REFUSED
    static_cast<void>(write<meter::door>(unit, true));
#else
    static_cast<void>(write<meter::relay>(unit, true));
#endif
}
