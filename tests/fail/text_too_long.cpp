// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// A text with more characters than its registers hold.
// EXPECT: this_text_is_longer_than_its_registers
#include "meter.hpp"

void act()
{
#ifdef REFUSED
    static_cast<void>(write<meter::place>(unit, "HALLS"));
#else
    static_cast<void>(write<meter::place>(unit, "HALL"));
#endif
}
