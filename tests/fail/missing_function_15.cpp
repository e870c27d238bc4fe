// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Several coils of a device that switches single ones.
// EXPECT: this device does not implement function 15
#include "meter.hpp"

void act()
{
#ifdef REFUSED
    static_cast<void>(write_all<meter::relay, meter::lamp>(unit, true, false));
#else
    static_cast<void>(write<meter::relay>(unit, true));
#endif
}
