// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// The time by the calendar, for people and programs.
#pragma once

#include <cstdint>
#include <string>

namespace tool {

/// Microseconds since 1970, now.
std::uint64_t unix_now();

/// "2026-11-24T08:15:03+0100": local time, to the second.
std::string second_text(std::uint64_t unix_microseconds);

/// "2026-11-24T08:15:03.250+0100": local time, to the millisecond.
std::string time_text(std::uint64_t unix_microseconds);

/// "2026-11-24T08:15:03.250417+0100": to the microsecond, of a frame.
std::string exact_time_text(std::uint64_t unix_microseconds);

} // namespace tool
