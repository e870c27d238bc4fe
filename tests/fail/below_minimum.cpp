// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// A value below the register's minimum.
// EXPECT: value_is_below_the_register_minimum
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
    static_cast<void>(write<atv12::frs>(drive, 9.9_Hz));
#else
    static_cast<void>(write<atv12::frs>(drive, 10_Hz));
#endif
}
