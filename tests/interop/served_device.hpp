// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// A server of ours on the device that the command line names, until it is ended; says "ready" once it answers.
#pragma once

#include <cstdio>

#include <rtuwire/port/posix_serial.hpp>
#include <rtuwire/server/blocking.hpp>

namespace rtuwire::test {

/// The status of the program.
template <typename Node, typename Bank>
int serve_device(int argc, char** argv, line_timing const& line, Node& node, Bank& bank)
{
    posix_serial port;
    if (argc != 2 or not port.open(argv[1])) {
        std::fprintf(stderr, "%s\n",
                     argc == 2 ? port.failure().c_str() : "usage: the program, and the DEVICE that it serves");
        return 2;
    }
    // Nothing is heard before the line was silent once.
    instant const silent = port.now() + line.frame_end() + milliseconds(10);
    while (not reached(port.now(), silent)) {
        static_cast<void>(serve_once(node, port, bank, milliseconds(10)));
    }
    std::puts("ready");
    std::fflush(stdout);
    while (serve_once(node, port, bank, milliseconds(200))) {
    }
    std::fprintf(stderr, "%s\n", port.failure().c_str());
    return 1;
}

} // namespace rtuwire::test
