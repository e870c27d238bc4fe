// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// A parameter by a mnemonic that this drive does not have.
// EXPECT: this device has no row of this mnemonic
#include <rtuwire/altivar/atv12_parameters.hpp>
#include <rtuwire/ask/access.hpp>

using namespace rtuwire;
using namespace rtuwire::altivar;

inline constexpr station<atv12::full_device> drive{unit_id{7}};

void act()
{
#ifdef REFUSED
    static_cast<void>(read<atv12::parameter<"SP99">>(drive));
#else
    static_cast<void>(read<atv12::parameter<"SP2">>(drive));
#endif
}
