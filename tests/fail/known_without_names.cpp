// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Known enumerators of an enumeration that lists none.
// EXPECT: this enumeration lists no values: specialise enumerators for it
#include "meter.hpp"

void act()
{
#ifdef REFUSED
    static_cast<void>(known<meter::tariff>::word_count);
#else
    static_cast<void>(sizeof(meter::tariff));
#endif
}
