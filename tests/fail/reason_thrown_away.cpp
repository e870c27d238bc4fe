// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Running an order without a look at how it ended.
// EXPECT: nodiscard
#include <rtuwire/altivar/atv320.hpp>
#include <rtuwire/altivar/procedure/motion/stop.hpp>
#include <rtuwire/client/blocking.hpp>

using namespace rtuwire;
using namespace rtuwire::altivar;

struct port {
    instant now();
    result<void> write(byte_view out, instant until);
    result<byte_span> read(byte_span in, instant until);
};

bool halt(blocking_client<port>& line, station<atv320::device> const& drive)
{
    stop rest{drive};
#ifdef REFUSED
    line.run(rest);
    return true;
#else
    return line.run(rest).kind == outcome_kind::succeeded;
#endif
}
