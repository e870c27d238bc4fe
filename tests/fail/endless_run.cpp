// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Waiting for the end of a conversation that has none.
// EXPECT: this conversation never ends: give it to a client in each pass
#include <rtuwire/altivar/atv320.hpp>
#include <rtuwire/altivar/cyclic/cyclic.hpp>
#include <rtuwire/altivar/procedure/motion/start.hpp>
#include <rtuwire/client/blocking.hpp>

using namespace rtuwire;
using namespace rtuwire::altivar;

struct port {
    instant now();
    result<void> write(byte_view out, instant until);
    result<byte_span> read(byte_span in, instant until);
};

void wait(blocking_client<port>& line, station<atv320::device> const& drive)
{
#ifdef REFUSED
    cyclic conversation{drive};
#else
    start conversation{drive, 1500_rpm};
#endif
    static_cast<void>(line.run(conversation));
}
