// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// A value of an enumeration that its list does not have.
// EXPECT: value_has_no_meaning_in_this_register
#include <rtuwire/altivar/atv12.hpp>
#include <rtuwire/ask/access.hpp>

using namespace rtuwire;
using namespace rtuwire::altivar;

inline constexpr station<atv12::device> drive{unit_id{7}};

void act()
{
#ifdef REFUSED
    static_cast<void>(write<atv12::sll>(drive, static_cast<compact::link_lost_reaction>(2)));
#else
    static_cast<void>(write<atv12::sll>(drive, static_cast<compact::link_lost_reaction>(4)));
#endif
}
