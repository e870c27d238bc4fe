// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// A step of 16 bits for a register of 32.
// EXPECT: a step is as wide as its register: name one of so many bits
#include "meter.hpp"

void act()
{
#ifdef REFUSED
    static_cast<void>(restepped<watt_hours, meter::budget>.address);
#else
    static_cast<void>(restepped<unsigned32<watt_hours>, meter::budget>.address);
#endif
}
