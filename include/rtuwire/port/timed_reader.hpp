// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// A terminal whose `read` itself waits for bytes, by the terminal's own timer (termios: VMIN 0, VTIME): one system call
// where a poll and a read are two.
#pragma once

#include <cerrno>
#include <cstddef>
#include <string>
#include <utility>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <rtuwire/core/version.hpp>
#include <rtuwire/port/chrono.hpp>
#include <rtuwire/port/descriptor.hpp>
#include <rtuwire/port/serial_settings.hpp>
#include <rtuwire/port/standard_places.hpp>

namespace rtuwire {
inline namespace RTUWIRE_BUILD {

namespace detail {

/// A second descriptor of an open serial device, in blocking mode: the first one stays as it is, so that a write still
/// ends at its deadline. Can be moved. A closed one never waits.
class timed_reader {
public:
    /// Opens the device once more: before it is locked, which keeps out everyone. Errors: those of `device_error`;
    /// `device_vanished` where the name is another device's by now.
    [[nodiscard]] result<void> open(std::string const& device, int opened)
    {
        descriptor line{::open(device.c_str(), O_RDWR | O_NOCTTY | O_NONBLOCK | O_CLOEXEC)};
        if (not line.is_open()) {
            return device_error(errno);
        }
        if (not standard_places::is_above(line.number())) {
            return errc::device_failed;
        }
        if (not are_same_device(line.number(), opened)) {
            return errc::device_vanished;
        }
        // Only now: without the flag, `open` itself may wait for a modem.
        if (::fcntl(line.number(), F_SETFL, 0) != 0) {
            return device_error(errno);
        }
        line_ = std::move(line);
        return {};
    }

    void close() noexcept { line_.close(); }

    /// Waits for bytes for one period of the timer, where that much time is left. Nothing: whoever wants to wait on has to
    /// poll, which also tells whether the device is still there. Errors: `device_vanished`, `device_failed`.
    result<byte_span> read(byte_span place, host_deadline const& until) const noexcept
    {
        if (not line_.is_open() or until.left() < least_wait) {
            return place.first(0);
        }
        ssize_t const count = ::read(line_.number(), place.data(), place.size());
        if (count >= 0) {
            return place.first(static_cast<std::size_t>(count));
        }
        if (errno == EINTR or errno == EAGAIN) {
            return place.first(0);
        }
        return device_error(errno);
    }

private:
    /// A period of the timer and what the kernel may add: it counts in ticks of up to 10 ms, and rounds up.
    static constexpr duration least_wait = terminal_timer + milliseconds(20);

    static bool are_same_device(int one, int other) noexcept
    {
        struct stat first {};
        struct stat second {};
        return ::fstat(one, &first) == 0 and ::fstat(other, &second) == 0 and first.st_rdev == second.st_rdev;
    }

    descriptor line_{};
};

} // namespace detail

} // namespace RTUWIRE_BUILD
} // namespace rtuwire
