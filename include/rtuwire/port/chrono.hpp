// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// Converts between the library's wrapping microseconds and std::chrono.
#pragma once

#include <chrono>
#include <cstdint>

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

/// Now, on the host's steady clock.
[[nodiscard]] inline instant steady_now() noexcept
{
    auto const since_start = std::chrono::steady_clock::now().time_since_epoch();
    auto const whole = std::chrono::duration_cast<std::chrono::microseconds>(since_start).count();
    return instant{static_cast<std::uint32_t>(whole)};
}

} // namespace rtuwire
