// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// The options of a cycle.
#pragma once

#include <cstdint>

#include <rtuwire/altivar/procedure/inspection/supervision_report.hpp>
#include <rtuwire/core/time.hpp>
#include <rtuwire/core/version.hpp>

namespace rtuwire {
inline namespace RTUWIRE_BUILD {
namespace altivar {

/// The period of a cycle, and what the drive is checked against before the first order.
struct cyclic_options {
    /// The time between exchanges; at most a third of the drive's time-out is used, which is read from it, and where it has
    /// none a third of the longest that can be set.
    duration period{milliseconds(100)};
    /// The longest gap of the line, and the risks that are accepted: see `check_supervision`.
    supervision_options supervision{};
    /// The time limit from an order to "operation enabled".
    duration enable_timeout{milliseconds(3'000)};
    /// How many exchanges in a row may fail before the link counts as lost. None is repeated unchanged: the next one
    /// carries what is ordered then.
    std::uint8_t tolerated_misses{1};
    /// Whether function 23 is used where the device's words fit into it.
    bool by_function_23{true};
};

} // namespace altivar
} // namespace RTUWIRE_BUILD
} // namespace rtuwire
