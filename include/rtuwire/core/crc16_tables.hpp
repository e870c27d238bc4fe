// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// CRC-16/MODBUS from tables: what follows when 4 or 8 bits at some distance from the end are shifted out.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include <rtuwire/core/bytes.hpp>

namespace rtuwire::crc16_tables {

/// A state after zero bits: reflected polynomial A001.
[[nodiscard]] constexpr std::uint16_t shifted(std::uint32_t state, unsigned bits) noexcept
{
    for (unsigned i = 0; i < bits; ++i) {
        state = (state >> 1U) ^ ((state & 1U) != 0 ? 0xA001U : 0U);
    }
    return static_cast<std::uint16_t>(state);
}

template <std::size_t Entries, unsigned Bits>
[[nodiscard]] constexpr std::array<std::uint16_t, Entries> make() noexcept
{
    std::array<std::uint16_t, Entries> table{};
    for (std::size_t i = 0; i < Entries; ++i) {
        table[i] = shifted(static_cast<std::uint32_t>(i), Bits);
    }
    return table;
}

inline constexpr auto nibble = make<16, 4>();
inline constexpr auto byte = make<256, 8>();

using octet_table = std::array<std::uint16_t, 256>;

template <std::size_t Count>
[[nodiscard]] constexpr std::array<octet_table, Count> make_distances() noexcept
{
    std::array<octet_table, Count> tables{};
    tables[0] = byte;
    for (std::size_t k = 1; k < Count; ++k) {
        for (std::size_t i = 0; i < byte.size(); ++i) {
            std::uint32_t const nearer = tables[k - 1][i];
            tables[k][i] = static_cast<std::uint16_t>((nearer >> 8U) ^ byte[nearer & 0xFFU]);
        }
    }
    return tables;
}

/// `at_distance<N>[k][octet]`: what an octet with `k` octets behind it adds to the CRC; N of 512 octets.
template <std::size_t Count> inline constexpr auto at_distance = make_distances<Count>();

/// The CRC of at least 2 and at most `Count` octets: look-ups that do not wait for each other.
template <std::size_t Count> [[nodiscard]] constexpr std::uint16_t of_few(byte_view octets) noexcept
{
    auto const* table = &at_distance<Count>[octets.size() - 1];
    std::uint32_t crc = (*table)[to_u8(octets[0]) ^ 0xFFU];
    crc ^= (*--table)[to_u8(octets[1]) ^ 0xFFU];
    for (std::size_t i = 2; i < octets.size(); ++i) {
        crc ^= (*--table)[to_u8(octets[i])];
    }
    return static_cast<std::uint16_t>(crc);
}

/// What 16 octets in two words, the first octet lowest, leave of a CRC that starts from 0.
[[nodiscard]] constexpr std::uint16_t of_block(std::uint64_t first, std::uint64_t second) noexcept
{
    auto const& tables = at_distance<16>;
    std::uint32_t crc = 0;
    for (std::size_t i = 0; i < 8; ++i) {
        crc ^= std::uint32_t{tables[15 - i][first >> 8 * i & 0xFFU]} ^
               tables[7 - i][second >> 8 * i & 0xFFU];
    }
    return static_cast<std::uint16_t>(crc);
}

/// The CRC by slices of `Count` octets.
template <std::size_t Count> [[nodiscard]] constexpr std::uint16_t sliced(byte_view octets) noexcept
{
    auto const& tables = at_distance<Count>;
    std::uint32_t crc = 0xFFFF;
    for (; octets.size() >= Count; octets = octets.subspan(Count)) {
        std::uint32_t next = tables[Count - 1][to_u8(octets[0]) ^ (crc & 0xFFU)] ^
                             tables[Count - 2][to_u8(octets[1]) ^ (crc >> 8U)];
        for (std::size_t i = 2; i < Count; ++i) {
            next ^= std::uint32_t{tables[Count - 1 - i][to_u8(octets[i])]};
        }
        crc = next;
    }
    for (std::byte const octet : octets) {
        crc = (crc >> 8U) ^ byte[(crc ^ to_u8(octet)) & 0xFFU];
    }
    return static_cast<std::uint16_t>(crc);
}

} // namespace rtuwire::crc16_tables
