// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// Bit rates of a serial device: those that POSIX has a code for, and on Linux any other (termios2, BOTHER). The kernel's own
// header of that, <asm/termbits.h>, cannot stand beside <termios.h>, since both define `struct termios`: its few numbers and
// the one structure are here, and a test compares them with it.
#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include <sys/ioctl.h>
#include <termios.h>

#include <rtuwire/core/version.hpp>

// Others (PowerPC, SPARC, Alpha, PA-RISC) have another structure or none: there only rates with a code.
#if defined(__linux__) && (defined(__x86_64__) || defined(__i386__) || defined(__arm__) || defined(__aarch64__) ||     \
                           defined(__riscv) || defined(__s390__) || defined(__loongarch__) || defined(__mips__))
#define RTUWIRE_TAKES_ANY_RATE 1
#else
#define RTUWIRE_TAKES_ANY_RATE 0
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

/// Whether the system takes rates that have no code.
inline constexpr bool takes_any_rate = RTUWIRE_TAKES_ANY_RATE == 1;

} // namespace detail

#undef RTUWIRE_TAKES_ANY_RATE

/// Whether a device may be opened at a rate; whether its driver keeps it only `open` tells. From 60 bit/s on, as a
/// `line_timing`.
[[nodiscard]] inline bool is_bit_rate(std::uint32_t bits_per_second) noexcept
{
    constexpr std::uint32_t lowest = 60;
    return bits_per_second >= lowest and (detail::takes_any_rate or speed_code(bits_per_second));
}

namespace detail {

/// Whether a rate is within 2 % of another: two ends of a line then understand each other.
[[nodiscard]] constexpr bool is_near_rate(std::uint32_t is, std::uint32_t asked) noexcept
{
    std::uint64_t const away = is > asked ? is - asked : asked - is;
    return away * 50 <= asked;
}

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

/// Asks a driver for a rate that has no code; what came of it `kept_rate` tells.
template <typename Driver> void set_any_rate(Driver const& call, std::uint32_t bits_per_second) noexcept
{
    kernel_line line{};
    if (takes_any_rate and call(get_kernel_line, line)) {
        line.control_flags &= ~(kernel_line::rate_bits | kernel_line::rate_bits << kernel_line::input_shift);
        line.control_flags |= kernel_line::any_rate | kernel_line::any_rate << kernel_line::input_shift;
        line.input_rate = line.output_rate = bits_per_second;
        static_cast<void>(call(set_kernel_line, line));
    }
}

/// The rate of a device whose settings were just read; 0 where they only say that it is another one than was asked.
template <typename Driver>
[[nodiscard]] std::uint32_t kept_rate(Driver const& call, termios const& kept, std::uint32_t asked) noexcept
{
    kernel_line line{};
    if (takes_any_rate and call(get_kernel_line, line)) {
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
        has_rate_ = takes_any_rate and call(get_kernel_line, line_);
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

} // namespace detail

} // namespace RTUWIRE_BUILD
} // namespace rtuwire
