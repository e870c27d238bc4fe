// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// A ramp time in an exchange, whose steps another register sets.
// EXPECT: another register sets this register's steps: name them with restepped
#include <rtuwire/altivar/atv320.hpp>
#include <rtuwire/ask/access.hpp>

using namespace rtuwire;
using namespace rtuwire::altivar;

inline constexpr station<atv320::device> drive{unit_id{7}};

void act()
{
#ifdef REFUSED
    static_cast<void>(exchange<contiguous<atv320::eta>, atv320::acc>(drive, 1.3_s));
#else
    static_cast<void>(exchange<contiguous<atv320::eta>, restepped<deciseconds, atv320::acc>>(drive, 1.3_s));
#endif
}
