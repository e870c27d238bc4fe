// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// A POSIX file descriptor of a line, on Windows a socket: owned, read and written with deadlines. Turns every failure into
// an errc, and reports a vanished device at once and at each further call. Keeps such a line off the numbers 0, 1 and 2: a
// program may be started with these closed; the line would get one of them, and what the program prints would go to the
// drives.
#pragma once

#include <array>
#include <cerrno>
#include <cstddef>
#include <utility>

#include <rtuwire/core/bytes.hpp>
#include <rtuwire/core/result.hpp>
#include <rtuwire/core/time.hpp>
#include <rtuwire/core/version.hpp>
#include <rtuwire/port/chrono.hpp>
#include <rtuwire/port/platform.hpp>
#include <rtuwire/wire/errc.hpp>

namespace rtuwire {
inline namespace RTUWIRE_BUILD {

namespace detail {

/// The error for a failed system call on a device.
[[nodiscard]] inline errc device_error(int system_error) noexcept
{
    switch (system_error) {
    case ENOENT: return errc::device_not_found;
    case EACCES:
    case EPERM: return errc::device_access_denied;
    case EBUSY:
    case EWOULDBLOCK: return errc::device_in_use;
    case ENOTTY:
    case EISDIR: return errc::device_not_serial;
    case EINVAL: return errc::device_setting_refused;
    case EIO:
    case ENXIO:
    case ENODEV:
    case EPIPE:
    case ECONNRESET:
    case ETIMEDOUT:
    case EHOSTUNREACH:
    case ENETUNREACH: return errc::device_vanished;
    default: return errc::device_failed;
    }
}

/// An open descriptor in non-blocking mode, closed by its destructor. Can be moved.
class descriptor {
public:
    descriptor() noexcept = default;
    explicit descriptor(int number) noexcept : number_{number} {}
    descriptor(descriptor&& other) noexcept : number_{std::exchange(other.number_, -1)} {}
    descriptor& operator=(descriptor&& other) noexcept
    {
        if (this != &other) {
            close();
            number_ = std::exchange(other.number_, -1);
        }
        return *this;
    }
    ~descriptor() { close(); }

    void close() noexcept
    {
        if (number_ >= 0) {
            close_number(std::exchange(number_, -1));
        }
    }

    [[nodiscard]] bool is_open() const noexcept { return number_ >= 0; }
    [[nodiscard]] int number() const noexcept { return number_; }

    /// Whether the system says of an open one that nothing is behind it any more, though bytes of it may be left to read.
    [[nodiscard]] bool has_vanished() const noexcept
    {
        pollfd line = watched(number_, 0);
        return is_open() and poll_for(&line, 1, duration{}) > 0;
    }

    /// Sends all bytes. Errors: `transmit_stalled` when the deadline passes first, part of them sent;
    /// `device_not_open`, `device_vanished`, `device_failed`.
    result<void> write(byte_view bytes, host_deadline const& until) const noexcept
    {
        return write_by(write_some, bytes, until);
    }

    /// The same by another call: `send(number, bytes)` returns what `write_some` does, and sets errno as it does.
    template <typename Send>
    result<void> write_by(Send send, byte_view bytes, host_deadline const& until) const noexcept
    {
        if (not is_open()) {
            return errc::device_not_open;
        }
        while (not bytes.empty()) {
            std::ptrdiff_t const count = send(number_, bytes);
            if (count > 0) {
                bytes = bytes.subspan(static_cast<std::size_t>(count));
                continue;
            }
            if (count < 0 and errno == EINTR) {
                continue;
            }
            if (count < 0 and errno != EAGAIN) {
                return device_error(errno);
            }
            auto const ready = wait(POLLOUT, until);
            if (not ready) {
                return ready.error();
            }
            if (not *ready) {
                return errc::transmit_stalled;
            }
        }
        return {};
    }

    /// Whether it took bytes before the deadline; a connection that is being made: whether it was made, or failed.
    result<bool> wait_to_write(host_deadline const& until) const noexcept { return wait(POLLOUT, until); }

    /// Waits until there is at least one byte or the deadline has passed, and reads what is there: an
    /// empty part of `place` when there was nothing. Errors: `device_not_open`, `device_vanished`,
    /// `device_failed`.
    result<byte_span> read(byte_span place, host_deadline const& until) const noexcept
    {
        if (not is_open()) {
            return errc::device_not_open;
        }
        for (;;) {
            auto const ready = wait(POLLIN, until);
            if (not ready) {
                return ready.error();
            }
            if (not *ready) {
                return place.first(0);
            }
            std::ptrdiff_t const count = read_some(number_, place);
            if (count > 0) {
                return place.first(static_cast<std::size_t>(count));
            }
            if (count == 0) {
                return errc::device_vanished;
            }
            if (errno != EINTR and errno != EAGAIN) {
                return device_error(errno);
            }
        }
    }

private:
    /// Whether the descriptor became ready before the deadline. A hang-up counts as ready while bytes
    /// are left to read, and as vanished after that.
    result<bool> wait(short events, host_deadline const& until) const noexcept
    {
        for (;;) {
            pollfd line = watched(number_, events);
            int const count = poll_for(&line, 1, until.left());
            if (count == 0) {
                return false;
            }
            if (count < 0 and errno == EINTR) {
                continue;
            }
            if (count < 0) {
                return errc::device_failed;
            }
            if ((line.revents & events) != 0) {
                return true;
            }
            return errc::device_vanished;
        }
    }

    int number_{-1};
};

#ifdef _WIN32

/// A socket is never the number of a standard stream.
class standard_places {
public:
    standard_places() noexcept {}
    [[nodiscard]] static constexpr bool is_above(int number) noexcept { return number > 0; }
};

#else

/// While it lives, every file opened gets a number above those of standard input, output and error output,
/// even where these are closed: /dev/null fills them meanwhile. On a system without /dev/null, check with
/// `is_above`.
class standard_places {
public:
    standard_places() noexcept
    {
        for (descriptor& each : held_) {
            descriptor lowest{::open("/dev/null", O_RDWR | O_CLOEXEC)};
            if (is_above(lowest.number())) {
                return;
            }
            each = std::move(lowest);
        }
    }

    /// Whether a number is above the standard ones; false where nothing is open.
    [[nodiscard]] static constexpr bool is_above(int number) noexcept { return number > STDERR_FILENO; }

private:
    std::array<descriptor, 3> held_{};
};

#endif

} // namespace detail

} // namespace RTUWIRE_BUILD
} // namespace rtuwire
