// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Registers kept together, and between them what the device does not have.
// EXPECT: a register with all its words, or registers kept together, do not fit one request of this device
#include "meter.hpp"

void act()
{
#ifdef REFUSED
    static_cast<void>(read_plan<meter::device, together<meter::place, meter::gain>>::request_count);
#else
    static_cast<void>(read_plan<meter::device, together<meter::budget, meter::place>>::request_count);
#endif
}
