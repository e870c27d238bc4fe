// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Waits for the response to a broadcast, which no unit sends.
// EXPECT: a broadcast has no response: use send_broadcast
#include <rtuwire/client/blocking.hpp>
#include <rtuwire/port/posix_serial.hpp>
#include <rtuwire/wire/registers.hpp>

using namespace rtuwire;

void act(blocking_client<posix_serial>& link)
{
    write_single_register const stop{8'501, 0};
#ifdef REFUSED
    static_cast<void>(link.ask(broadcast, stop));
#else
    static_cast<void>(link.send_broadcast(stop));
#endif
}
