// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// A drive's time-out against the longest time that a line may leave it without a request.
#pragma once

#include <cstdint>

#include <rtuwire/core/time.hpp>
#include <rtuwire/core/version.hpp>

namespace rtuwire {
inline namespace RTUWIRE_BUILD {
namespace altivar {

/// How many longest gaps a drive's time-out has to cover: one lost exchange and its repetition still fit.
/// Internal.
inline constexpr std::uint32_t gaps_in_a_timeout = 3;

/// A drive's time-out, and the longest gap between two requests to it that its line can cause.
/// Internal.
struct period_rule {
    duration timeout{}; ///< 0: it has none, or none is known
    duration longest_gap{};

    /// Whether the requests are frequent enough: the time-out is at least three times the gap. This is also true for a
    /// drive without a time-out, which does not make that drive safe.
    [[nodiscard]] constexpr bool holds() const noexcept
    {
        // Three times the gap may be too long for a duration.
        std::uint32_t const all = timeout.microseconds, gap = longest_gap.microseconds;
        return all == 0 or (gap <= all and gap <= (all - gap) / 2U);
    }

    /// The shortest time-out that this line allows.
    [[nodiscard]] constexpr duration shortest_timeout() const noexcept { return longest_gap * gaps_in_a_timeout; }

    /// The longest period at which requests may go to a drive with this time-out; 0 where it has none.
    [[nodiscard]] constexpr duration longest_period() const noexcept
    {
        return duration{timeout.microseconds / gaps_in_a_timeout};
    }

    friend constexpr bool operator==(period_rule const&, period_rule const&) noexcept = default;
};

/// The longest gap of a line where `count` conversations take turns and one unit does not answer. `exchange` is the
/// length of one exchange, request, response and silences included; `silent_unit` is what the unit costs, the response
/// time-out with all repetitions.
[[nodiscard]] constexpr duration longest_gap_of(std::uint32_t count, duration exchange, duration silent_unit) noexcept
{
    return exchange * count + silent_unit;
}

} // namespace altivar
} // namespace RTUWIRE_BUILD
} // namespace rtuwire
