// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// A coil that holds a number.
// EXPECT: a coil and a discrete input hold a bool, and a register something else
#include "meter.hpp"

void act()
{
#ifdef REFUSED
    static_cast<void>(reg<count16, register_space::coil>{.code = "K", .address = 1});
#else
    static_cast<void>(setting<meter::relay>{true});
#endif
}
