// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// A value above the register's maximum.
// EXPECT: value_is_above_the_register_maximum
#include <rtuwire/altivar/atv12.hpp>
#include <rtuwire/altivar/atv28.hpp>
#include <rtuwire/altivar/atv320.hpp>
#include <rtuwire/ask/access.hpp>
#include <rtuwire/ask/poller.hpp>

using namespace rtuwire;
using namespace rtuwire::altivar;

inline constexpr station<atv12::device> drive{unit_id{7}};
inline constexpr station<atv28::device> old{unit_id{3}};

void act()
{
#ifdef REFUSED
    static_cast<void>(write<atv12::acc>(drive, 2000_s));
#else
    static_cast<void>(write<atv12::acc>(drive, 999.9_s));
#endif
}
