// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Factory settings for all drives at once, by somebody who does not say that he knows what they take away.
// EXPECT: this word orders factory settings, a save or a recall
#include <rtuwire/altivar/atv320.hpp>
#include <rtuwire/altivar/procedure/commissioning/broadcast_setting.hpp>

using namespace rtuwire;
using namespace rtuwire::altivar;

void act()
{
#ifdef REFUSED
    static_cast<void>(broadcast_extended_command<atv320::device, 0x0001>());
#else
    static_cast<void>(broadcast_extended_command<atv320::device, 0x0001>(losing_control_and_address{}));
#endif
}
