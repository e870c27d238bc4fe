// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Notices that a program did not run for a while: it was stopped, or the machine slept.
#pragma once

#include <chrono>
#include <ctime>

namespace tool {

/// Counts the time in which the machine sleeps, too, where the system has such a clock.
inline std::chrono::nanoseconds time_awake_or_asleep() noexcept
{
#ifdef CLOCK_BOOTTIME
    constexpr clockid_t clock = CLOCK_BOOTTIME;
#else
    constexpr clockid_t clock = CLOCK_MONOTONIC;
#endif
    timespec now{};
    ::clock_gettime(clock, &now);
    return std::chrono::seconds{now.tv_sec} + std::chrono::nanoseconds{now.tv_nsec};
}

class missed_time {
public:
    /// More than `limit` between two looks is too long; `now` is the first look.
    explicit missed_time(std::chrono::nanoseconds limit, std::chrono::nanoseconds now = time_awake_or_asleep()) noexcept
        : limit_{limit}, last_{now}
    {}

    /// To be asked in each pass: whether the last look is too long ago, or the clock went back.
    bool is_too_long(std::chrono::nanoseconds now = time_awake_or_asleep()) noexcept
    {
        std::chrono::nanoseconds const passed = now - last_;
        last_ = now;
        return passed > limit_ or passed < std::chrono::nanoseconds{0};
    }

private:
    std::chrono::nanoseconds limit_;
    std::chrono::nanoseconds last_;
};

} // namespace tool
