// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// RTU frames over TCP, as serial device servers pass them on: the client's end of a connection, made within a time limit,
// set up for short frames that must not come late, read and written with deadlines as a `posix_serial`
// is. Every failure is an errc for programs and a sentence with host and port for people.
#pragma once

#include <cerrno>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <memory>
#include <string>
#include <utility>

#include <rtuwire/core/version.hpp>
#include <rtuwire/port/chrono.hpp>
#include <rtuwire/port/descriptor.hpp>
#include <rtuwire/port/host_lookup.hpp>
#include <rtuwire/port/platform.hpp>
#include <rtuwire/wire/errc_name.hpp>

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
    static_cast<void>(
        ::setsockopt(socket_of(socket), level, option, reinterpret_cast<char const*>(&value), sizeof value));
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
    return ::getsockname(socket_of(socket), reinterpret_cast<sockaddr*>(&own), &own_size) == 0 and
           ::getpeername(socket_of(socket), reinterpret_cast<sockaddr*>(&other), &other_size) == 0 and
           own_size == other_size and std::memcmp(&own, &other, static_cast<std::size_t>(own_size)) == 0;
}

/// A socket in non-blocking mode for an address; none where the system refuses, with the reason in errno.
[[nodiscard]] inline descriptor socket_for(addrinfo const& address) noexcept
{
    start_sockets();
    standard_places const kept;
    descriptor made{number_of(::socket(address.ai_family, address.ai_socktype, address.ai_protocol))};
    if (not made.is_open()) {
        static_cast<void>(socket_error());
        return made;
    }
    if (not standard_places::is_above(made.number())) {
        errno = EMFILE;
        return {};
    }
    if (not set_up_socket(made.number())) {
        static_cast<void>(socket_error());
        return {};
    }
    return made;
}

/// Connects a socket before a deadline; 0, or the system's number of the error.
[[nodiscard]] inline int connect_until(descriptor const& line, addrinfo const& address,
                                       host_deadline const& until) noexcept
{
    if (::connect(socket_of(line.number()), address.ai_addr, static_cast<socklen_t>(address.ai_addrlen)) != 0) {
        if (int const why = socket_error(); why != EINPROGRESS and why != EAGAIN and why != EINTR) {
            return why;
        }
    }
    auto const ended = line.wait_to_write(until);
    if (ended and not *ended) {
        return ETIMEDOUT;
    }
    int failure = 0;
    socklen_t size = sizeof failure;
    if (::getsockopt(socket_of(line.number()), SOL_SOCKET, SO_ERROR, reinterpret_cast<char*>(&failure), &size) != 0) {
        return socket_error();
    }
    if (failure == 0 and is_connected_with_itself(line.number())) {
        return ECONNREFUSED;
    }
    return errno_of(failure);
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

/// A connection to a serial device server that passes bytes on as they are ("raw", "TCP server" or "RTU over TCP" mode; not
/// Modbus/TCP, which has another frame). Can be moved; its destructor closes it.
///
/// The wire behind the server is out of sight. A server adds some milliseconds each way, more where it packs bytes, and the
/// network adds its own: give `response_timeout` some 500 ms more than on a wire. TCP loses nothing, so a frame that is late
/// comes all the same, perhaps in one lump with the next, or in pieces: a long time-out is better than many retries. A client
/// waits as long for the rest of a response, however long the pause in it. Where the server keeps
/// the silence between frames itself, use `line_timing::without_wire()`; where it does not, or nobody knows, add
/// `.with_silence(milliseconds(5))` or more.
class tcp_stream {
public:
    /// Not connected.
    tcp_stream() = default;

    /// Connects to a host by its name or its IPv4 or IPv6 number, to the first of its addresses that answers, within a
    /// time limit for that and the look-up of the name; what was open before is closed. On an error nothing is open and `failure()`
    /// says why: `device_not_found` (no such host, no way to it, nobody listens on that port), `timed_out`,
    /// `device_access_denied`, `device_vanished`, `device_failed`. The connection never becomes standard input, output or
    /// error output, even where these are closed. A name is looked up in a thread: link with -pthread where the C library
    /// is older than glibc 2.34.
    result<void> open(std::string const& host, std::uint16_t port, duration time_limit = milliseconds(3'000))
    {
        close();
        bool const is_number_6 = host.find(':') != std::string::npos;
        device_ = (is_number_6 ? "[" + host + "]:" : host + ":") + std::to_string(port);
        host_deadline const until{now() + time_limit};
        auto const lookup = std::make_shared<detail::host_lookup>(host, port);
        if (auto const found = lookup->run(until); not found) {
            return failed(found.error(), "no such host", lookup->why());
        }
        int failure = 0;
        line_ = detail::connect_any(lookup->first(), until, failure);
        if (line_.is_open()) {
            return {};
        }
        return failed(detail::connect_error(failure), "no connection", detail::system_text(failure));
    }

    void close() noexcept { line_.close(); }

    /// Whether a connection was made and not closed by this end. The other end may have gone: the next `read` tells.
    [[nodiscard]] bool is_open() const noexcept { return line_.is_open(); }

    /// The system's number of the open socket, in non-blocking mode, for `poll`, or for a signal handler, which writes by `send`
    /// with MSG_NOSIGNAL; -1 where none is open.
    [[nodiscard]] int descriptor_number() const noexcept { return line_.number(); }

    /// Host and port as they were given to `open`: "host:4001".
    [[nodiscard]] std::string const& device() const noexcept { return device_; }

    /// The last failure in words, beginning with host and port; empty before the first.
    [[nodiscard]] std::string const& failure() const noexcept { return failure_; }

    /// Passes all bytes to the connection; never raises a signal. Bytes that the far end has not confirmed for 5 s end the
    /// connection (Linux), so that an old request does not reach the wire when the network comes back. Errors:
    /// `transmit_stalled` (not taken before `until`), `device_not_open`, `device_vanished`, `device_failed`.
    result<void> write(byte_view bytes, instant until)
    {
        errno = 0;
        auto const written = line_.write_by(detail::send_some, bytes, until);
        return written ? written : lost(written.error());
    }

    /// Waits for at least one byte until the deadline and reads what is there; empty when there was none. Errors:
    /// `device_not_open`, `device_vanished` (the far end closed the connection, or is gone), `device_failed`.
    result<byte_span> read(byte_span place, instant until)
    {
        if (place.empty()) {
            return place;
        }
        errno = 0;
        auto const bytes = line_.read(place, until);
        if (not bytes) {
            return lost(bytes.error()).error();
        }
#ifdef TCP_QUICKACK
        // Many servers let a response wait until the one before is confirmed (Nagle): behind one that came late, each would
        // come behind the next request, and count as its response.
        if (not bytes->empty()) {
            detail::set_option(line_.number(), IPPROTO_TCP, TCP_QUICKACK, 1);
        }
#endif
        return bytes;
    }

    /// Now, on the clock of the deadlines.
    [[nodiscard]] static instant now() noexcept { return steady_now(); }

private:
    friend class tcp_acceptor;

    tcp_stream(detail::descriptor line, std::string device) : line_{std::move(line)}, device_{std::move(device)} {}

    result<void> failed(errc error, std::string const& what, std::string const& why)
    {
        failure_ = device_ + ": " + what + (why.empty() ? "" : " (" + why + ")");
        return error;
    }

    /// A failure of an open connection; errno is of it, or of a call that only had to wait.
    result<void> lost(errc error)
    {
        int const cause = errno;
        if (error != errc::device_vanished) {
            return failed(error, std::string{name(error)}, "");
        }
        bool const has_cause = cause != 0 and cause != EAGAIN and cause != EINTR and cause != EPIPE;
        return failed(error, "the connection is gone",
                      has_cause ? detail::system_text(cause) : "closed by the other end");
    }

    detail::descriptor line_{};
    std::string device_{};
    std::string failure_{};
};

} // namespace RTUWIRE_BUILD
} // namespace rtuwire
