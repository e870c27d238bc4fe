// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Repeatable pseudo-random numbers, also when compiling.
#pragma once

#include <cstddef>
#include <cstdint>

#include <rtuwire/core/bytes.hpp>

namespace rtuwire::test {

/// A xorshift generator; the seed names the run.
class random {
public:
    explicit constexpr random(std::uint32_t seed) noexcept : state_{seed | 1U} {}

    constexpr std::uint32_t next() noexcept
    {
        state_ ^= state_ << 13U;
        state_ ^= state_ >> 17U;
        state_ ^= state_ << 5U;
        return state_;
    }

    /// A number below `limit`, which is above 0.
    constexpr std::uint32_t below(std::uint32_t limit) noexcept { return (next() >> 3U) % limit; }

    constexpr void fill(byte_span out) noexcept
    {
        for (std::byte& octet : out) {
            octet = to_byte(next() >> 11U);
        }
    }

private:
    std::uint32_t state_;
};

} // namespace rtuwire::test
