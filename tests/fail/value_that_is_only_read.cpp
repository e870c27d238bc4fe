// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// A value that a register shows and does not take.
// EXPECT: value_is_above_the_register_maximum
#include <rtuwire/altivar/atv28.hpp>
#include <rtuwire/ask/access.hpp>

using namespace rtuwire;
using namespace rtuwire::altivar;

inline constexpr station<atv28::device> drive{unit_id{3}};

void act()
{
#ifdef REFUSED
    static_cast<void>(write<atv28::tcc>(drive, atv28::control_mode::option));
#else
    static_cast<void>(write<atv28::tcc>(drive, atv28::control_mode::three_wire));
#endif
}
