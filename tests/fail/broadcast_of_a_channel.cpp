// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Who commands, set for all drives at once.
// EXPECT: a command, a channel or an address is not written to all drives at once
#include <rtuwire/altivar/atv320.hpp>
#include <rtuwire/altivar/procedure/commissioning/broadcast_setting.hpp>

using namespace rtuwire;
using namespace rtuwire::altivar;

void act()
{
#ifdef REFUSED
    setting<atv320::cd1> value = atv320::command_channel::ter;
    static_cast<void>(broadcast_setting<atv320::device, atv320::cd1>(value));
#else
    static_cast<void>(broadcast_setting<atv320::device, atv320::tto>(5_s));
#endif
}
