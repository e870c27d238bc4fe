// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// A ramp time in a plan that reads, whose steps another register sets.
// EXPECT: another register sets this register's steps: name them with restepped
#include <rtuwire/altivar/atv320.hpp>
#include <rtuwire/table/read_plan.hpp>
#include <rtuwire/table/write_plan.hpp>

using namespace rtuwire;
using namespace rtuwire::altivar;

void act()
{
#ifdef REFUSED
    static_cast<void>(read_plan<atv320::device, atv320::eta, atv320::acc>::request_count);
#else
    static_cast<void>(read_plan<atv320::device, atv320::eta, restepped<deciseconds, atv320::acc>>::request_count);
#endif
}
