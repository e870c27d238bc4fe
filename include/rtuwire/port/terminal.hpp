// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// How a POSIX serial device is set up for Modbus: raw bytes, bit rate, character format, and low latency where the kernel
// offers it. Its rates are those that POSIX has a code for, and on Linux (termios2, BOTHER) and macOS (IOSSIOSPEED) any
// other. The kernel's own
// header of that, <asm/termbits.h>, cannot stand beside <termios.h>, since both define `struct termios`: its few numbers and
// the one structure are here, and a test compares them with it. Empty on Windows.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include <rtuwire/core/result.hpp>
#include <rtuwire/core/time.hpp>
#include <rtuwire/core/version.hpp>
#include <rtuwire/port/serial_settings.hpp>
#include <rtuwire/rtu/line.hpp>
#include <rtuwire/wire/errc.hpp>

#ifndef _WIN32

#include <sys/ioctl.h>
#include <termios.h>
#include <unistd.h>

#ifdef __linux__
#include <linux/serial.h>
#include <sys/stat.h>
#endif

// Others (PowerPC, SPARC, Alpha, PA-RISC) have another structure or none: there only rates with a code.
#if defined(__linux__) && (defined(__x86_64__) || defined(__i386__) || defined(__arm__) || defined(__aarch64__) ||     \
                           defined(__riscv) || defined(__s390__) || defined(__loongarch__) || defined(__mips__))
#define RTUWIRE_HAS_KERNEL_LINE 1
#else
#define RTUWIRE_HAS_KERNEL_LINE 0
#endif

namespace rtuwire {
inline namespace RTUWIRE_BUILD {

/// The platform's code of a bit rate, if it has one.
[[nodiscard]] inline std::optional<speed_t> speed_code(std::uint32_t bits_per_second) noexcept
{
    switch (bits_per_second) {
    case 300: return B300;
    case 600: return B600;
    case 1200: return B1200;
    case 1800: return B1800;
    case 2400: return B2400;
    case 4800: return B4800;
    case 9600: return B9600;
    case 19'200: return B19200;
    case 38'400: return B38400;
#ifdef B57600
    case 57'600: return B57600;
#endif
#ifdef B115200
    case 115'200: return B115200;
#endif
#ifdef B230400
    case 230'400: return B230400;
#endif
#ifdef B460800
    case 460'800: return B460800;
#endif
#ifdef B500000
    case 500'000: return B500000;
#endif
#ifdef B576000
    case 576'000: return B576000;
#endif
#ifdef B921600
    case 921'600: return B921600;
#endif
#ifdef B1000000
    case 1'000'000: return B1000000;
#endif
#ifdef B1152000
    case 1'152'000: return B1152000;
#endif
#ifdef B1500000
    case 1'500'000: return B1500000;
#endif
#ifdef B2000000
    case 2'000'000: return B2000000;
#endif
#ifdef B2500000
    case 2'500'000: return B2500000;
#endif
#ifdef B3000000
    case 3'000'000: return B3000000;
#endif
#ifdef B4000000
    case 4'000'000: return B4000000;
#endif
    default: return std::nullopt;
    }
}

namespace detail {

/// Whether the system has the structure below.
inline constexpr bool has_kernel_line = RTUWIRE_HAS_KERNEL_LINE == 1;

/// Whether the system takes rates that have no code.
#ifdef __APPLE__
inline constexpr bool takes_any_rate = true;
#else
inline constexpr bool takes_any_rate = has_kernel_line;
#endif

} // namespace detail

#undef RTUWIRE_HAS_KERNEL_LINE

/// Whether a device may be opened at a rate; whether its driver keeps it only `open` tells. From 65 bit/s on, as a
/// `line_timing`.
[[nodiscard]] inline bool is_bit_rate(std::uint32_t bits_per_second) noexcept
{
    constexpr std::uint32_t lowest = 65;
    return bits_per_second >= lowest and (detail::takes_any_rate or speed_code(bits_per_second));
}

namespace detail {

/// Gets or sets what the driver of an open device has; errno says why where it does not.
struct driver_call {
    int device;
    template <typename Settings> bool operator()(unsigned long request, Settings& settings) const noexcept
    {
        return ::ioctl(device, request, &settings) == 0;
    }
};

/// The settings of a line as Linux has them (`struct termios2`).
struct kernel_line {
#ifdef __mips__
    static constexpr unsigned characters = 23;
#else
    static constexpr unsigned characters = 19;
#endif
    std::uint32_t input_flags;
    std::uint32_t output_flags;
    std::uint32_t control_flags;
    std::uint32_t local_flags;
    std::uint8_t discipline;
    std::array<std::uint8_t, characters> control_characters;
    std::uint32_t input_rate;
    std::uint32_t output_rate;

    static constexpr std::uint32_t rate_bits = 0010017; ///< CBAUD
    static constexpr std::uint32_t any_rate = 0010000;  ///< BOTHER: the rate is the number
    static constexpr unsigned input_shift = 16;         ///< IBSHIFT: where those bits are of the input
};

/// The request that gets it (TCGETS2).
inline constexpr unsigned long get_kernel_line = _IOR('T', 0x2A, kernel_line);

/// The request that sets it (TCSETS2).
inline constexpr unsigned long set_kernel_line = _IOW('T', 0x2B, kernel_line);

/// Asks a driver for a rate that has no code. On macOS, whose settings do not tell of one, the rate that it took; elsewhere 0,
/// and `kept_rate` tells.
template <typename Driver> std::uint32_t set_any_rate(Driver const& call, std::uint32_t bits_per_second) noexcept
{
#ifdef __APPLE__
    constexpr unsigned long set_rate_by_number =
        _IOW('T', 2, speed_t); // IOSSIOSPEED: of a header that only its SDK has
    speed_t rate = bits_per_second;
    return call(set_rate_by_number, rate) ? bits_per_second : 0;
#else
    kernel_line line{};
    if (has_kernel_line and call(get_kernel_line, line)) {
        line.control_flags &= ~(kernel_line::rate_bits | kernel_line::rate_bits << kernel_line::input_shift);
        line.control_flags |= kernel_line::any_rate | kernel_line::any_rate << kernel_line::input_shift;
        line.input_rate = line.output_rate = bits_per_second;
        static_cast<void>(call(set_kernel_line, line));
    }
    return 0;
#endif
}

/// The rate of a device whose settings were just read; 0 where they only say that it is another one than was asked.
template <typename Driver>
[[nodiscard]] std::uint32_t kept_rate(Driver const& call, termios const& kept, std::uint32_t asked) noexcept
{
    kernel_line line{};
    if (has_kernel_line and call(get_kernel_line, line)) {
        return line.output_rate;
    }
    return speed_code(asked) == ::cfgetospeed(&kept) ? asked : 0;
}

/// What a line was set to, its rate included: <termios.h> alone forgets one without a code.
class line_before {
public:
    /// Whether it could be read.
    template <typename Driver> [[nodiscard]] bool read(Driver const& call, int device) noexcept
    {
        has_rate_ = has_kernel_line and call(get_kernel_line, line_);
        return has_rate_ or ::tcgetattr(device, &settings_) == 0;
    }

    template <typename Driver> void put_back(Driver const& call, int device) noexcept
    {
        if (has_rate_) {
            static_cast<void>(call(set_kernel_line, line_));
        } else {
            static_cast<void>(::tcsetattr(device, TCSANOW, &settings_));
        }
    }

private:
    termios settings_{};
    kernel_line line_{};
    bool has_rate_{false};
};

/// How long `read` waits by the terminal's timer: its least step.
inline constexpr duration terminal_timer = milliseconds(100);

/// The control flags of a character format: 8 data bits, parity, stop bits, receiver on, no modem lines.
[[nodiscard]] inline tcflag_t control_flags(character_format format) noexcept
{
    tcflag_t const common = CS8 | CREAD | CLOCAL;
    switch (format) {
    case character_format::even_8_1: return common | PARENB;
    case character_format::odd_8_1: return common | PARENB | PARODD;
    case character_format::none_8_1: return common;
    case character_format::none_8_2: return common | CSTOPB;
    case character_format::even_8_2: return common | PARENB | CSTOPB;
    case character_format::odd_8_2: return common | PARENB | PARODD | CSTOPB;
    }
    return common;
}

/// A format as people write it: data bits, parity, stop bits.
[[nodiscard]] inline std::string format_text(tcflag_t flags)
{
    tcflag_t const size = flags & CSIZE;
    std::string text{size == CS8 ? "8" : size == CS7 ? "7" : size == CS6 ? "6" : "5"};
    text += (flags & PARENB) == 0 ? 'N' : (flags & PARODD) == 0 ? 'E' : 'O';
    return text + ((flags & CSTOPB) == 0 ? '1' : '2');
}

/// The driver's part of a device number, as Linux encodes it. <sys/sysmacros.h> has a function for it, but
/// defines macros called `major` and `minor`.
[[nodiscard]] constexpr unsigned device_major(std::uint64_t number) noexcept
{
    return static_cast<unsigned>(number >> 8U & 0xFFFU) | static_cast<unsigned>(number >> 32U & 0xFFFF'F000U);
}

/// The device's part of it.
[[nodiscard]] constexpr unsigned device_minor(std::uint64_t number) noexcept
{
    return static_cast<unsigned>(number & 0xFFU) | static_cast<unsigned>(number >> 12U & 0xFFFF'FF00U);
}

/// Whether a device is a pseudo-terminal, which has no wire and so no parity.
[[nodiscard]] inline bool is_pseudo_terminal([[maybe_unused]] int device) noexcept
{
#ifdef __linux__
    constexpr unsigned first_unix98_major = 136;
    constexpr unsigned last_unix98_major = 143;
    struct stat info {};
    if (::fstat(device, &info) != 0) {
        return false;
    }
    unsigned const number = device_major(info.st_rdev);
    return number >= first_unix98_major and number <= last_unix98_major;
#else
    return false;
#endif
}

/// Whether a place among the devices of sysfs is behind a USB bus: one of its folders is a bus's, `usb1` and the like.
[[nodiscard]] constexpr bool is_behind_usb(std::string_view place) noexcept
{
    constexpr std::string_view bus = "/usb";
    for (std::size_t at = place.find(bus); at != std::string_view::npos; at = place.find(bus, at + 1)) {
        std::string_view const number = place.substr(at + bus.size());
        std::size_t const digits = number.find_first_not_of("0123456789");
        if (digits != 0 and digits != std::string_view::npos and number[digits] == '/') {
            return true;
        }
    }
    return false;
}

/// Whether an open device is behind a USB bus, as the kernel's driver says in sysfs (Linux); false on other systems, and
/// where that is not mounted. What a name says, `/dev/ttyUSB0`, does not count: udev or a user may have given another.
/// `devices` is the folder of the links to the places of all character devices.
[[nodiscard]] inline bool is_usb_device([[maybe_unused]] int device,
                                        [[maybe_unused]] std::string const& devices = "/sys/dev/char")
{
#ifdef __linux__
    struct stat info {};
    if (::fstat(device, &info) != 0) {
        return false;
    }
    std::string const link =
        devices + "/" + std::to_string(device_major(info.st_rdev)) + ":" + std::to_string(device_minor(info.st_rdev));
    char place[4096]; // PATH_MAX; a longer place is cut, behind its buses
    ssize_t const size = ::readlink(link.c_str(), place, sizeof place);
    return size > 0 and is_behind_usb({place, static_cast<std::size_t>(size)});
#else
    return false;
#endif
}

/// Input flags that let a device mark the bytes that arrived damaged; `error_marks` reads the marks.
inline constexpr tcflag_t marks_errors = INPCK | PARMRK;

/// Sets up an open device; bytes pass unchanged, except as the input flags say. Errors: `device_not_serial`,
/// `device_setting_refused` when the device does not keep the bit rate to 2 %, the character format or the input flags;
/// `why` then says what it kept.
[[nodiscard]] inline result<void> apply_line(int device, serial_settings const& settings, std::string& why,
                                             tcflag_t input_flags = 0)
{
    std::uint32_t const rate = settings.bits_per_second;
    if (not is_bit_rate(rate)) {
        why = std::to_string(rate) + " bit/s are no rate of this system";
        return errc::device_setting_refused;
    }
    termios line{};
    if (::tcgetattr(device, &line) != 0) {
        return errc::device_not_serial;
    }
    line.c_iflag = input_flags;
    line.c_oflag = 0;
    line.c_lflag = 0;
    line.c_cflag = control_flags(settings.format);
    line.c_cc[VMIN] = 0;
    line.c_cc[VTIME] = settings.waits_in_read ? terminal_timer.microseconds / 100'000U : 0;
    auto const code = speed_code(rate);
    ::cfsetispeed(&line, code.value_or(B19200));
    ::cfsetospeed(&line, code.value_or(B19200));
    // The return value says little: the call succeeds when anything at all could be set, and fails where a
    // pseudo-terminal drops the parity flag. The settings that the device kept tell.
    static_cast<void>(::tcsetattr(device, TCSANOW, &line));
    std::uint32_t told = 0;
    if (not code) {
        told = set_any_rate(driver_call{device}, rate);
    }
    termios kept{};
    if (::tcgetattr(device, &kept) != 0) {
        return errc::device_not_serial;
    }
    tcflag_t const compared =
        is_pseudo_terminal(device) ? tcflag_t{CSIZE | CSTOPB} : tcflag_t{CSIZE | CSTOPB | PARENB | PARODD};
    if (std::uint32_t const has = told != 0 ? told : kept_rate(driver_call{device}, kept, rate);
        not is_near_rate(has, rate)) {
        why = "its driver keeps " + (has == 0 ? "another rate" : std::to_string(has) + " bit/s") + ", not " +
              std::to_string(rate);
    } else if ((kept.c_cflag & compared) != (line.c_cflag & compared)) {
        why = "its driver keeps " + format_text(kept.c_cflag) + ", not " + format_text(line.c_cflag);
    } else if (kept.c_iflag != line.c_iflag) {
        why = "its driver does not mark damaged bytes";
    }
    return why.empty() ? result<void>{} : errc::device_setting_refused;
}

/// Asks a driver to pass bytes on at once, by a call that gets or sets its flags. Whether it does, as it says itself:
/// some accept the request and ignore it.
template <typename Driver> bool set_low_latency([[maybe_unused]] Driver&& call) noexcept
{
#if defined(TIOCGSERIAL) && defined(ASYNC_LOW_LATENCY)
    constexpr auto wanted = static_cast<int>(ASYNC_LOW_LATENCY);
    serial_struct driver{};
    if (not call(TIOCGSERIAL, driver)) {
        return false;
    }
    driver.flags |= wanted;
    return call(TIOCSSERIAL, driver) and call(TIOCGSERIAL, driver) and (driver.flags & wanted) != 0;
#else
    return false;
#endif
}

/// The same of an open device.
[[nodiscard]] inline bool request_low_latency(int device) noexcept { return set_low_latency(driver_call{device}); }

} // namespace detail

} // namespace RTUWIRE_BUILD
} // namespace rtuwire

#endif
