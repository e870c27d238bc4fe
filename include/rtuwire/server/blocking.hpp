// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// One pass of a server over a port of the host, to be called in a loop. Uses the operating system only through the
// port.
#pragma once

#include <array>
#include <cstddef>

#include <rtuwire/core/version.hpp>
#include <rtuwire/rtu/line.hpp>
#include <rtuwire/server/server.hpp>
#include <rtuwire/server/units.hpp>

namespace rtuwire {
inline namespace RTUWIRE_BUILD {

namespace detail {

/// Sends the response that is ready, if there is one; a port that writes at the line's speed has a second more than the
/// server's own time limit, which counts the characters. Errors: those of the port.
template <typename Server, typename Port> result<void> send_response(Server& node, Port& port)
{
    constexpr duration write_limit = milliseconds(1'000);
    byte_view const frame = node.poll_transmit();
    if (frame.empty()) {
        return {};
    }
    auto const written = port.write(frame, *node.poll_deadline() + write_limit);
    node.sent(port.now());
    return written;
}

/// Reads the bytes that have arrived or arrive within `time_limit`, lets `serve(now)` execute a request, and sends what
/// the server has to say.
template <typename Server, typename Port, typename Serve>
result<void> serve_pass(Server& node, Port& port, duration time_limit, Serve&& serve)
{
    std::array<std::byte, max_adu_size> input;
    instant const start = port.now();
    node.advance(start);
    // Where the program took longer than the silence before sending since the last pass, nothing is waited for.
    if (auto const sent = send_response(node, port); not sent) {
        return sent;
    }
    instant const until = *earlier(node.poll_deadline(), start + time_limit);
    if (auto const received = receive_from(port, node, input, until); not received) {
        return received;
    }
    node.advance(port.now());
    serve(port.now());
    node.advance(port.now()); // the bank may have taken longer than that silence
    return send_response(node, port);
}

} // namespace detail

/// Reads the bytes that have arrived or arrive within `time_limit`, and responds to a request. The port
/// must not echo what is sent: the response to function 06 looks like its request. Errors: those of the port.
template <typename Diagnostics, typename Functions, typename Port, typename Bank>
result<void> serve_once(detail::basic_server<Diagnostics, Functions>& node, Port& port, Bank& bank, duration time_limit)
{
    return detail::serve_pass(node, port, time_limit, [&](instant at) { node.serve(bank, at); });
}

/// The same for a server of several units, which knows its banks.
template <typename Diagnostics, typename Functions, typename... Entries, typename Port>
result<void> serve_once(detail::basic_server<Diagnostics, Functions, detail::unit_set<Entries...>>& node, Port& port,
                        duration time_limit)
{
    return detail::serve_pass(node, port, time_limit, [&](instant now) { node.serve(now); });
}

} // namespace RTUWIRE_BUILD
} // namespace rtuwire
