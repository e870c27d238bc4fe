// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// A plan with a discrete input of a device that does not read any.
// EXPECT: this device does not implement the function that reads one of these kinds of registers
#include "meter.hpp"

void act()
{
#ifdef REFUSED
    static_cast<void>(poller<read_plan<meter::device, meter::door, meter::energy>>{unit});
#else
    static_cast<void>(poller<read_plan<meter::device, meter::relay, meter::energy>>{unit});
#endif
}
