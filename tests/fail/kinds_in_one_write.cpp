// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// A coil and a register in one write.
// EXPECT: one request writes registers that follow one another
#include "meter.hpp"

void act()
{
#ifdef REFUSED
    static_cast<void>(write_all<meter::lamp, meter::budget>(unit, true, 5_Wh));
#else
    static_cast<void>(write_all<meter::energy, meter::budget>(unit, 5_kWh, 5_Wh));
#endif
}
