// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// A discrete input of a device that only reads coils.
// EXPECT: this device does not implement function 02
#include "meter.hpp"

void act()
{
#ifdef REFUSED
    static_cast<void>(read<meter::door>(unit));
#else
    static_cast<void>(read<meter::relay>(unit));
#endif
}
