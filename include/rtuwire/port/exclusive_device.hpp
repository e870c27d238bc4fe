// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// A serial device locked against other programs. Undoes what it changed, in whichever way it closes: the
// kernel keeps the flag of TIOCEXCL as long as any process has the device open.
#pragma once

#include <cerrno>
#include <string>
#include <utility>

#include <rtuwire/core/version.hpp>
#include <rtuwire/port/descriptor.hpp>
#include <rtuwire/port/terminal.hpp>
#include <rtuwire/port/transceiver.hpp>

#ifndef _WIN32

#include <sys/file.h>
#include <sys/ioctl.h>
#include <termios.h>

namespace rtuwire {
inline namespace RTUWIRE_BUILD {

namespace detail {

/// The descriptor of a serial device, and what was changed on that device. Can be moved. When it is closed,
/// assigned to or destroyed, the device is unlocked, and has its old settings again, those of the line unless
/// `keep_settings` was called. A process that is killed undoes nothing: a device that another process has open then stays
/// locked for all users but root.
class exclusive_device {
public:
    exclusive_device() noexcept = default;
    explicit exclusive_device(descriptor opened) noexcept : descriptor_{std::move(opened)} {}
    exclusive_device(exclusive_device&& other) noexcept
        : descriptor_{std::move(other.descriptor_)}, before_{other.before_}, transceiver_{other.transceiver_},
          is_locked_{std::exchange(other.is_locked_, false)}, restores_{other.restores_}
    {
        other.transceiver_.release();
    }
    exclusive_device& operator=(exclusive_device&& other) noexcept
    {
        if (this != &other) {
            close();
            descriptor_ = std::move(other.descriptor_);
            before_ = other.before_;
            transceiver_ = other.transceiver_;
            other.transceiver_.release();
            is_locked_ = std::exchange(other.is_locked_, false);
            restores_ = other.restores_;
        }
        return *this;
    }
    ~exclusive_device() { close(); }

    /// Keeps out programs that ask for a lock (flock) and those of users other than root that do not
    /// (TIOCEXCL). Errors: `device_in_use` and the others of `device_error`.
    result<void> lock() noexcept
    {
        if (::flock(number(), LOCK_EX | LOCK_NB) != 0) {
            return device_error(errno);
        }
        is_locked_ = true;
        restores_ = before_.read(driver_call{number()}, number());
        if (::ioctl(number(), TIOCEXCL) != 0) {
            return device_error(errno);
        }
        return {};
    }

    /// Lets the kernel switch the transceiver as it is asked to, until the device is closed. `device_setting_refused`, and
    /// why, where it does not.
    result<void> set_transceiver(rs485_mode mode, transceiver_settings const& asked, std::string& why)
    {
        return transceiver_.set(driver_call{number()}, mode, asked, why);
    }

    /// The settings of the line that the device has now stay when it closes.
    void keep_settings() noexcept { restores_ = false; }

    void close() noexcept
    {
        if (is_locked_) {
            is_locked_ = false;
            if (transceiver_.is_changed()) {
                ::tcdrain(number()); // a frame on its way still needs it
                transceiver_.restore(driver_call{number()});
            }
            if (restores_) {
                before_.put_back(driver_call{number()}, number());
            }
            // The flag first: once the lock is gone, the next owner may have set it.
            static_cast<void>(::ioctl(number(), TIOCNXCL));
            static_cast<void>(::flock(number(), LOCK_UN));
        }
        descriptor_.close();
    }

    [[nodiscard]] bool is_open() const noexcept { return descriptor_.is_open(); }
    [[nodiscard]] int number() const noexcept { return descriptor_.number(); }
    [[nodiscard]] descriptor const& line() const noexcept { return descriptor_; }

private:
    descriptor descriptor_{};
    line_before before_{};
    transceiver_control transceiver_{};
    bool is_locked_{false};
    bool restores_{false};
};

} // namespace detail

} // namespace RTUWIRE_BUILD
} // namespace rtuwire

#endif
