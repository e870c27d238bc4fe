// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// A write to a register that another drive's table names.
// EXPECT: this device has no such register
#include <rtuwire/altivar/atv28.hpp>
#include <rtuwire/altivar/atv320.hpp>
#include <rtuwire/ask/access.hpp>

using namespace rtuwire;
using namespace rtuwire::altivar;

inline constexpr station<atv320::device> drive{unit_id{7}};

void act()
{
#ifdef REFUSED
    static_cast<void>(write<atv28::lfr>(drive, 50_Hz));
#else
    static_cast<void>(write<atv320::lfr>(drive, 50_Hz));
#endif
}
