// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// Time as the caller supplies it: wrapping 32-bit microseconds. Nothing in the portable headers reads
// a clock. The count wraps after 71.6 minutes, so instants have no order of their own: only "has this
// deadline been reached", right for deadlines up to 35 minutes away on either side.
#pragma once

#include <compare>
#include <cstdint>
#include <optional>

namespace rtuwire {

/// A span of time in whole microseconds, up to 35 minutes where it is used as a deadline.
struct duration {
    std::uint32_t microseconds{0};

    friend constexpr bool operator==(duration, duration) noexcept = default;
    friend constexpr auto operator<=>(duration left, duration right) noexcept
    {
        return left.microseconds <=> right.microseconds;
    }
    friend constexpr duration operator+(duration left, duration right) noexcept
    {
        return {left.microseconds + right.microseconds};
    }
    friend constexpr duration operator*(duration left, std::uint32_t times) noexcept
    {
        return {left.microseconds * times};
    }
};

[[nodiscard]] constexpr duration microseconds(std::uint32_t count) noexcept { return {count}; }

[[nodiscard]] constexpr duration milliseconds(std::uint32_t count) noexcept
{
    return {count * 1000U};
}

/// A point in time: the value of a free-running microsecond counter.
struct instant {
    std::uint32_t microseconds{0};

    friend constexpr bool operator==(instant, instant) noexcept = default;
    friend constexpr instant operator+(instant start, duration length) noexcept
    {
        return {start.microseconds + length.microseconds};
    }
    friend constexpr instant operator-(instant end, duration length) noexcept
    {
        return {end.microseconds - length.microseconds};
    }

    /// The time from `start` to `end`, across a wrap of the counter.
    friend constexpr duration operator-(instant end, instant start) noexcept
    {
        return {end.microseconds - start.microseconds};
    }
};

/// Whether `deadline` is now or lies in the past, seen from `now`.
[[nodiscard]] constexpr bool reached(instant now, instant deadline) noexcept
{
    return (now.microseconds - deadline.microseconds) < 0x8000'0000U;
}

/// When something has to happen next, or never.
using deadline = std::optional<instant>;

/// The one of two deadlines that comes first.
[[nodiscard]] constexpr deadline earlier(deadline left, deadline right) noexcept
{
    if (not left) {
        return right;
    }
    if (not right) {
        return left;
    }
    return reached(*right, *left) ? left : right;
}

} // namespace rtuwire
