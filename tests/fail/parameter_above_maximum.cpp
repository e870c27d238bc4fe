// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// More than a parameter's row allows.
// EXPECT: value_is_above_the_register_maximum
#include <rtuwire/altivar/atv12_parameters.hpp>
#include <rtuwire/ask/access.hpp>

using namespace rtuwire;
using namespace rtuwire::altivar;

inline constexpr station<atv12::full_device> drive{unit_id{7}};

void act()
{
#ifdef REFUSED
    static_cast<void>(write<atv12::parameter<"SP2">>(drive, 700_Hz));
#else
    static_cast<void>(write<atv12::parameter<"SP2">>(drive, 40_Hz));
#endif
}
