// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// Lengths of time as people type them: "200ms", "10s", "5min", "8h". A number without a unit counts in seconds.
#pragma once

#include <chrono>
#include <optional>
#include <string>
#include <string_view>

namespace tool {

inline constexpr double longest_time = 366.0 * 86'400.0; ///< seconds, that a command can be told to last

/// The seconds of a text; nothing where it is no length of time, or above `longest_time`.
[[nodiscard]] std::optional<double> seconds_typed(std::string_view text);

/// The same for a length after which a command ends: never zero or below, which could be taken for "without end".
[[nodiscard]] std::optional<double> time_limit_typed(std::string_view text);

/// "2.25 s".
[[nodiscard]] std::string seconds_text(std::chrono::microseconds time);

/// "-1.5 ms": to a tenth.
[[nodiscard]] std::string ms_text(std::chrono::microseconds time);

} // namespace tool
