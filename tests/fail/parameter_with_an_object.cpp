// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// A register that has an object, by its mnemonic: it would be two registers.
// EXPECT: or a register that has a name of its own, as atv320::acc
#include <rtuwire/altivar/atv12_parameters.hpp>
#include <rtuwire/ask/access.hpp>

using namespace rtuwire;
using namespace rtuwire::altivar;

inline constexpr station<atv12::full_device> drive{unit_id{7}};

void act()
{
#ifdef REFUSED
    static_cast<void>(read<atv12::parameter<"ACC">>(drive));
#else
    static_cast<void>(read<atv12::acc>(drive));
#endif
}
