// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// A ramp time in a plan that writes, whose steps another register sets.
// EXPECT: another register sets this register's steps: name them with restepped
#include <rtuwire/altivar/atv320.hpp>
#include <rtuwire/table/read_plan.hpp>
#include <rtuwire/table/write_plan.hpp>

using namespace rtuwire;
using namespace rtuwire::detail;
using namespace rtuwire::altivar;

void act()
{
#ifdef REFUSED
    static_cast<void>(write_plan<atv320::device, atv320::acc>{1.3_s});
#else
    static_cast<void>(write_plan<atv320::device, restepped<deciseconds, atv320::acc>>{1.3_s});
#endif
}
