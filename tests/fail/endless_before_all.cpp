// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// A cycle before all slots of a bus, which would wait for its end.
// EXPECT: this conversation never ends: no slot would ask behind it
#include <rtuwire/altivar/atv320.hpp>
#include <rtuwire/altivar/cyclic/cyclic.hpp>
#include <rtuwire/altivar/procedure/motion/broadcast_stop.hpp>
#include <rtuwire/client/bus.hpp>

using namespace rtuwire;
using namespace rtuwire::altivar;

void pass(bus<2>& line, station<atv320::device> const& drive, instant now)
{
#ifdef REFUSED
    cyclic conversation{drive};
#else
    broadcast_stop conversation{drive};
#endif
    line.run_urgent(conversation, now);
}
