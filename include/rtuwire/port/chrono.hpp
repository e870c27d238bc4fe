// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// Converts between the library's wrapping microseconds and std::chrono, and has the host's clock, which counts 64 bits:
// a program, or the whole machine, may be stopped between any two looks at it, for longer than half of 32 bits.
#pragma once

#include <chrono>
#include <cstdint>
#include <ctime>

#include <rtuwire/core/time.hpp>
#include <rtuwire/core/version.hpp>

namespace rtuwire {
inline namespace RTUWIRE_BUILD {

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

namespace detail {

/// A thread's looks at the clock of the ports, in whole microseconds.
class clock_looks {
public:
    /// Looks now.
    static std::int64_t look() noexcept
    {
        return last() = std::chrono::duration_cast<std::chrono::microseconds>(host_time()).count();
    }
    /// The last look of this thread, or one now where it never looked.
    static std::int64_t latest() noexcept { return last() < 0 ? look() : last(); }

private:
    static std::int64_t& last() noexcept
    {
        static thread_local constinit std::int64_t at = -1;
        return at;
    }
};

} // namespace detail

/// Now, on the clock of `host_time`: the clock of the ports.
[[nodiscard]] inline instant steady_now() noexcept
{
    return instant{static_cast<std::uint32_t>(detail::clock_looks::look())};
}

/// A deadline on the clock of `steady_now`, for a port that waits: make one where its call begins, and ask that before each
/// wait, also after one that a signal broke off. An instant alone looks as if it lay ahead once it has been over for 35.8
/// minutes. This counts 64 bits, from the last look that its thread had at the clock, which is that of whoever named the
/// deadline: so no wait is longer than it was when it was asked for, however long the program was stopped since. One that another
/// thread has named may be taken for over where this thread has not looked for 35 minutes.
class host_deadline {
public:
    /// Implicit: whoever waits takes it, and is given an instant.
    host_deadline(instant until) noexcept : at_{nearest(until, detail::clock_looks::latest())} {}

    /// The time left now; zero when it has passed.
    [[nodiscard]] duration left() const noexcept
    {
        std::int64_t const now = detail::clock_looks::look();
        return now < at_ ? duration{static_cast<std::uint32_t>(at_ - now)} : duration{};
    }

private:
    /// The time that looks like this instant and is nearest to when a clock was seen.
    static constexpr std::int64_t nearest(instant at, std::int64_t seen) noexcept
    {
        return seen + static_cast<std::int32_t>(at.microseconds - static_cast<std::uint32_t>(seen));
    }

    std::int64_t at_; ///< in microseconds
};

} // namespace RTUWIRE_BUILD
} // namespace rtuwire
