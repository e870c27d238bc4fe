// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// A serial device of a POSIX host: opened exclusively, set up for Modbus, read and written with
// deadlines. Every failure is an errc for programs and a sentence with the device's name for people.
#pragma once

#include <cerrno>
#include <cstring>
#include <string>
#include <utility>

#include <fcntl.h>
#include <sys/file.h>
#include <sys/ioctl.h>
#include <termios.h>

#include <rtuwire/port/chrono.hpp>
#include <rtuwire/port/descriptor.hpp>
#include <rtuwire/port/serial_settings.hpp>
#include <rtuwire/wire/errc_name.hpp>

namespace rtuwire {

/// A serial device. Can be moved; closes when it goes and leaves the device as it was set up.
class posix_serial {
public:
    /// Opens a device and sets it up; what was open before is closed. On an error nothing is open and
    /// `failure()` says why: `device_not_found`, `device_access_denied`, `device_in_use`,
    /// `device_not_serial`, `device_setting_refused`, `device_vanished`, `device_failed`.
    result<void> open(std::string const& device, serial_settings const& settings = {})
    {
        close();
        device_ = device;
        descriptor opened{::open(device.c_str(), O_RDWR | O_NOCTTY | O_NONBLOCK | O_CLOEXEC)};
        if (not opened.is_open()) {
            return failed(device_error(errno), errno);
        }
        if (::isatty(opened.number()) == 0) {
            return failed(errc::device_not_serial);
        }
        if (::flock(opened.number(), LOCK_EX | LOCK_NB) != 0 or
            ::ioctl(opened.number(), TIOCEXCL) != 0) {
            return failed(device_error(errno), errno);
        }
        if (auto const set = apply_line(opened.number(), settings); not set) {
            return failed(set.error());
        }
        if (auto const set = apply_rs485(opened.number(), settings.rs485); not set) {
            return failed(set.error(), errno);
        }
        request_low_latency(opened.number());
        ::tcflush(opened.number(), TCIOFLUSH);
        descriptor_ = std::move(opened);
        return {};
    }

    void close() noexcept
    {
        if (not descriptor_.is_open()) {
            return;
        }
        static_cast<void>(::ioctl(descriptor_.number(), TIOCNXCL));
        descriptor_.close();
    }

    [[nodiscard]] bool is_open() const noexcept { return descriptor_.is_open(); }

    /// The device's name as it was given to `open`.
    [[nodiscard]] std::string const& device() const noexcept { return device_; }

    /// The last failure in words, beginning with the device's name; empty before the first.
    [[nodiscard]] std::string const& failure() const noexcept { return failure_; }

    /// Hands all octets to the driver, which sends them at the line's pace. Errors: `timed_out`,
    /// `device_vanished`, `device_failed`.
    result<void> write(byte_view octets, instant until)
    {
        auto const written = descriptor_.write(octets, until);
        if (not written) {
            return failed(written.error());
        }
        return written;
    }

    /// Waits for at least one octet until the deadline and reads what is there; empty when there was
    /// none. Errors: `device_vanished`, `device_failed`.
    result<byte_span> read(byte_span place, instant until)
    {
        auto const octets = descriptor_.read(place, until);
        if (not octets) {
            return failed(octets.error()).error();
        }
        return octets;
    }

    /// Now, on the clock that deadlines are of.
    [[nodiscard]] static instant now() noexcept { return steady_now(); }

private:
    result<void> failed(errc error, int system_error = 0)
    {
        failure_ = device_ + ": " + std::string{name(error)};
        if (system_error != 0) {
            failure_ += std::string{" ("} + std::strerror(system_error) + ")";
        }
        return error;
    }

    descriptor descriptor_;
    std::string device_;
    std::string failure_;
};

} // namespace rtuwire
