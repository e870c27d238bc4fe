// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// Deterministic pseudo-random numbers: the same seed gives the same sequence. For simulations; not for secrets.
#pragma once

#include <cstdint>

#include <rtuwire/core/version.hpp>

namespace rtuwire {
inline namespace RTUWIRE_BUILD {
namespace detail {

/// A xorshift generator (Marsaglia 2003).
class random_source {
public:
    explicit constexpr random_source(std::uint32_t seed) noexcept
        : state_{0x9E37'79B9'7F4A'7C15U ^ (std::uint64_t{seed} << 17U | seed)}
    {
        for (unsigned warm = 0; warm < 8; ++warm) {
            next();
        }
    }

    constexpr std::uint32_t next() noexcept
    {
        state_ ^= state_ << 13U;
        state_ ^= state_ >> 7U;
        state_ ^= state_ << 17U;
        return static_cast<std::uint32_t>(state_ >> 32U);
    }

    /// 0 to `limit` - 1; 0 for a limit of 0.
    constexpr std::uint32_t below(std::uint32_t limit) noexcept
    {
        return static_cast<std::uint32_t>((std::uint64_t{next()} * limit) >> 32U);
    }

    /// Whether an event of this probability (in a million) occurs; draws a number only where it may.
    constexpr bool happens(std::uint32_t in_a_million) noexcept
    {
        return in_a_million > 0 and below(1'000'000) < in_a_million;
    }

private:
    std::uint64_t state_;
};

} // namespace detail

namespace sim {

using random_source = detail::random_source;

} // namespace sim
} // namespace RTUWIRE_BUILD
} // namespace rtuwire
