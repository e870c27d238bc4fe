// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// CRC-16/MODBUS (Modbus over Serial Line V1.02, 6.2.2): start FFFF, reflected polynomial A001, no final XOR;
// the low byte is sent first. One function in several forms, all with the same result.
#pragma once

#include <cstddef>
#include <cstdint>

#include <rtuwire/core/bytes.hpp>
#include <rtuwire/core/crc16/tables.hpp>
#include <rtuwire/core/crc16/words.hpp>
#include <rtuwire/core/version.hpp>

namespace rtuwire {
inline namespace RTUWIRE_BUILD {

/// How the CRC is computed, and what tables that needs.
enum class crc_form : std::uint8_t {
    bitwise,      ///< nothing
    nibble_table, ///< 32 bytes
    byte_table,   ///< 512 bytes
    host,         ///< 4 KiB; up to 64 bytes at a time, for 64-bit processors
};

namespace detail {

/// The form in use: the program's choice by `-DRTUWIRE_CRC_FORM=byte_table`, or `nibble_table` on 32 bits and `host`
/// elsewhere.
inline constexpr crc_form default_crc_form = crc_form::RTUWIRE_CRC_FORM;

} // namespace detail

/// A CRC that is updated byte by byte, so that a receiver has it when the last byte arrives. Over a whole
/// frame, its two CRC bytes included, the value is zero exactly when the CRC is right. `host` processes single bytes by
/// the byte table.
template <crc_form Form = detail::default_crc_form> class running_crc16 {
public:
    constexpr running_crc16() noexcept = default;
    /// Continues after bytes whose CRC is `from`.
    explicit constexpr running_crc16(std::uint16_t from) noexcept : state_{from} {}

    /// Takes the next byte.
    constexpr void add(std::byte byte) noexcept
    {
        std::uint32_t mixed = std::uint32_t{state_} ^ detail::to_u8(byte);
        if constexpr (Form == crc_form::bitwise) {
            state_ = crc16_tables::shifted(mixed, 8);
        } else if constexpr (Form == crc_form::nibble_table) {
            mixed = (mixed >> 4U) ^ crc16_tables::nibble[mixed & 0xFU];
            mixed = (mixed >> 4U) ^ crc16_tables::nibble[mixed & 0xFU];
            state_ = static_cast<std::uint16_t>(mixed);
        } else {
            state_ = static_cast<std::uint16_t>((mixed >> 8U) ^ crc16_tables::of_byte(mixed));
        }
    }

    /// The CRC of everything taken so far; FFFF before the first byte.
    [[nodiscard]] constexpr std::uint16_t value() const noexcept { return state_; }

private:
    std::uint16_t state_{0xFFFF};
};

namespace detail {

/// More than 8 bytes. Not inlined, so that the choice by size is inlined where the size is known.
[[nodiscard, gnu::noinline]] constexpr std::uint16_t crc16_of_many(byte_view bytes) noexcept
{
    return bytes.size() <= 32 ? crc16_tables::of_some(bytes) : crc16_words::of_words(bytes);
}

} // namespace detail

/// The CRC of a sequence of bytes.
template <crc_form Form = detail::default_crc_form>
[[nodiscard]] constexpr std::uint16_t crc16(byte_view bytes) noexcept
{
    if constexpr (Form == crc_form::host) {
        return bytes.size() <= 8 ? crc16_tables::of_few(bytes.data(), bytes.size()) : detail::crc16_of_many(bytes);
    } else {
        running_crc16<Form> crc;
        std::byte const* at = bytes.data();
        std::byte const* const end = at + bytes.size();
        if (at != end) {
            do { // tested at its end: an instruction less for each byte where a compiler optimises for size
                crc.add(*at++);
            } while (at != end);
        }
        return crc.value();
    }
}

} // namespace RTUWIRE_BUILD
} // namespace rtuwire
