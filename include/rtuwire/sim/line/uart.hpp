// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// One character on a wire: start bit, data, parity, stop. Bit 0 of a pattern comes first; idle is 1.
// Internal: may change with any version.
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <optional>

#include <rtuwire/core/bytes.hpp>
#include <rtuwire/core/version.hpp>
#include <rtuwire/rtu/line.hpp>

namespace rtuwire::inline RTUWIRE_BUILD::sim {

/// A character as a receiver decodes it.
struct received_byte {
    std::byte byte;
    bool is_damaged; ///< parity or framing error
};

/// The parity bit of a byte, 0 or 1; nothing where the format has none.
[[nodiscard]] constexpr std::optional<std::uint32_t> parity_of(character_format format, std::uint8_t byte) noexcept
{
    std::uint32_t const even = static_cast<std::uint32_t>(std::popcount(byte)) & 1U;
    switch (format) {
    case character_format::even_8_1: return even;
    case character_format::odd_8_1: return even ^ 1U;
    case character_format::none_8_1:
    case character_format::none_8_2: break;
    }
    return std::nullopt;
}

/// The bits of a byte, `bits_per_character` of them.
[[nodiscard]] constexpr std::uint32_t character_bits(character_format format, std::byte byte) noexcept
{
    constexpr std::uint32_t stop_bits = 0b11;
    std::uint32_t const data = to_u8(byte);
    std::uint32_t const parity = parity_of(format, to_u8(byte)).value_or(1); // without parity the stop bit is there
    return data << 1U | parity << 9U | stop_bits << 10U;
}

/// Decodes the bits that begin with a start bit, as a receiver does.
[[nodiscard]] constexpr received_byte receive_character(character_format format, std::uint32_t bits) noexcept
{
    auto const byte = static_cast<std::uint8_t>(bits >> 1U);
    auto const parity = parity_of(format, byte);
    bool const is_parity_right = not parity or *parity == ((bits >> 9U) & 1U);
    std::uint32_t const stop_at = parity ? 10 : 9;
    bool const has_stop = ((bits >> stop_at) & 1U) != 0;
    return {to_byte(byte), not is_parity_right or not has_stop};
}

} // namespace rtuwire::sim
