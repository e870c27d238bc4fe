// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Pauses between two calls, around the edges of what 32 bits of microseconds can tell: half the counter is 35.8 minutes,
// the whole counter 71.6.
#pragma once

#include <array>
#include <cstdint>

namespace rtuwire::test {

inline constexpr std::uint64_t minute = 60'000'000;
inline constexpr std::uint64_t second = 1'000'000;
inline constexpr std::array<std::uint64_t, 10> long_pauses{
    minute,       36 * minute,  50 * minute,  71 * minute,     71 * minute + 20 * second, 71 * minute + 34 * second,
    110 * minute, 142 * minute, 143 * minute, 24 * 60 * minute};

} // namespace rtuwire::test
