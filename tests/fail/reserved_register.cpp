// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// A write to a register that its manual reserves.
// EXPECT: this register is read-only
#include <rtuwire/altivar/atv28.hpp>
#include <rtuwire/ask/access.hpp>

using namespace rtuwire;
using namespace rtuwire::altivar;

inline constexpr station<atv28::device> drive{unit_id{3}};

void act()
{
#ifdef REFUSED
    static_cast<void>(write<atv28::smih>(drive, 0_raw));
#else
    static_cast<void>(write<atv28::smil>(drive, 0_rpm));
#endif
}
