// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// RTU frames over TCP, as serial device servers pass them on: the client's end of a connection, read and written with
// deadlines as a `posix_serial` is. Every failure is an errc for programs and a sentence with host and port for people.
#pragma once

#include <cerrno>
#include <cstdint>
#include <cstring>
#include <memory>
#include <string>
#include <utility>

#include <sys/socket.h>

#include <rtuwire/core/version.hpp>
#include <rtuwire/port/chrono.hpp>
#include <rtuwire/port/descriptor.hpp>
#include <rtuwire/port/host_lookup.hpp>
#include <rtuwire/port/tcp_connection.hpp>
#include <rtuwire/wire/errc_name.hpp>

namespace rtuwire {
inline namespace RTUWIRE_BUILD {

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
        return failed(detail::connect_error(failure), "no connection", std::strerror(failure));
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
        auto const written = line_.write_by(
            [](int number, byte_view part) { return ::send(number, part.data(), part.size(), without_signal); }, bytes,
            until);
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
        return bytes;
    }

    /// Now, on the clock of the deadlines.
    [[nodiscard]] static instant now() noexcept { return steady_now(); }

private:
#ifdef MSG_NOSIGNAL
    static constexpr int without_signal = MSG_NOSIGNAL;
#else
    static constexpr int without_signal = 0; // the socket's option SO_NOSIGPIPE says it
#endif

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
        return failed(error, "the connection is gone", has_cause ? std::strerror(cause) : "closed by the other end");
    }

    detail::descriptor line_{};
    std::string device_{};
    std::string failure_{};
};

} // namespace RTUWIRE_BUILD
} // namespace rtuwire
