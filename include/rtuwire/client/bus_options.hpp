// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// How a bus treats its units: how much silent ones may cost, and how often each is asked.
#pragma once

#include <cstdint>

#include <rtuwire/client/options.hpp>
#include <rtuwire/core/time.hpp>
#include <rtuwire/core/version.hpp>

namespace rtuwire {
inline namespace RTUWIRE_BUILD {

/// How a bus treats units that do not answer.
struct bus_options {
    /// How much of the line's time all silent units together may cost, in percent, 1 to 100; a value outside counts as
    /// the nearer limit.
    std::uint8_t silent_share{10};
    /// After how many requests without a response a unit counts as silent; a unit that never responded, after one.
    std::uint8_t silent_after{2};
};

/// How a bus treats one unit.
struct slot_options {
    retry_policy with{};
    /// The least time from the outcome of this slot's request to its next one, which sets how often it asks. A unit that
    /// misses what comes too soon has the `pause` of its `retry_policy`, which holds for repetitions, too.
    duration least_idle{};
    /// The longest time from one request to this unit to the next; zero where it does not matter. A silent unit is
    /// sent a request only where its whole time-out ends before any such time of a unit that is not silent, and before
    /// two thirds of the time after which an ordered unit stops by itself. This setting does not speed up the
    /// conversation.
    duration longest_gap{};
};

} // namespace RTUWIRE_BUILD
} // namespace rtuwire
