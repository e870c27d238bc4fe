// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Registers of two kinds, by one request.
// EXPECT: no request reads registers of two kinds: these cannot be kept together
#include "meter.hpp"

void act()
{
#ifdef REFUSED
    static_cast<void>(read_plan<meter::device, together<meter::energy, meter::voltage>>::request_count);
#else
    static_cast<void>(read_plan<meter::device, together<meter::energy, meter::budget>>::request_count);
#endif
}
