// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// Converts between the library's wrapping microseconds and std::chrono, and has the host's clock.
#pragma once

#include <chrono>
#include <cstdint>
#include <ctime>

#include <rtuwire/core/time.hpp>
#include <rtuwire/core/version.hpp>

namespace rtuwire::inline RTUWIRE_BUILD {

/// A std::chrono duration as ours: whole microseconds, rounded down; below zero it is zero, and one that is
/// too long is refused or becomes the longest, as in `microseconds`.
template <typename Rep, typename Period>
[[nodiscard]] constexpr duration to_duration(std::chrono::duration<Rep, Period> length) noexcept
{
    auto const whole = std::chrono::duration_cast<std::chrono::microseconds>(length).count();
    return microseconds(whole < 0 ? 0 : whole);
}

/// Our duration as std::chrono's.
[[nodiscard]] constexpr std::chrono::microseconds to_chrono(duration length) noexcept
{
    return std::chrono::microseconds{length.microseconds};
}

/// The time that the host has been up, awake or asleep: where the system has a clock of that (Linux), a drive goes on
/// counting while the machine sleeps, and so does this. Elsewhere that of `std::chrono::steady_clock`, which may stand still.
/// It never goes back.
[[nodiscard]] inline std::chrono::nanoseconds host_time() noexcept
{
#ifdef CLOCK_BOOTTIME
    std::timespec now{};
    if (::clock_gettime(CLOCK_BOOTTIME, &now) == 0) {
        return std::chrono::seconds{now.tv_sec} + std::chrono::nanoseconds{now.tv_nsec};
    }
#endif
    return std::chrono::steady_clock::now().time_since_epoch();
}

/// Now, on the clock of `host_time`: the clock of the ports.
[[nodiscard]] inline instant steady_now() noexcept
{
    auto const whole = std::chrono::duration_cast<std::chrono::microseconds>(host_time()).count();
    return instant{static_cast<std::uint32_t>(whole)};
}

} // namespace rtuwire
