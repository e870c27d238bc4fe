// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// A serial device of a POSIX host: opened exclusively, set up for Modbus, read and written with deadlines.
// Reports which bytes arrived damaged, as the terminal marks them (termios, PARMRK): FF 00 x is a byte x with a parity or
// framing error, FF 00 00 also a break, and FF FF is an undamaged byte FF. May let `read` itself wait for bytes by the
// terminal's own timer (VMIN 0, VTIME): one system call where a poll and a read are two. What opening changed is undone in
// whichever way it closes: the kernel keeps the flag of TIOCEXCL as long as any process has the device open. Every failure is
// an errc for programs and a sentence with the device's name for people.
#pragma once

#include <array>
#include <cerrno>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <string>
#include <utility>

#include <rtuwire/core/bytes.hpp>
#include <rtuwire/core/version.hpp>
#include <rtuwire/port/chrono.hpp>
#include <rtuwire/port/descriptor.hpp>
#include <rtuwire/port/serial_settings.hpp>
#include <rtuwire/port/terminal.hpp>
#include <rtuwire/port/transceiver.hpp>
#include <rtuwire/rtu/line.hpp>
#include <rtuwire/wire/errc_name.hpp>

#ifndef _WIN32

#include <fcntl.h>
#include <sys/file.h>
#include <sys/ioctl.h>
#include <sys/stat.h>
#include <termios.h>
#include <unistd.h>

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

/// Removes the marks from a stream of bytes, in chunks of any size.
class error_marks {
public:
    /// What one call did.
    struct part {
        std::size_t taken{0};  ///< so many marked bytes are used up
        std::size_t size{0};   ///< so many bytes were written
        bool has_error{false}; ///< a damaged byte came after them
    };

    /// Writes the bytes without their marks to `place`, until `place` is full or a byte was damaged. The
    /// damaged byte itself is left out. What was not taken belongs to the next call.
    constexpr part take(byte_view marked, byte_span place) noexcept
    {
        part done{};
        while (done.taken < marked.size() and done.size < place.size() and not done.has_error) {
            std::byte const byte = marked[done.taken];
            bool const is_first = byte == std::byte{0xFF};
            if (state_ == state::begun and not is_first and byte != std::byte{0}) {
                // An FF that marks nothing: bytes are missing here. This byte is examined again.
                state_ = state::outside;
                done.has_error = true;
                continue;
            }
            ++done.taken;
            if (state_ == state::damaged) {
                state_ = state::outside;
                done.has_error = true;
            } else if (state_ == state::outside and is_first) {
                state_ = state::begun;
            } else if (state_ == state::begun and not is_first) {
                state_ = state::damaged;
            } else {
                state_ = state::outside;
                place[done.size++] = byte;
            }
        }
        return done;
    }

    /// Forgets an incomplete mark.
    constexpr void restart() noexcept { state_ = state::outside; }

private:
    enum class state : std::uint8_t {
        outside,
        begun,   ///< after FF
        damaged, ///< after FF 00
    };

    state state_{state::outside};
};

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

/// A serial device. Can be moved; its destructor closes it and leaves the device as it was set up, but for the switching of a
/// transceiver, which is put back.
class posix_serial {
public:
    /// Opens a device and sets it up; what was open before is closed. On an error nothing is open and `failure()`
    /// says why: `device_not_found`, `device_access_denied`, `device_in_use`, `device_not_serial`,
    /// `device_setting_refused`, `device_vanished`, `device_failed`. The device never becomes standard input,
    /// output or error output, even where these are closed.
    result<void> open(std::string const& device, serial_settings const& settings = {})
    {
        close();
        device_ = device;
        detail::standard_places const kept;
        detail::exclusive_device opened{
            detail::descriptor{::open(device.c_str(), O_RDWR | O_NOCTTY | O_NONBLOCK | O_CLOEXEC)}};
        if (not opened.is_open()) {
            return failed(detail::device_error(errno), errno);
        }
        if (not detail::standard_places::is_above(opened.number())) {
            return failed(errc::device_failed);
        }
        if (::isatty(opened.number()) == 0) {
            return failed(errc::device_not_serial);
        }
        detail::timed_reader reader;
        if (auto const wanted = settings.waits_in_read ? reader.open(device, opened.number()) : result<void>{};
            not wanted) {
            return failed(wanted.error());
        }
        if (auto const locked = opened.lock(); not locked) {
            return failed(locked.error(), errno);
        }
        std::string why;
        if (auto const set = detail::apply_line(opened.number(), settings, why, detail::marks_errors); not set) {
            return failed(set.error(), why);
        }
        if (auto const set = opened.set_transceiver(settings.rs485, settings.transceiver, why); not set) {
            return failed(set.error(), why);
        }
        has_low_latency_ = detail::request_low_latency(opened.number());
        timing_ = detail::is_usb_device(opened.number()) ? line_timing::usb(settings.bits_per_second, settings.format)
                                                         : line_timing::host(settings.bits_per_second, settings.format);
        ::tcflush(opened.number(), TCIOFLUSH);
        opened.keep_settings();
        opened_ = std::move(opened);
        reader_ = std::move(reader);
        return {};
    }

    void close() noexcept
    {
        reader_.close();
        opened_.close();
        marks_.restart();
        first_ = last_ = 0;
        has_receive_error_ = false;
        has_low_latency_ = false;
    }

    /// Whether a device was opened, not closed, and is still there: the system is asked. One that vanished is to be
    /// opened anew.
    [[nodiscard]] bool is_open() const noexcept { return opened_.is_open() and not opened_.line().has_vanished(); }

    /// The system's number of the open device, in non-blocking mode, for a signal handler that must not call `write`;
    /// -1 where none is open.
    [[nodiscard]] int descriptor_number() const noexcept { return opened_.number(); }

    /// Whether the driver passes bytes on at once: `open` always asks for that (Linux: ASYNC_LOW_LATENCY), and the driver
    /// said that it will. False where it refused, as a pseudo-terminal's does, where nothing is open and on other systems:
    /// a USB adapter may then hand bytes over up to 16 ms late.
    [[nodiscard]] bool has_low_latency() const noexcept { return has_low_latency_; }

    /// The times that suit the device opened last and what it was set up with: `line_timing::usb` of one behind a USB bus,
    /// as Linux tells, `line_timing::host` of any other; before the first those of 19 200 bit/s and 8E1. A `blocking_client`
    /// that is given no others takes these when it is made, so open the device first.
    [[nodiscard]] line_timing timing() const noexcept { return timing_; }

    /// The device's name as it was given to `open`.
    [[nodiscard]] std::string const& device() const noexcept { return device_; }

    /// The last failure in words, beginning with the device's name; empty before the first.
    [[nodiscard]] std::string const& failure() const noexcept { return failure_; }

    /// Passes all bytes to the driver, which sends them at the line's speed. Errors: `transmit_stalled` (not taken before `until`),
    /// `device_not_open`, `device_vanished`, `device_failed`.
    result<void> write(byte_view bytes, instant until)
    {
        auto const written = opened_.line().write(bytes, until);
        if (not written) {
            return failed(written.error());
        }
        return written;
    }

    /// Waits for at least one byte until the deadline and reads what is there, up to the first damaged one,
    /// which `take_receive_error` then reports; empty when there was none. Errors: `device_not_open`,
    /// `device_vanished`, `device_failed`.
    result<byte_span> read(byte_span place, instant until)
    {
        if (not opened_.is_open()) {
            return failed(errc::device_not_open).error();
        }
        host_deadline const end{until}; // once: it may be read several times
        while (not place.empty()) {
            detail::error_marks::part const part = unmark(place);
            has_receive_error_ = has_receive_error_ or part.has_error;
            if (part.size > 0 or part.has_error) {
                return place.first(part.size);
            }
            auto const bytes = arrived(end);
            if (not bytes) {
                return failed(bytes.error()).error();
            }
            if (bytes->empty()) {
                return place.first(0);
            }
            first_ = 0;
            last_ = bytes->size();
        }
        return place;
    }

    /// Whether a byte arrived damaged (parity, framing, break) right behind the bytes read last; reported
    /// once. That byte is left out.
    [[nodiscard]] bool take_receive_error() noexcept { return std::exchange(has_receive_error_, false); }

    /// Now, on the clock of the deadlines.
    [[nodiscard]] static instant now() noexcept { return steady_now(); }

private:
    result<void> failed(errc error, std::string const& why = {})
    {
        failure_ = device_ + ": " + std::string{name(error)} + (why.empty() ? "" : " (" + why + ")");
        return error;
    }
    result<void> failed(errc error, int system_error)
    {
        return failed(error, std::string{std::strerror(system_error)});
    }

    /// What the device delivers before a deadline; by the terminal's timer first, where that is wanted.
    result<byte_span> arrived(host_deadline const& until) noexcept
    {
        if (auto const bytes = reader_.read(input_, until); not bytes or not bytes->empty()) {
            return bytes;
        }
        return opened_.line().read(input_, until);
    }

    /// The next bytes of those that the device delivered.
    detail::error_marks::part unmark(byte_span place) noexcept
    {
        byte_view const unread = byte_view{input_}.subspan(first_, last_ - first_);
        detail::error_marks::part const part = marks_.take(unread, place);
        first_ += part.taken;
        return part;
    }

    detail::exclusive_device opened_;
    detail::timed_reader reader_;
    std::array<std::byte, 512> input_{}; ///< from `first_` to `last_` not passed on yet
    std::size_t first_{0};
    std::size_t last_{0};
    detail::error_marks marks_{};
    bool has_receive_error_{false};
    bool has_low_latency_{false};
    line_timing timing_{line_timing::host(19'200, character_format::even_8_1)};
    std::string device_;
    std::string failure_;
};

/// A serial device of this system, by one name on all.
using host_serial = posix_serial;

} // namespace RTUWIRE_BUILD
} // namespace rtuwire

#endif
