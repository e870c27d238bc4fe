// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// A speed limit that no drive of the family has.
// EXPECT: value_is_above_the_register_maximum
#include <rtuwire/altivar/atv12.hpp>
#include <rtuwire/ask/access.hpp>

using namespace rtuwire;
using namespace rtuwire::altivar;

inline constexpr station<atv12::device> drive{unit_id{3}};

void act()
{
#ifdef REFUSED
    static_cast<void>(write<atv12::hsp>(drive, 6000_Hz));
#else
    static_cast<void>(write<atv12::hsp>(drive, 400_Hz));
#endif
}
