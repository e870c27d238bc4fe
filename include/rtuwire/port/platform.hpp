// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// What POSIX and Windows call differently, under one name each: the calls of sockets, their errors, a wait for some of them. A
// socket is an int on both, and errno has the reason of a failure on both: Windows keeps the rest of its handles' bits equal.
#pragma once

#include <array>
#include <cerrno>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <ctime>
#include <string>

#ifdef _WIN32
#if defined(_WINSOCKAPI_) && !defined(_WINSOCK2API_)
#error                                                                                                                 \
    "rtuwire needs Winsock 2, and <windows.h> has brought Winsock 1: include rtuwire/port.hpp or <winsock2.h> before it"
#endif
#ifndef WIN32_LEAN_AND_MEAN
#define WIN32_LEAN_AND_MEAN
#endif
#ifndef NOMINMAX
#define NOMINMAX
#endif
#include <winsock2.h>
#include <ws2tcpip.h>
#else
#include <fcntl.h>
#include <netdb.h>
#include <netinet/in.h>
#include <netinet/tcp.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>
#endif

#include <rtuwire/core/bytes.hpp>
#include <rtuwire/core/time.hpp>
#include <rtuwire/core/version.hpp>

namespace rtuwire {
inline namespace RTUWIRE_BUILD {

namespace detail {

#ifdef _WIN32

/// Starts Winsock, once for the program's life.
inline void start_sockets() noexcept
{
    static bool const is_started = [] {
        WSADATA told{};
        return ::WSAStartup(MAKEWORD(2, 2), &told) == 0;
    }();
    static_cast<void>(is_started); // where it is not, each call says so
}

[[nodiscard]] inline SOCKET socket_of(int number) noexcept { return static_cast<SOCKET>(number); }
[[nodiscard]] inline int number_of(SOCKET socket) noexcept { return static_cast<int>(socket); }

/// An error of Winsock as errno has it; Winsock's own number where errno has none.
[[nodiscard]] inline int errno_of(int own) noexcept
{
    switch (own) {
    case WSAEINTR: return EINTR;
    case WSAEACCES: return EACCES;
    case WSAEINVAL: return EINVAL;
    case WSAEMFILE: return EMFILE;
    case WSAEWOULDBLOCK: return EAGAIN;
    case WSAEADDRINUSE: return EADDRINUSE;
    case WSAEADDRNOTAVAIL: return EADDRNOTAVAIL;
    case WSAENETDOWN:
    case WSAENETUNREACH: return ENETUNREACH;
    case WSAEHOSTDOWN:
    case WSAEHOSTUNREACH: return EHOSTUNREACH;
    case WSAENETRESET:
    case WSAECONNABORTED:
    case WSAECONNRESET: return ECONNRESET;
    case WSAETIMEDOUT: return ETIMEDOUT;
    case WSAECONNREFUSED: return ECONNREFUSED;
    default: return own;
    }
}

/// The reason of a call that failed; errno has it, too.
inline int socket_error() noexcept { return errno = errno_of(::WSAGetLastError()); }

/// What a socket needs that listens, so that no other program takes its address: without it two may.
inline constexpr int listening_option = SO_EXCLUSIVEADDRUSE;

/// A number of errno in words: its C library knows none of sockets.
[[nodiscard]] inline std::string system_text(int number)
{
    switch (number) {
    case EADDRINUSE: return "Address already in use";
    case EADDRNOTAVAIL: return "Cannot assign requested address";
    case ENETUNREACH: return "Network is unreachable";
    case EHOSTUNREACH: return "No route to host";
    case ECONNRESET: return "Connection reset by peer";
    case ETIMEDOUT: return "Connection timed out";
    case ECONNREFUSED: return "Connection refused";
    default: return number < WSABASEERR ? std::strerror(number) : "Winsock error " + std::to_string(number);
    }
}

/// Makes a socket this program's own, in non-blocking mode.
[[nodiscard]] inline bool set_up_socket(int number) noexcept
{
    u_long is_non_blocking = 1;
    return ::ioctlsocket(socket_of(number), static_cast<long>(FIONBIO), &is_non_blocking) == 0;
}

/// What a look-up of a host never has as its status.
inline constexpr int lookup_failed_by_errno = -1;

/// The status of a look-up in words.
[[nodiscard]] inline std::string lookup_text(int status)
{
    return status == EAI_NONAME ? "Name or service not known" : "Winsock error " + std::to_string(status);
}

/// Closes a socket.
inline void close_number(int number) noexcept { static_cast<void>(::closesocket(socket_of(number))); }

/// As POSIX's `read` and `write`, of a socket.
inline std::ptrdiff_t read_some(int number, byte_span place) noexcept
{
    int const count =
        ::recv(socket_of(number), reinterpret_cast<char*>(place.data()), static_cast<int>(place.size()), 0);
    if (count < 0) {
        static_cast<void>(socket_error());
    }
    return count;
}
inline std::ptrdiff_t send_some(int number, byte_view bytes) noexcept
{
    int const count =
        ::send(socket_of(number), reinterpret_cast<char const*>(bytes.data()), static_cast<int>(bytes.size()), 0);
    if (count < 0) {
        static_cast<void>(socket_error());
    }
    return count;
}
inline std::ptrdiff_t write_some(int number, byte_view bytes) noexcept { return send_some(number, bytes); }

[[nodiscard]] inline pollfd watched(int number, short events) noexcept { return {socket_of(number), events, 0}; }

/// Waits for sockets as `poll` does, to the millisecond, rounded up; of a negative number nothing. By `select`: before Windows 10
/// 2004, `WSAPoll` tells nobody of a connection that could not be made.
inline int poll_for(pollfd* first, unsigned count, duration longest) noexcept
{
    fd_set to_read{};
    fd_set to_write{};
    fd_set failed{}; // of those that are to be written: a connection that is being made; else it is of urgent data
    auto const put = [](SOCKET socket, fd_set& set) {
        if (set.fd_count < FD_SETSIZE) {
            set.fd_array[set.fd_count++] = socket;
        }
    };
    for (pollfd* each = first; each != first + count; ++each) {
        each->revents = 0;
        if (each->fd == INVALID_SOCKET) {
            continue;
        }
        if ((each->events & POLLIN) != 0) {
            put(each->fd, to_read);
        }
        if ((each->events & POLLOUT) != 0) {
            put(each->fd, to_write);
            put(each->fd, failed);
        }
    }
    std::uint32_t const limit = longest.microseconds / 1'000U + (longest.microseconds % 1'000U != 0 ? 1U : 0U);
    if (to_read.fd_count + to_write.fd_count == 0) { // `select` takes at least one
        ::Sleep(limit);
        return 0;
    }
    timeval time{static_cast<long>(limit / 1'000U), static_cast<long>(limit % 1'000U * 1'000U)};
    if (::select(0, &to_read, &to_write, &failed, &time) < 0) {
        static_cast<void>(socket_error());
        return -1;
    }
    auto const is_in = [](SOCKET socket, fd_set const& set) {
        for (u_int i = 0; i < set.fd_count; ++i) {
            if (set.fd_array[i] == socket) {
                return true;
            }
        }
        return false;
    };
    int ready = 0;
    for (pollfd* each = first; each != first + count; ++each) {
        int const events = (is_in(each->fd, to_read) ? POLLIN : 0) | (is_in(each->fd, to_write) ? POLLOUT : 0) |
                           (is_in(each->fd, failed) ? POLLERR | POLLOUT : 0);
        each->revents = static_cast<short>(events);
        ready += events != 0 ? 1 : 0;
    }
    return ready;
}

#else

inline void start_sockets() noexcept {}
[[nodiscard]] inline int socket_of(int number) noexcept { return number; }
[[nodiscard]] inline int number_of(int socket) noexcept { return socket; }
[[nodiscard]] inline int errno_of(int own) noexcept { return own; }
inline int socket_error() noexcept { return errno; }

/// What a socket needs that listens, so that it may where one did a moment ago.
inline constexpr int listening_option = SO_REUSEADDR;

[[nodiscard]] inline std::string system_text(int number) { return std::strerror(number); }

/// Makes a socket this program's own, not its children's, in non-blocking mode.
[[nodiscard]] inline bool set_up_socket(int number) noexcept
{
    return ::fcntl(number, F_SETFD, FD_CLOEXEC) == 0 and ::fcntl(number, F_SETFL, O_NONBLOCK) == 0;
}

/// The status of a look-up whose reason errno has.
inline constexpr int lookup_failed_by_errno = EAI_SYSTEM;
[[nodiscard]] inline std::string lookup_text(int status) { return ::gai_strerror(status); }

inline void close_number(int number) noexcept { static_cast<void>(::close(number)); }
inline std::ptrdiff_t read_some(int number, byte_span place) noexcept
{
    return ::read(number, place.data(), place.size());
}
inline std::ptrdiff_t write_some(int number, byte_view bytes) noexcept
{
    return ::write(number, bytes.data(), bytes.size());
}

/// The same to a socket, without a signal where the other end is gone.
inline std::ptrdiff_t send_some(int number, byte_view bytes) noexcept
{
#ifdef MSG_NOSIGNAL
    return ::send(number, bytes.data(), bytes.size(), MSG_NOSIGNAL);
#else
    return ::send(number, bytes.data(), bytes.size(), 0); // the socket's option SO_NOSIGPIPE says it
#endif
}

[[nodiscard]] inline pollfd watched(int number, short events) noexcept { return {number, events, 0}; }

/// Waits as `poll` does: to the microsecond where the system offers that, elsewhere to the millisecond, rounded up.
inline int poll_for(pollfd* first, unsigned count, duration longest) noexcept
{
#ifdef __linux__
    constexpr std::uint32_t million = 1'000'000;
    timespec limit{};
    limit.tv_sec = static_cast<time_t>(longest.microseconds / million);
    limit.tv_nsec = static_cast<long>(longest.microseconds % million) * 1'000;
    return ::ppoll(first, count, &limit, nullptr);
#else
    return ::poll(first, count, static_cast<int>((longest.microseconds + 999U) / 1000U));
#endif
}

#endif

} // namespace detail

} // namespace RTUWIRE_BUILD
} // namespace rtuwire
