// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// CRC-16/MODBUS from tables: the effect of shifting out 4 or 8 bits at some distance from the end.
#pragma once

#include <cstddef>
#include <cstdint>

#include <rtuwire/core/bytes.hpp>
#include <rtuwire/core/version.hpp>

namespace rtuwire {
inline namespace RTUWIRE_BUILD {
namespace crc16_tables {

/// The polynomial, reflected, without its highest power.
inline constexpr std::uint32_t polynomial = 0xA001;

/// A state after `bits` zero bits.
[[nodiscard]] constexpr std::uint16_t shifted(std::uint32_t state, unsigned bits) noexcept
{
    for (unsigned i = 0; i < bits; ++i) {
        state = (state >> 1U) ^ ((state & 1U) != 0 ? polynomial : 0U);
    }
    return static_cast<std::uint16_t>(state);
}

inline constexpr std::uint16_t nibble[16] = {shifted(0, 4),  shifted(1, 4),  shifted(2, 4),  shifted(3, 4),
                                             shifted(4, 4),  shifted(5, 4),  shifted(6, 4),  shifted(7, 4),
                                             shifted(8, 4),  shifted(9, 4),  shifted(10, 4), shifted(11, 4),
                                             shifted(12, 4), shifted(13, 4), shifted(14, 4), shifted(15, 4)};

/// What a byte with `k` bytes behind it adds to the CRC; 512 bytes for each distance. Plain arrays, and the
/// sum of two entries where that is possible: the compiler computes them for each file that uses them.
template <std::size_t Count> struct distances {
    std::uint16_t at[Count][256]{};

    constexpr distances() noexcept
    {
        for (unsigned bit = 1; bit < 256; bit *= 2) {
            at[0][bit] = shifted(bit, 8);
        }
        add_up(at[0]);
        for (std::size_t k = 1; k < Count; ++k) {
            for (unsigned bit = 1; bit < 256; bit *= 2) {
                std::uint16_t const nearer = at[k - 1][bit];
                at[k][bit] = static_cast<std::uint16_t>((nearer >> 8U) ^ at[0][nearer & 0xFFU]);
            }
            add_up(at[k]);
        }
    }

private:
    /// Computes all entries from those of single bits.
    static constexpr void add_up(std::uint16_t (&table)[256]) noexcept
    {
        for (unsigned bit = 2; bit < 256; bit *= 2) {
            for (unsigned i = 1; i < bit; ++i) {
                table[bit + i] = static_cast<std::uint16_t>(table[bit] ^ table[i]);
            }
        }
    }
};

template <std::size_t Count> inline constexpr distances<Count> at_distance{};

/// The table of a single byte.
[[nodiscard]] constexpr std::uint16_t of_byte(std::uint32_t byte) noexcept
{
    return at_distance<1>.at[0][byte & 0xFFU];
}

/// The tables for eight bytes at a time.
inline constexpr auto const& eight = at_distance<8>.at;

/// The CRC of eight bytes, the first in the lowest bits, when it starts from 0.
[[nodiscard]] constexpr std::uint16_t of_word(std::uint64_t bytes) noexcept
{
    return static_cast<std::uint16_t>(eight[7][bytes & 0xFFU] ^ eight[6][bytes >> 8U & 0xFFU] ^
                                      eight[5][bytes >> 16U & 0xFFU] ^ eight[4][bytes >> 24U & 0xFFU] ^
                                      eight[3][bytes >> 32U & 0xFFU] ^ eight[2][bytes >> 40U & 0xFFU] ^
                                      eight[1][bytes >> 48U & 0xFFU] ^ eight[0][bytes >> 56U]);
}

/// What the start value FFFF adds to the CRC, by the number of bytes, 8 at most.
inline constexpr std::uint16_t started[] = {shifted(0xFFFF, 0),  shifted(0xFFFF, 8),  shifted(0xFFFF, 16),
                                            shifted(0xFFFF, 24), shifted(0xFFFF, 32), shifted(0xFFFF, 40),
                                            shifted(0xFFFF, 48), shifted(0xFFFF, 56), shifted(0xFFFF, 64)};

/// The CRC of up to 8 bytes: look-ups that do not wait for each other. Loaded byte by byte, because a frame
/// that was just written byte by byte cannot be loaded in words without waiting.
[[nodiscard]] constexpr std::uint16_t of_few(std::byte const* at, std::size_t size) noexcept
{
    std::byte const* const end = at + size;
    auto const add = [&](std::uint16_t crc, std::ptrdiff_t k) {
        return static_cast<std::uint16_t>(crc ^ eight[k - 1][detail::to_u8(end[-k])]);
    };
    std::uint16_t crc = started[size];
    switch (size) {
    case 8: crc = add(crc, 8); [[fallthrough]];
    case 7: crc = add(crc, 7); [[fallthrough]];
    case 6: crc = add(crc, 6); [[fallthrough]];
    case 5: crc = add(crc, 5); [[fallthrough]];
    case 4: crc = add(crc, 4); [[fallthrough]];
    case 3: crc = add(crc, 3); [[fallthrough]];
    case 2: crc = add(crc, 2); [[fallthrough]];
    case 1: crc = add(crc, 1); [[fallthrough]];
    default: return crc;
    }
}

/// The CRC after eight more bytes.
[[nodiscard]] constexpr std::uint16_t after_eight(std::uint32_t crc, std::byte const* at) noexcept
{
    return static_cast<std::uint16_t>(
        eight[7][detail::to_u8(at[0]) ^ (crc & 0xFFU)] ^ eight[6][detail::to_u8(at[1]) ^ (crc >> 8U)] ^
        eight[5][detail::to_u8(at[2])] ^ eight[4][detail::to_u8(at[3])] ^ eight[3][detail::to_u8(at[4])] ^
        eight[2][detail::to_u8(at[5])] ^ eight[1][detail::to_u8(at[6])] ^ eight[0][detail::to_u8(at[7])]);
}

/// The CRC of more than 8 bytes: up to 8 at the front, then eight at a time.
[[nodiscard]] constexpr std::uint16_t of_some(byte_view bytes) noexcept
{
    std::byte const* at = bytes.data();
    std::byte const* const end = at + bytes.size();
    std::size_t const odd = (bytes.size() - 1) % 8 + 1;
    std::uint16_t crc = of_few(at, odd);
    at += odd;
    do {
        crc = after_eight(crc, at);
        at += 8;
    } while (at != end);
    return crc;
}

} // namespace crc16_tables
} // namespace RTUWIRE_BUILD
} // namespace rtuwire
