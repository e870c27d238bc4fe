// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// A value between the steps of a register of two words.
// EXPECT: value_is_not_a_whole_number_of_register_steps
#include "meter.hpp"

void act()
{
#ifdef REFUSED
    static_cast<void>(write<meter::budget>(unit, 1.0001_kWh));
#else
    static_cast<void>(write<meter::budget>(unit, 1.001_kWh));
#endif
}
