// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// A value by a name that its register does not list.
// EXPECT: this register has no value of this name
#include <rtuwire/altivar/atv12_parameters.hpp>
#include <rtuwire/ask/access.hpp>

using namespace rtuwire;
using namespace rtuwire::altivar;

inline constexpr station<atv12::full_device> drive{unit_id{7}};

void act()
{
#ifdef REFUSED
    static_cast<void>(write<atv12::parameter<"RPT">>(drive, named<"soft">));
#else
    static_cast<void>(write<atv12::parameter<"RPT">>(drive, named<"LIn">));
#endif
}
