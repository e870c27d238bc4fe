// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// CRC-16/MODBUS (Modbus over Serial Line V1.02, 6.2.2): start FFFF, reflected polynomial A001, no final XOR;
// the low byte is sent first. One function in several forms, all with the same result.
#pragma once

#include <cstddef>
#include <cstdint>
#include <type_traits>

#include <rtuwire/core/bytes.hpp>
#include <rtuwire/core/crc16/algebra.hpp>
#include <rtuwire/core/crc16/carryless.hpp>
#include <rtuwire/core/crc16/tables.hpp>
#include <rtuwire/core/version.hpp>

namespace rtuwire::inline RTUWIRE_BUILD {

/// How the CRC is computed, and what tables that needs.
enum class crc_form : std::uint8_t {
    bitwise,       ///< nothing
    nibble_table,  ///< 32 bytes
    byte_table,    ///< 512 bytes
    slicing_by_4,  ///< 2 KiB
    slicing_by_8,  ///< 4 KiB
    slicing_by_16, ///< 8 KiB
    byte_algebra,  ///< nothing; a byte at a time, for processors without a cache
    word_algebra,  ///< nothing; 64 bytes at a time, for 64-bit processors
    host,          ///< 4 KiB for up to 32 bytes, and for the last word that `word_algebra` leaves
    carryless,     ///< 4 KiB for up to 16 bytes; beyond, carry-less multiplication; else as `host`
};

/// The form in use: the program's choice by `-DRTUWIRE_CRC_FORM=byte_table`, or carry-less multiplication
/// where the processor has it, the form without tables on 32 bits, `host` elsewhere.
/// Internal.
inline constexpr crc_form default_crc_form = crc_form::RTUWIRE_CRC_FORM;

/// A CRC that is updated byte by byte, so that a receiver has it when the last byte arrives. Over a whole
/// frame, its two CRC bytes included, the value is zero exactly when the CRC is right. Forms that process
/// several bytes at a time process single ones by the byte table, or by algebra where they have no table.
template <crc_form Form = default_crc_form> class running_crc16 {
public:
    constexpr running_crc16() noexcept = default;
    /// Continues after bytes whose CRC is `from`.
    explicit constexpr running_crc16(std::uint16_t from) noexcept : state_{from} {}

    /// Takes the next byte.
    constexpr void add(std::byte byte) noexcept
    {
        std::uint32_t mixed = std::uint32_t{state_} ^ to_u8(byte);
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

template <> class running_crc16<crc_form::byte_algebra> : public crc16_algebra::running {
    using running::running;
};
template <> class running_crc16<crc_form::word_algebra> : public crc16_algebra::running {
    using running::running;
};

namespace crc16_forms {

template <crc_form Form> [[nodiscard]] constexpr std::uint16_t by_bytes(byte_view bytes) noexcept
{
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

/// More than 8 bytes: up to 16 by tables and more by multiplication, or up to 32 by tables and more by
/// algebra, with tables for the last word. Not inlined, so that `by_size` is inlined where the size is known.
template <crc_form Form> [[nodiscard, gnu::noinline]] constexpr std::uint16_t of_many(byte_view bytes) noexcept
{
    constexpr bool multiplies = Form == crc_form::carryless and crc16_carryless::is_available;
    if (bytes.size() <= (multiplies ? 16 : 32)) {
        return crc16_tables::of_some(bytes);
    }
    if constexpr (multiplies) {
        if (not std::is_constant_evaluated()) {
            return crc16_carryless::of_blocks(bytes);
        }
    }
    return crc16_algebra::of_words<crc16_tables::of_word>(bytes);
}

/// How many bytes a slicing form processes at a time; 1 for the others, for which no slices are made.
[[nodiscard]] constexpr std::size_t slices_of(crc_form form) noexcept
{
    return form == crc_form::slicing_by_4    ? 4
           : form == crc_form::slicing_by_8  ? 8
           : form == crc_form::slicing_by_16 ? 16
                                             : 1;
}

template <crc_form Form> [[nodiscard]] constexpr std::uint16_t by_size(byte_view bytes) noexcept
{
    return bytes.size() <= 8 ? crc16_tables::of_few(bytes.data(), bytes.size()) : of_many<Form>(bytes);
}

} // namespace crc16_forms

/// The CRC of a sequence of bytes.
template <crc_form Form = default_crc_form> [[nodiscard]] constexpr std::uint16_t crc16(byte_view bytes) noexcept
{
    if constexpr (constexpr std::size_t slices = crc16_forms::slices_of(Form); slices > 1) {
        return crc16_tables::sliced<slices>(bytes);
    } else if constexpr (Form == crc_form::word_algebra) {
        return bytes.size() < 8 ? crc16_forms::by_bytes<Form>(bytes) : crc16_algebra::of_words(bytes);
    } else if constexpr (Form == crc_form::host or Form == crc_form::carryless) {
        return crc16_forms::by_size<Form>(bytes);
    } else {
        return crc16_forms::by_bytes<Form>(bytes);
    }
}

} // namespace rtuwire
