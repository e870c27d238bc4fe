// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// An input register is written.
// EXPECT: an input register or discrete input is read-only: no function writes it
#include "meter.hpp"

void act()
{
#ifdef REFUSED
    static_cast<void>(write<meter::voltage>(unit, 230_V));
#else
    static_cast<void>(read<meter::voltage>(unit));
#endif
}
