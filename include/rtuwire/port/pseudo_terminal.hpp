// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// A serial line without hardware: a pseudo-terminal whose far end any program can open by name. Keeps the far
// end open itself, so that programs may open and close it, and unlocks it after a program that was killed.
#pragma once

#include <cerrno>
#include <chrono>
#include <cstdlib>
#include <string>
#include <utility>

#include <rtuwire/core/version.hpp>
#include <rtuwire/port/chrono.hpp>
#include <rtuwire/port/descriptor.hpp>
#include <rtuwire/port/terminal.hpp>

#ifndef _WIN32

#include <fcntl.h>
#include <stdlib.h>
#include <sys/file.h>
#include <sys/ioctl.h>
#include <termios.h>

namespace rtuwire {
inline namespace RTUWIRE_BUILD {

/// The near end of a pseudo-terminal. Can be moved; the far end vanishes with it.
class pseudo_terminal {
public:
    /// Makes the pair, neither of which becomes standard input, output or error output. Errors: `device_failed`,
    /// and those of setting up a line.
    result<void> open()
    {
        close();
        detail::standard_places const kept;
        detail::descriptor near{::posix_openpt(O_RDWR | O_NOCTTY | O_CLOEXEC)};
        if (not detail::standard_places::is_above(near.number())) {
            return errc::device_failed;
        }
        char path[64]{};
        bool const is_ready = ::grantpt(near.number()) == 0 and ::unlockpt(near.number()) == 0 and
                              ::ptsname_r(near.number(), path, sizeof path) == 0 and
                              ::fcntl(near.number(), F_SETFL, O_NONBLOCK) == 0;
        if (not is_ready) {
            return errc::device_failed;
        }
        detail::descriptor far{::open(path, O_RDWR | O_NOCTTY | O_CLOEXEC)};
        if (not detail::standard_places::is_above(far.number())) {
            return errc::device_failed;
        }
        std::string why;
        if (auto const set = detail::apply_line(far.number(), {}, why); not set) {
            return set;
        }
        near_ = std::move(near);
        far_ = std::move(far);
        path_ = path;
        return {};
    }

    void close() noexcept
    {
        near_.close();
        far_.close();
    }

    /// The name under which the far end can be opened as a serial device.
    [[nodiscard]] std::string const& path() const noexcept { return path_; }

    /// The system's number of the near end, for `poll`; -1 where none is open.
    [[nodiscard]] int descriptor_number() const noexcept { return near_.number(); }

    /// Sends all bytes. Errors: `transmit_stalled` when no program reads the far end, `device_not_open`,
    /// `device_failed`.
    result<void> write(byte_view bytes, instant until) const { return near_.write(bytes, until); }

    /// Waits for at least one byte until the deadline and reads what is there; empty when there was
    /// none. Errors: `device_not_open`, `device_failed`.
    result<byte_span> read(byte_span place, instant until)
    {
        auto const bytes = near_.read(place, until);
        if (bytes and bytes->empty() and clock::now() >= next_look_) {
            next_look_ = clock::now() + std::chrono::seconds{1};
            unlock_far_end();
        }
        return bytes;
    }

    /// Now, on the clock of the deadlines.
    [[nodiscard]] static instant now() noexcept { return steady_now(); }

private:
    using clock = std::chrono::steady_clock;

    /// A program that was killed while it used the far end exclusively (TIOCEXCL) cannot release it, and the
    /// far end is never closed. Where it is locked (flock), a program still uses it. Where the system does not tell
    /// whether it is in exclusive use (kernels before 3.8, emulated ones), that lock alone counts.
    void unlock_far_end() const noexcept
    {
#ifdef TIOCGEXCL
        int is_exclusive = 0;
        bool const may_be = ::ioctl(far_.number(), TIOCGEXCL, &is_exclusive) != 0 or is_exclusive != 0;
        if (may_be and ::flock(far_.number(), LOCK_EX | LOCK_NB) == 0) {
            static_cast<void>(::ioctl(far_.number(), TIOCNXCL));
            static_cast<void>(::flock(far_.number(), LOCK_UN));
        }
#endif
    }

    detail::descriptor near_;
    detail::descriptor far_;
    std::string path_;
    clock::time_point next_look_{clock::now()}; ///< counts 64 bits: nobody may read for an hour
};

} // namespace RTUWIRE_BUILD
} // namespace rtuwire

#endif
