// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// A register of named bits.
#pragma once

#include <cstdint>
#include <type_traits>

#include <rtuwire/core/version.hpp>

namespace rtuwire {
inline namespace RTUWIRE_BUILD {

/// One word whose bits are named by an enumeration of bit numbers 0..15.
template <typename Bit>
    requires std::is_enum_v<Bit>
struct flags {
    using bit_type = Bit;
    using is_bit_field = void;

    std::uint16_t bits{0};

    /// Whether a bit is 1.
    [[nodiscard]] constexpr bool has(Bit bit) const noexcept
    {
        return ((bits >> static_cast<unsigned>(bit)) & 1U) != 0;
    }

    /// The same word with a bit set.
    [[nodiscard]] constexpr flags with(Bit bit) const noexcept
    {
        return {static_cast<std::uint16_t>(bits | (1U << static_cast<unsigned>(bit)))};
    }

    /// The same word with a bit cleared.
    [[nodiscard]] constexpr flags without(Bit bit) const noexcept
    {
        return {static_cast<std::uint16_t>(bits & ~(1U << static_cast<unsigned>(bit)))};
    }

    friend constexpr bool operator==(flags, flags) noexcept = default;
};

namespace detail {

/// Bits that none of the available manuals explains.
enum class unnamed_bit : std::uint8_t {};

} // namespace detail

} // namespace RTUWIRE_BUILD
} // namespace rtuwire
