// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// What a serial device of a host is opened with, on every system.
#pragma once

#include <cstdint>

#include <rtuwire/core/version.hpp>
#include <rtuwire/port/transceiver.hpp>
#include <rtuwire/rtu/line.hpp>

namespace rtuwire {
inline namespace RTUWIRE_BUILD {

/// What a serial device is opened with.
struct serial_settings {
    std::uint32_t bits_per_second{
        19'200}; ///< any that the driver keeps to 2 %; on POSIX but Linux and macOS one with a code
    character_format format{character_format::even_8_1}; ///< parity and stop bits; always 8 data bits
    rs485_mode rs485{rs485_mode::leave};                 ///< who switches the transceiver
    transceiver_settings transceiver{};                  ///< how the kernel's driver does it, where it does
    /// Lets `read` itself wait by the terminal's timer (VTIME).
    ///
    /// A transaction then takes 3 system calls instead of 4, where the response begins within 100 ms. That timer only
    /// knows steps of 100 ms. So a wait of which less than 120 ms are left is made by `ppoll` as without this option, and
    /// what has not come after 100 ms is waited for that way as well, with 5 calls in all: deadlines stay exact, and a
    /// wait is no longer than without. Two things are different. The device is opened twice. A signal whose handler
    /// restarts system calls (SA_RESTART) begins the 100 ms anew, so that such signals less than 100 ms apart, a timer's
    /// or a profiler's, hold a deadline up for as long as they go on.
    bool waits_in_read{false};
};

namespace detail {

/// Whether a rate is within 2 % of another: two ends of a line then understand each other.
[[nodiscard]] constexpr bool is_near_rate(std::uint32_t is, std::uint32_t asked) noexcept
{
    std::uint64_t const away = is > asked ? is - asked : asked - is;
    return away * 50 <= asked;
}

} // namespace detail

} // namespace RTUWIRE_BUILD
} // namespace rtuwire
