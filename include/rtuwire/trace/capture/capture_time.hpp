// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// Times of a capture file in microseconds: an interface says in which steps its times count, and from when.
// Internal: may change with any version.
#pragma once

#include <cstdint>

#include <rtuwire/core/version.hpp>

namespace rtuwire::inline RTUWIRE_BUILD {

/// One interface: what packets of it are, and how its times count.
struct capture_interface {
    std::uint32_t link_type{0};
    std::uint32_t bits_per_second{0};
    std::uint8_t resolution{6}; ///< n: steps of 10^-n s, or of 2^-n s where the highest bit is 1
    std::uint64_t offset{0};    ///< seconds, in two's complement

    /// Whether a second is counted in steps that 64 bits can hold.
    [[nodiscard]] constexpr bool has_good_resolution() const noexcept
    {
        return (resolution & 0x80U) != 0 ? (resolution & 0x7FU) < 64 : resolution < 20;
    }

    /// A time in microseconds; rounded towards zero, and modulo 2^64.
    [[nodiscard]] constexpr std::uint64_t microseconds_of(std::uint64_t steps) const noexcept
    {
        return offset * 1'000'000U + ((resolution & 0x80U) != 0 ? of_binary(steps) : of_decimal(steps));
    }

private:
    [[nodiscard]] constexpr std::uint64_t of_decimal(std::uint64_t steps) const noexcept
    {
        for (unsigned i = resolution; i < 6; ++i) {
            steps *= 10;
        }
        for (unsigned i = 6; i < resolution; ++i) {
            steps /= 10;
        }
        return steps;
    }

    /// Seconds, and of the rest as many bits as leave room for 10^6.
    [[nodiscard]] constexpr std::uint64_t of_binary(std::uint64_t steps) const noexcept
    {
        constexpr unsigned most = 44;
        unsigned const bits = resolution & 0x7FU;
        std::uint64_t const whole = steps >> bits;
        std::uint64_t const rest = steps - (whole << bits);
        unsigned const cut = bits > most ? bits - most : 0U;
        return whole * 1'000'000U + ((rest >> cut) * 1'000'000U >> (bits - cut));
    }
};

} // namespace rtuwire
