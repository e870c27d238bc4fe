// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// From a host's port to a client, a bus or a server: bytes, and the receive errors between them.
#pragma once

#include <concepts>

#include <rtuwire/core/bytes.hpp>
#include <rtuwire/core/result.hpp>
#include <rtuwire/core/time.hpp>
#include <rtuwire/core/version.hpp>

namespace rtuwire {
inline namespace RTUWIRE_BUILD {

namespace detail {

/// A port that knows which bytes arrived damaged: `read` then stops before one, leaves it out, and
/// `take_receive_error` reports it, once. Other ports only read.
template <typename T>
concept reports_receive_errors = requires(T& port)
{
    {
        port.take_receive_error()
        } -> std::same_as<bool>;
};

} // namespace detail

/// Passes to an engine what has arrived at a port, or arrives until `until`. `place` is working memory.
/// Errors: those of the port. A port whose `take_receive_error()` reports a damaged byte before which `read` stopped, once,
/// has it told to the engine.
template <typename Engine, typename Port>
result<void> receive_from(Port& port, Engine& engine, byte_span place, instant until)
{
    auto const bytes = port.read(place, until);
    if (not bytes) {
        return bytes.error();
    }
    engine.receive(*bytes, port.now());
    if constexpr (detail::reports_receive_errors<Port>) {
        if (port.take_receive_error()) {
            engine.receive_error(port.now());
        }
    }
    return {};
}

} // namespace RTUWIRE_BUILD
} // namespace rtuwire
