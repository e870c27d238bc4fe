// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// CRC-16/MODBUS (Modbus over Serial Line V1.02, 6.2.2): start FFFF, reflected polynomial A001, no
// final XOR; the low octet travels first. One function in several table sizes, all equal.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include <rtuwire/core/bytes.hpp>

namespace rtuwire {

/// How the CRC is computed: the table it needs is nothing, 32 octets or 512 octets.
enum class crc_form : std::uint8_t { bitwise, nibble_table, byte_table };

/// What is used where nobody chooses: the small table on 32-bit and smaller processors, the fast one
/// on hosts.
inline constexpr crc_form default_crc_form =
    sizeof(void*) >= 8 ? crc_form::byte_table : crc_form::nibble_table;

namespace crc16_tables {

constexpr std::uint16_t shifted(std::uint32_t state, unsigned bits) noexcept
{
    for (unsigned i = 0; i < bits; ++i) {
        state = (state >> 1U) ^ ((state & 1U) != 0 ? 0xA001U : 0U);
    }
    return static_cast<std::uint16_t>(state);
}

template <std::size_t Entries, unsigned Bits>
constexpr std::array<std::uint16_t, Entries> make() noexcept
{
    std::array<std::uint16_t, Entries> table{};
    for (std::size_t i = 0; i < Entries; ++i) {
        table[i] = shifted(static_cast<std::uint32_t>(i), Bits);
    }
    return table;
}

inline constexpr auto nibble = make<16, 4>();
inline constexpr auto byte = make<256, 8>();

} // namespace crc16_tables

/// The CRC state after one more octet.
template <crc_form Form = default_crc_form>
[[nodiscard]] constexpr std::uint16_t crc16_step(std::uint16_t state, std::byte octet) noexcept
{
    std::uint32_t mixed = std::uint32_t{state} ^ to_u8(octet);
    if constexpr (Form == crc_form::bitwise) {
        return crc16_tables::shifted(mixed, 8);
    } else if constexpr (Form == crc_form::nibble_table) {
        mixed = (mixed >> 4U) ^ crc16_tables::nibble[mixed & 0xFU];
        mixed = (mixed >> 4U) ^ crc16_tables::nibble[mixed & 0xFU];
        return static_cast<std::uint16_t>(mixed);
    } else {
        return static_cast<std::uint16_t>((mixed >> 8U) ^ crc16_tables::byte[mixed & 0xFFU]);
    }
}

/// A CRC that grows an octet at a time, so that a receiver has it when the last octet arrives. Over a
/// whole frame, its two CRC octets included, the value is zero exactly when the CRC is right.
template <crc_form Form = default_crc_form> class running_crc16 {
public:
    /// Takes the next octet.
    constexpr void add(std::byte octet) noexcept { state_ = crc16_step<Form>(state_, octet); }

    /// The CRC of everything taken so far; FFFF before the first octet.
    [[nodiscard]] constexpr std::uint16_t value() const noexcept { return state_; }

private:
    std::uint16_t state_{0xFFFF};
};

/// The CRC of a sequence of octets.
template <crc_form Form = default_crc_form>
[[nodiscard]] constexpr std::uint16_t crc16(byte_view bytes) noexcept
{
    running_crc16<Form> crc;
    for (std::byte const octet : bytes) {
        crc.add(octet);
    }
    return crc.value();
}

} // namespace rtuwire
