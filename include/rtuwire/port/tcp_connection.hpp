// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// A TCP connection made within a time limit, and set up for short frames that must not come late.
#pragma once

#include <cerrno>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <utility>

#include <fcntl.h>
#include <netdb.h>
#include <netinet/in.h>
#include <netinet/tcp.h>
#include <sys/socket.h>

#include <rtuwire/core/version.hpp>
#include <rtuwire/port/chrono.hpp>
#include <rtuwire/port/descriptor.hpp>
#include <rtuwire/port/standard_places.hpp>

namespace rtuwire {
inline namespace RTUWIRE_BUILD {

namespace detail {

/// The error for a connection that could not be made.
[[nodiscard]] inline errc connect_error(int system_error) noexcept
{
    switch (system_error) {
    case ECONNREFUSED:
    case EHOSTUNREACH:
    case ENETUNREACH:
    case EADDRNOTAVAIL: return errc::device_not_found;
    case ETIMEDOUT: return errc::timed_out;
    default:
        return device_error(system_error) == errc::device_setting_refused ? errc::device_failed
                                                                          : device_error(system_error);
    }
}

/// Sets an option of a socket; where the system refuses, the connection works without it.
inline void set_option(int socket, int level, int option, int value) noexcept
{
    static_cast<void>(::setsockopt(socket, level, option, &value, sizeof value));
}

/// Frames leave at once, and a far end that is gone is noticed: after some 10 s while nothing is sent, and `unsent_limit`
/// after bytes were sent that it did not confirm.
inline void set_up_connection(int socket) noexcept
{
    set_option(socket, IPPROTO_TCP, TCP_NODELAY, 1);
    set_option(socket, SOL_SOCKET, SO_KEEPALIVE, 1);
#ifdef TCP_KEEPIDLE
    set_option(socket, IPPROTO_TCP, TCP_KEEPIDLE, 4);
    set_option(socket, IPPROTO_TCP, TCP_KEEPINTVL, 2);
    set_option(socket, IPPROTO_TCP, TCP_KEEPCNT, 3);
#endif
#ifdef TCP_USER_TIMEOUT
    constexpr int unsent_limit = 5'000; // ms
    set_option(socket, IPPROTO_TCP, TCP_USER_TIMEOUT, unsent_limit);
#endif
#ifdef SO_NOSIGPIPE
    set_option(socket, SOL_SOCKET, SO_NOSIGPIPE, 1);
#endif
}

/// Whether a socket is connected with itself: a client that asks for a port of its own machine where nobody listens may
/// get just that port for its own end, and would then hear what it says.
[[nodiscard]] inline bool is_connected_with_itself(int socket) noexcept
{
    sockaddr_storage own{};
    sockaddr_storage other{};
    socklen_t own_size = sizeof own;
    socklen_t other_size = sizeof other;
    return ::getsockname(socket, reinterpret_cast<sockaddr*>(&own), &own_size) == 0 and
           ::getpeername(socket, reinterpret_cast<sockaddr*>(&other), &other_size) == 0 and own_size == other_size and
           std::memcmp(&own, &other, own_size) == 0;
}

/// A socket in non-blocking mode for an address; none where the system refuses, with the reason in errno.
[[nodiscard]] inline descriptor socket_for(addrinfo const& address) noexcept
{
    standard_places const kept;
    descriptor made{::socket(address.ai_family, address.ai_socktype, address.ai_protocol)};
    if (not made.is_open()) {
        return made;
    }
    if (not standard_places::is_above(made.number())) {
        errno = EMFILE;
        return {};
    }
    if (::fcntl(made.number(), F_SETFD, FD_CLOEXEC) != 0 or ::fcntl(made.number(), F_SETFL, O_NONBLOCK) != 0) {
        return {};
    }
    return made;
}

/// Connects a socket before a deadline; 0, or the system's number of the error.
[[nodiscard]] inline int connect_until(descriptor const& line, addrinfo const& address,
                                       host_deadline const& until) noexcept
{
    if (::connect(line.number(), address.ai_addr, address.ai_addrlen) != 0 and errno != EINPROGRESS and
        errno != EINTR) {
        return errno;
    }
    auto const ended = line.wait_to_write(until);
    if (ended and not *ended) {
        return ETIMEDOUT;
    }
    int failure = 0;
    socklen_t size = sizeof failure;
    if (::getsockopt(line.number(), SOL_SOCKET, SO_ERROR, &failure, &size) != 0) {
        return errno;
    }
    if (failure == 0 and is_connected_with_itself(line.number())) {
        return ECONNREFUSED;
    }
    return failure;
}

/// The first address of a list that answers. Each gets its share of the time that is left, so that one which is silent
/// leaves some for the next. Without any: the last one's error is in `failure`.
[[nodiscard]] inline descriptor connect_any(addrinfo const* first, host_deadline const& until, int& failure) noexcept
{
    std::uint32_t left = 0;
    for (addrinfo const* each = first; each != nullptr; each = each->ai_next) {
        ++left;
    }
    failure = EADDRNOTAVAIL;
    for (addrinfo const* each = first; each != nullptr; each = each->ai_next, --left) {
        duration const share{until.left().microseconds / left};
        host_deadline const own{steady_now() + share};
        descriptor line = socket_for(*each);
        failure = line.is_open() ? connect_until(line, *each, own) : errno;
        if (failure == 0) {
            set_up_connection(line.number());
            return line;
        }
    }
    return {};
}

} // namespace detail

} // namespace RTUWIRE_BUILD
} // namespace rtuwire
