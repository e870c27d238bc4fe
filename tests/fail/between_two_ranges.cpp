// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// A value between the two ranges that a register takes.
// EXPECT: value_is_never_written_to_this_register
#include <rtuwire/altivar/atv28.hpp>
#include <rtuwire/client/access.hpp>

using namespace rtuwire;
using namespace rtuwire::altivar;

inline constexpr station<atv28::device> drive{unit_id{3}};

void act()
{
#ifdef REFUSED
    static_cast<void>(write<atv28::uns>(drive, 300_V));
#else
    static_cast<void>(write<atv28::uns>(drive, 380_V));
#endif
}
