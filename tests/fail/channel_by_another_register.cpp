// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// A register that chooses no channel, as a setting of a channel.
// EXPECT: this register chooses no channel
#include <rtuwire/altivar/atv320.hpp>
#include <rtuwire/altivar/procedure/commissioning/channel.hpp>

using namespace rtuwire;
using namespace rtuwire::altivar;

void act()
{
    channel_settings<atv320::device> const none;
#ifdef REFUSED
    static_cast<void>(none.with<atv320::cd2>(atv320::command_channel::mdb));
#else
    static_cast<void>(none.with<atv320::cd1>(atv320::command_channel::mdb));
#endif
}
