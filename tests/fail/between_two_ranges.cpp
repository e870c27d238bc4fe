// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// A value between the two ranges that a register takes: the first, the last and one within.
// EXPECT: value_is_never_written_to_this_register
// CASES: 3
#include <rtuwire/altivar/atv28.hpp>
#include <rtuwire/ask/access.hpp>

using namespace rtuwire;
using namespace rtuwire::altivar;

inline constexpr station<atv28::device> drive{unit_id{3}};

void act()
{
#if not defined(REFUSED)
    static_cast<void>(write<atv28::uns>(drive, 240_V));
    static_cast<void>(write<atv28::uns>(drive, 380_V));
#elif REFUSED == 1
    static_cast<void>(write<atv28::uns>(drive, 300_V));
#elif REFUSED == 2
    static_cast<void>(write<atv28::uns>(drive, 241_V));
#else
    static_cast<void>(write<atv28::uns>(drive, 379_V));
#endif
}
