// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// One pass of a server over a host's port, to be called in a loop. Knows of the operating system only
// what the port shows.
#pragma once

#include <array>
#include <cstddef>

#include <rtuwire/core/version.hpp>
#include <rtuwire/rtu/receive_from.hpp>
#include <rtuwire/server/server.hpp>

namespace rtuwire::inline RTUWIRE_BUILD {

/// Reads what has arrived, or arrives before `patience` is over; answers what is asked. The port must not
/// give back what is sent: the answer to function 06 looks like its question. Errors: those of the port.
template <typename Diagnostics, typename Port, register_bank Bank>
result<void> serve_once(basic_server<Diagnostics>& node, Port& port, Bank& bank, duration patience)
{
    constexpr duration write_limit = milliseconds(1000);
    std::array<std::byte, max_adu_size> input;
    instant const start = port.now();
    node.advance(start);
    instant const until = *earlier(node.poll_deadline(), start + patience);
    auto const received = receive_from(port, node, input, until);
    if (not received) {
        return received;
    }
    node.advance(port.now());
    node.serve(bank, port.now());
    byte_view const frame = node.poll_transmit();
    if (frame.empty()) {
        return {};
    }
    auto const written = port.write(frame, port.now() + write_limit);
    node.sent(port.now());
    return written;
}

} // namespace rtuwire
