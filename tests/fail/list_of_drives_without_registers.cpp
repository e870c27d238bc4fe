// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Goes through the list of all drives without their registers.
// EXPECT: the registers of a drive in this list are not included: include rtuwire/altivar/all.hpp
#ifndef REFUSED
#include <rtuwire/altivar/all.hpp>
#endif
#include <rtuwire/altivar/all_drives.hpp>

int act()
{
    int count = 0;
    rtuwire::altivar::all_drives::for_each([&]<typename Drive>() { ++count; });
    return count;
}
