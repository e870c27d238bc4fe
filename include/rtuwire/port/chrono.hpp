// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// Between the library's wrapping microseconds and std::chrono.
#pragma once

#include <chrono>
#include <cstdint>

#include <rtuwire/core/time.hpp>

namespace rtuwire {

/// A std::chrono duration as ours: whole microseconds, rounded down; below zero it is zero, and from
/// 71.6 minutes on it wraps.
template <typename Rep, typename Period>
[[nodiscard]] constexpr duration to_duration(std::chrono::duration<Rep, Period> length) noexcept
{
    auto const whole = std::chrono::duration_cast<std::chrono::microseconds>(length).count();
    return microseconds(whole < 0 ? 0U : static_cast<std::uint32_t>(whole));
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
    return {static_cast<std::uint32_t>(whole)};
}

} // namespace rtuwire
