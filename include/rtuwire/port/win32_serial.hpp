// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// A serial port of Windows: opened exclusively, set up for Modbus, read and written with deadlines, as a `posix_serial` is. Each
// call is an overlapped one that this ends at its deadline, by a timer that knows less than the tick of 16 ms: the driver's own
// time-outs are off, as those of many adapters' are not what they should be. Every failure is an errc for programs and a
// sentence with the port's name for people. Empty on other systems.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>

#include <rtuwire/core/bytes.hpp>
#include <rtuwire/core/result.hpp>
#include <rtuwire/core/time.hpp>
#include <rtuwire/core/version.hpp>
#include <rtuwire/port/chrono.hpp>
#include <rtuwire/port/platform.hpp>
#include <rtuwire/port/serial_settings.hpp>
#include <rtuwire/port/win32_ports.hpp>
#include <rtuwire/rtu/line.hpp>
#include <rtuwire/wire/errc.hpp>
#include <rtuwire/wire/errc_name.hpp>

#ifdef _WIN32

namespace rtuwire {
inline namespace RTUWIRE_BUILD {

/// Whether a device may be opened at a rate; whether its driver keeps it only `open` tells. From 65 bit/s on, as a
/// `line_timing`.
[[nodiscard]] constexpr bool is_bit_rate(std::uint32_t bits_per_second) noexcept
{
    constexpr std::uint32_t lowest = 65;
    return bits_per_second >= lowest;
}

namespace detail {

/// The error of a call that failed on a device: while it was opened, or behind that.
[[nodiscard]] inline errc open_error(DWORD system_error) noexcept
{
    switch (system_error) {
    case ERROR_FILE_NOT_FOUND:
    case ERROR_PATH_NOT_FOUND:
    case ERROR_INVALID_NAME:
    case ERROR_BAD_PATHNAME:
    case ERROR_DEV_NOT_EXIST: return errc::device_not_found;
    case ERROR_ACCESS_DENIED: // what Windows says of a port that somebody has open
    case ERROR_SHARING_VIOLATION:
    case ERROR_BUSY: return errc::device_in_use;
    case ERROR_GEN_FAILURE:
    case ERROR_NOT_READY:
    case ERROR_DEVICE_NOT_CONNECTED: return errc::device_vanished;
    default: return errc::device_failed;
    }
}
[[nodiscard]] inline errc use_error(DWORD system_error) noexcept
{
    switch (system_error) {
    case ERROR_FILE_NOT_FOUND:
    case ERROR_ACCESS_DENIED:
    case ERROR_INVALID_HANDLE:
    case ERROR_BAD_COMMAND:
    case ERROR_GEN_FAILURE:
    case ERROR_NOT_READY:
    case ERROR_BROKEN_PIPE:
    case 433:                     // ERROR_NO_SUCH_DEVICE, which not all headers have
    case ERROR_OPERATION_ABORTED: // by the driver: what this ends does not come here
    case ERROR_IO_DEVICE:
    case ERROR_DEVICE_NOT_CONNECTED:
    case ERROR_DEVICE_REMOVED: return errc::device_vanished;
    default: return errc::device_failed;
    }
}

/// Something of Windows that is closed by its destructor. Can be moved.
class handle {
public:
    handle() noexcept = default;
    explicit handle(HANDLE its_handle) noexcept
        : handle_{its_handle == INVALID_HANDLE_VALUE ? nullptr : its_handle} // calls differ in what is none
    {}
    handle(handle&& other) noexcept : handle_{std::exchange(other.handle_, nullptr)} {}
    handle& operator=(handle&& other) noexcept
    {
        if (this != &other) {
            close();
            handle_ = std::exchange(other.handle_, nullptr);
        }
        return *this;
    }
    handle(handle const&) = delete;
    handle& operator=(handle const&) = delete;
    ~handle() { close(); }

    void close() noexcept
    {
        if (handle_ != nullptr) {
            ::CloseHandle(std::exchange(handle_, nullptr));
        }
    }

    [[nodiscard]] bool is_open() const noexcept { return handle_ != nullptr; }
    [[nodiscard]] HANDLE get() const noexcept { return handle_; }

private:
    HANDLE handle_{nullptr};
};

/// A character format as a port's settings have it.
inline void set_format(DCB& line, character_format format) noexcept
{
    bool const is_even = format == character_format::even_8_1 or format == character_format::even_8_2;
    bool const is_odd = format == character_format::odd_8_1 or format == character_format::odd_8_2;
    bool const has_two_stops = format == character_format::none_8_2 or format == character_format::even_8_2 or
                               format == character_format::odd_8_2;
    line.ByteSize = 8;
    line.Parity = is_even ? EVENPARITY : is_odd ? ODDPARITY : NOPARITY;
    line.fParity = is_even or is_odd ? 1 : 0;
    line.StopBits = has_two_stops ? TWOSTOPBITS : ONESTOPBIT;
}

/// A format as people write it: data bits, parity, stop bits.
[[nodiscard]] inline std::string format_text(DCB const& line)
{
    constexpr char parities[]{"NOEMS"};
    std::string text = std::to_string(line.ByteSize);
    text += line.Parity < sizeof parities - 1 ? parities[line.Parity] : '?';
    return text + (line.StopBits == TWOSTOPBITS ? "2" : line.StopBits == ONESTOPBIT ? "1" : "1.5");
}

} // namespace detail

/// A serial port. Can be moved; its destructor closes it and leaves the port as it was set up.
class win32_serial {
public:
    /// Opens a port and sets it up; what was open before is closed. The name is Windows' own: "COM3", "COM10", or with `\\.\` in
    /// front; in UTF-8. DTR and RTS are on while it is open. On an error nothing is open and `failure()` says why:
    /// `device_not_found`, `device_in_use` (by another program, or Windows denies it to this user: it says the same of both),
    /// `device_not_serial`, `device_setting_refused`, `device_vanished`, `device_failed`.
    result<void> open(std::string const& device, serial_settings const& settings = {})
    {
        close();
        device_ = device;
        std::wstring const path = detail::wide(device.starts_with("\\\\") ? device : "\\\\.\\" + device);
        detail::handle opened{::CreateFileW(path.c_str(), GENERIC_READ | GENERIC_WRITE, 0, nullptr, OPEN_EXISTING,
                                            FILE_FLAG_OVERLAPPED, nullptr)};
        if (not opened.is_open()) {
            DWORD const why = ::GetLastError();
            return failed(detail::open_error(why), why);
        }
        detail::handle ended{::CreateEventW(nullptr, TRUE, FALSE, nullptr)};
        detail::handle timer = exact_timer();
        if (not ended.is_open() or not timer.is_open()) {
            return failed(errc::device_failed, ::GetLastError());
        }
        if (auto const set = set_up(opened.get(), settings); not set) {
            return set;
        }
        timing_ = detail::is_usb_port(device) ? line_timing::usb(settings.bits_per_second, settings.format)
                                              : line_timing::host(settings.bits_per_second, settings.format);
        port_ = std::move(opened);
        ended_ = std::move(ended);
        timer_ = std::move(timer);
        return {};
    }

    void close() noexcept
    {
        port_.close();
        ended_.close();
        timer_.close();
        has_receive_error_ = false;
    }

    /// Whether a port was opened, not closed, and is still there: the system is asked. One that vanished is to be opened anew.
    [[nodiscard]] bool is_open() const noexcept
    {
        DCB line{};
        line.DCBlength = sizeof line;
        return port_.is_open() and ::GetCommState(port_.get(), &line) != 0;
    }

    /// The system's handle of the open port, for overlapped calls, for a thread that must not call `write`, as that of a console's
    /// events; null where none is open.
    [[nodiscard]] void* handle() const noexcept { return port_.get(); }

    /// False: Windows has no such request. An adapter's latency, up to 16 ms, is set where its driver is.
    [[nodiscard]] static constexpr bool has_low_latency() noexcept { return false; }

    /// The times that suit the port opened last and what it was set up with: `line_timing::usb` of one behind a USB bus, as the
    /// registry tells, `line_timing::host` of any other; before the first those of 19 200 bit/s and 8E1. A `blocking_client`
    /// that is given no others takes these when it is made, so open the port first.
    [[nodiscard]] line_timing timing() const noexcept { return timing_; }

    /// The port's name as it was given to `open`.
    [[nodiscard]] std::string const& device() const noexcept { return device_; }

    /// The last failure in words, beginning with the port's name; empty before the first.
    [[nodiscard]] std::string const& failure() const noexcept { return failure_; }

    /// Passes all bytes to the driver, which returns once they have left, or are on their way to an adapter. Errors:
    /// `transmit_stalled` (not taken before `until`; part of them may have been sent), `device_not_open`, `device_vanished`,
    /// `device_failed`.
    result<void> write(byte_view bytes, instant until)
    {
        if (not port_.is_open()) {
            return failed(errc::device_not_open);
        }
        host_deadline const end{until};
        while (not bytes.empty()) {
            auto const count = transfer(
                [&](OVERLAPPED& call) {
                    return ::WriteFile(port_.get(), bytes.data(), static_cast<DWORD>(bytes.size()), nullptr, &call);
                },
                end);
            if (not count) {
                return failed(count.error());
            }
            bytes = bytes.subspan(*count);
            if (not bytes.empty() and (*count == 0 or end.left() == duration{})) {
                return failed(errc::transmit_stalled);
            }
        }
        return {};
    }

    /// Waits for at least one byte until the deadline and reads what is there; empty when there was none. Errors:
    /// `device_not_open`, `device_vanished`, `device_failed`.
    result<byte_span> read(byte_span place, instant until)
    {
        if (not port_.is_open()) {
            return failed(errc::device_not_open).error();
        }
        host_deadline const end{until}; // once: it is read several times
        std::size_t size = 0;
        for (std::size_t wanted = place.empty() ? 0 : 1; wanted > 0;) {
            auto const waiting = bytes_waiting();
            if (not waiting) {
                return failed(waiting.error()).error();
            }
            // As many as are there, and where none are, the first to come: a driver waits for all that a call asks for.
            wanted = std::min(place.size() - size, size == 0 ? std::max<std::size_t>(*waiting, 1) : *waiting);
            if (wanted == 0) {
                break;
            }
            auto const part = place.subspan(size, wanted);
            bool const is_there = size > 0 or *waiting > 0; // taken behind the deadline, too
            auto const count = transfer(
                [&](OVERLAPPED& call) {
                    return ::ReadFile(port_.get(), part.data(), static_cast<DWORD>(part.size()), nullptr, &call);
                },
                is_there ? host_deadline{now() + milliseconds(50)} : end);
            if (not count) {
                return failed(count.error()).error();
            }
            size += *count;
            if (*count == 0) {
                break;
            }
        }
        return place.first(size);
    }

    /// Whether a byte arrived damaged (parity, framing, break, or one was lost) since this was asked last: among the bytes
    /// read last, or right behind them. Windows does not tell which one.
    [[nodiscard]] bool take_receive_error() noexcept { return std::exchange(has_receive_error_, false); }

    /// Now, on the clock of the deadlines.
    [[nodiscard]] static instant now() noexcept { return steady_now(); }

private:
    result<void> failed(errc error, std::string const& why = {})
    {
        failure_ = device_ + ": " + std::string{name(error)} + (why.empty() ? "" : " (" + why + ")");
        return error;
    }
    result<void> failed(errc error, DWORD system_error) { return failed(error, detail::windows_text(system_error)); }

    /// A timer that is more exact than the system's tick, where there are such (Windows 10 1803).
    static detail::handle exact_timer() noexcept
    {
        constexpr DWORD high_resolution = 2; // CREATE_WAITABLE_TIMER_HIGH_RESOLUTION
        detail::handle exact{::CreateWaitableTimerExW(nullptr, nullptr, high_resolution, TIMER_ALL_ACCESS)};
        return exact.is_open() ? std::move(exact) : detail::handle{::CreateWaitableTimerW(nullptr, FALSE, nullptr)};
    }

    result<void> set_up(HANDLE port, serial_settings const& settings)
    {
        if (not is_bit_rate(settings.bits_per_second)) {
            return failed(errc::device_setting_refused,
                          std::to_string(settings.bits_per_second) + " bit/s are no rate of this system");
        }
        std::string why;
        detail::transceiver_control transceiver;
        auto const no_driver = [](unsigned long, auto&) { return false; };
        if (auto const set = transceiver.set(no_driver, settings.rs485, settings.transceiver, why); not set) {
            return failed(set.error(), why);
        }
        DCB line{};
        line.DCBlength = sizeof line;
        if (::GetCommState(port, &line) == 0) {
            return failed(errc::device_not_serial);
        }
        line.BaudRate = settings.bits_per_second;
        detail::set_format(line, settings.format);
        line.fBinary = 1;
        line.fOutxCtsFlow = line.fOutxDsrFlow = line.fDsrSensitivity = 0;
        line.fOutX = line.fInX = line.fErrorChar = line.fNull = line.fAbortOnError = 0;
        line.fDtrControl = DTR_CONTROL_ENABLE;
        line.fRtsControl = RTS_CONTROL_ENABLE;
        if (::SetCommState(port, &line) == 0) {
            return failed(errc::device_setting_refused,
                          "its driver does not take " + std::to_string(settings.bits_per_second) + " bit/s, " +
                              detail::format_text(line) + ": " + detail::windows_text(::GetLastError()));
        }
        DCB kept{};
        kept.DCBlength = sizeof kept;
        if (::GetCommState(port, &kept) == 0) {
            return failed(errc::device_vanished, ::GetLastError());
        }
        if (not detail::is_near_rate(kept.BaudRate, settings.bits_per_second)) {
            return failed(errc::device_setting_refused, "its driver keeps " + std::to_string(kept.BaudRate) +
                                                            " bit/s, not " + std::to_string(settings.bits_per_second));
        }
        if (detail::format_text(kept) != detail::format_text(line)) {
            return failed(errc::device_setting_refused,
                          "its driver keeps " + detail::format_text(kept) + ", not " + detail::format_text(line));
        }
        COMMTIMEOUTS none{};
        if (::SetCommTimeouts(port, &none) == 0) {
            return failed(errc::device_setting_refused, ::GetLastError());
        }
        ::PurgeComm(port, PURGE_RXABORT | PURGE_RXCLEAR | PURGE_TXABORT | PURGE_TXCLEAR);
        return {};
    }

    /// How many bytes the driver has; notes that some were damaged.
    result<std::size_t> bytes_waiting() noexcept
    {
        DWORD errors = 0;
        COMSTAT status{};
        if (::ClearCommError(port_.get(), &errors, &status) == 0) {
            return detail::use_error(::GetLastError());
        }
        constexpr DWORD damages = CE_RXPARITY | CE_FRAME | CE_BREAK | CE_OVERRUN | CE_RXOVER;
        has_receive_error_ = has_receive_error_ or (errors & damages) != 0;
        return std::size_t{status.cbInQue};
    }

    /// Makes an overlapped call and waits for its end, or ends it at the deadline. How many bytes it passed until then.
    template <typename Call> result<std::size_t> transfer(Call begin, host_deadline const& until) noexcept
    {
        OVERLAPPED call{};
        call.hEvent = ended_.get();
        if (begin(call) == 0) {
            if (DWORD const why = ::GetLastError(); why != ERROR_IO_PENDING) {
                return detail::use_error(why);
            }
        }
        bool const is_ended = wait_for_end(until);
        if (not is_ended) {
            ::CancelIoEx(port_.get(), &call);
        }
        DWORD count = 0;
        // Waits: until then the call writes to what it was given.
        if (::GetOverlappedResult(port_.get(), &call, &count, TRUE) != 0) {
            return std::size_t{count};
        }
        DWORD const why = ::GetLastError();
        bool const is_time_out = why == ERROR_TIMEOUT or (not is_ended and why == ERROR_OPERATION_ABORTED);
        return is_time_out ? result<std::size_t>{std::size_t{count}} : detail::use_error(why);
    }

    /// Whether the call ended before the deadline.
    bool wait_for_end(host_deadline const& until) noexcept
    {
        for (;;) {
            duration const left = until.left();
            if (left == duration{}) {
                return ::WaitForSingleObject(ended_.get(), 0) == WAIT_OBJECT_0;
            }
            LARGE_INTEGER due{};
            due.QuadPart = -10LL * left.microseconds; // from now on, in steps of 100 ns
            ::SetWaitableTimer(timer_.get(), &due, 0, nullptr, nullptr, FALSE);
            std::array<HANDLE, 2> const both{ended_.get(), timer_.get()};
            if (::WaitForMultipleObjects(2, both.data(), FALSE, INFINITE) != WAIT_OBJECT_0 + 1) {
                return true;
            }
        }
    }

    detail::handle port_{};
    detail::handle ended_{}; ///< of the call under way
    detail::handle timer_{};
    bool has_receive_error_{false};
    line_timing timing_{line_timing::host(19'200, character_format::even_8_1)};
    std::string device_{};
    std::string failure_{};
};

/// A serial device of this system, by one name on all.
using host_serial = win32_serial;

} // namespace RTUWIRE_BUILD
} // namespace rtuwire

#endif
