// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// A unit address that the drive cannot be given.
// EXPECT: unit_address_is_outside_the_range_of_this_device
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
    constexpr station<atv28::device> there{unit_id{32}};
    static_cast<void>(there);
#else
    constexpr station<atv28::device> there{unit_id{31}};
    static_cast<void>(there);
#endif
}
