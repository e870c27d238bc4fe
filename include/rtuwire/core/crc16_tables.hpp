// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// CRC-16/MODBUS from tables: what follows when 4 or 8 bits at some distance from the end are shifted out.
#pragma once

#include <cstddef>
#include <cstdint>
#include <utility>

#include <rtuwire/core/bytes.hpp>
#include <rtuwire/core/version.hpp>

namespace rtuwire::inline RTUWIRE_BUILD::crc16_tables {

/// The polynomial, reflected, without its highest power.
inline constexpr std::uint32_t polynomial = 0xA001;

/// A state after zero bits.
[[nodiscard]] constexpr std::uint16_t shifted(std::uint32_t state, unsigned bits) noexcept
{
    for (unsigned i = 0; i < bits; ++i) {
        state = (state >> 1U) ^ ((state & 1U) != 0 ? polynomial : 0U);
    }
    return static_cast<std::uint16_t>(state);
}

inline constexpr std::uint16_t nibble[16] = {
    shifted(0, 4),  shifted(1, 4),  shifted(2, 4),  shifted(3, 4), shifted(4, 4),  shifted(5, 4),
    shifted(6, 4),  shifted(7, 4),  shifted(8, 4),  shifted(9, 4), shifted(10, 4), shifted(11, 4),
    shifted(12, 4), shifted(13, 4), shifted(14, 4), shifted(15, 4)};

/// What an octet with `k` octets behind it adds to the CRC; 512 octets for each distance. Plain arrays,
/// and the sum of two entries where that is possible: every file that uses them has them made anew.
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
    /// From the entries of single bits, all.
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

/// The table of a single octet.
[[nodiscard]] constexpr std::uint16_t byte(std::uint32_t octet) noexcept
{
    return at_distance<1>.at[0][octet & 0xFFU];
}

/// The tables for eight octets at a time.
inline constexpr auto const& eight = at_distance<8>.at;

/// What eight octets, the first in the lowest bits, leave of a CRC that starts from 0.
[[nodiscard]] constexpr std::uint16_t of_word(std::uint64_t octets) noexcept
{
    return static_cast<std::uint16_t>(
        eight[7][octets & 0xFFU] ^ eight[6][octets >> 8U & 0xFFU] ^
        eight[5][octets >> 16U & 0xFFU] ^ eight[4][octets >> 24U & 0xFFU] ^
        eight[3][octets >> 32U & 0xFFU] ^ eight[2][octets >> 40U & 0xFFU] ^
        eight[1][octets >> 48U & 0xFFU] ^ eight[0][octets >> 56U]);
}

/// What the start value FFFF adds to the CRC of so many octets, 8 at most.
inline constexpr std::uint16_t started[] = {
    shifted(0xFFFF, 0),  shifted(0xFFFF, 8),  shifted(0xFFFF, 16),
    shifted(0xFFFF, 24), shifted(0xFFFF, 32), shifted(0xFFFF, 40),
    shifted(0xFFFF, 48), shifted(0xFFFF, 56), shifted(0xFFFF, 64)};

/// The CRC of up to 8 octets: look-ups that do not wait for each other. Octet by octet, because a frame
/// that was just written so cannot be loaded in words without waiting.
[[nodiscard]] constexpr std::uint16_t of_few(std::byte const* at, std::size_t size) noexcept
{
    std::byte const* const end = at + size;
    auto const add = [&](std::uint16_t crc, std::ptrdiff_t k) {
        return static_cast<std::uint16_t>(crc ^ eight[k - 1][to_u8(end[-k])]);
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

/// The CRC after `Count` more octets.
template <std::size_t Count, std::size_t... I>
[[nodiscard]] constexpr std::uint16_t after(std::uint32_t crc, std::byte const* at,
                                            std::index_sequence<0, 1, I...>) noexcept
{
    auto const& tables = at_distance<Count>.at;
    return static_cast<std::uint16_t>(tables[Count - 1][to_u8(at[0]) ^ (crc & 0xFFU)] ^
                                      tables[Count - 2][to_u8(at[1]) ^ (crc >> 8U)] ^
                                      (tables[Count - 1 - I][to_u8(at[I])] ^ ...));
}
template <std::size_t Count>
[[nodiscard]] constexpr std::uint16_t after(std::uint32_t crc, std::byte const* at) noexcept
{
    return after<Count>(crc, at, std::make_index_sequence<Count>{});
}

/// The CRC of more than 8 octets: up to 8 at the front, then eight at a time.
[[nodiscard]] constexpr std::uint16_t of_some(byte_view octets) noexcept
{
    std::byte const* at = octets.data();
    std::byte const* const end = at + octets.size();
    std::size_t const odd = (octets.size() - 1) % 8 + 1;
    std::uint16_t crc = of_few(at, odd);
    at += odd;
    do {
        crc = after<8>(crc, at);
        at += 8;
    } while (at != end);
    return crc;
}

/// The CRC by slices of `Count` octets.
template <std::size_t Count> [[nodiscard]] constexpr std::uint16_t sliced(byte_view octets) noexcept
{
    std::uint32_t crc = 0xFFFF;
    for (; octets.size() >= Count; octets = octets.subspan(Count)) {
        crc = after<Count>(crc, octets.data());
    }
    for (std::byte const octet : octets) {
        crc = (crc >> 8U) ^ byte(crc ^ to_u8(octet));
    }
    return static_cast<std::uint16_t>(crc);
}

} // namespace rtuwire::crc16_tables
