// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// The CRC: its published check value, its residue, and that every form is the same function.
#include <rtuwire/core/crc16.hpp>

#include <array>

#include "support/proof.hpp"
#include "support/random.hpp"

#include <rtuwire/core/hex.hpp>

using namespace rtuwire;

namespace {

constexpr auto check_text = "31 32 33 34 35 36 37 38 39"_hex;

STATIC_CHECK(crc16<crc_form::bitwise>(check_text) == 0x4B37);
STATIC_CHECK(crc16<crc_form::nibble_table>(check_text) == 0x4B37);
STATIC_CHECK(crc16<crc_form::byte_table>(check_text) == 0x4B37);
STATIC_CHECK(crc16(check_text) == 0x4B37);
STATIC_CHECK(crc16(byte_view{}) == 0xFFFF);
STATIC_CHECK(crc16("02 03 0C 1E 00 04 27 6C"_hex) == 0);
// Two octets FF are the CRC of nothing, which is why a frame has at least four.
STATIC_CHECK(crc16("FF FF"_hex) == 0);

constexpr bool grows_octet_by_octet()
{
    running_crc16<> crc;
    for (std::size_t i = 0; i < check_text.size(); ++i) {
        if (crc.value() != crc16(byte_view{check_text}.first(i))) {
            return false;
        }
        crc.add(check_text[i]);
    }
    return crc.value() == 0x4B37;
}
PROOF("a running CRC is the CRC of the octets so far", grows_octet_by_octet)

constexpr bool is_zero_over_a_frame()
{
    test::random random{16};
    for (std::size_t size = 2; size <= 40; ++size) {
        std::array<std::byte, 42> frame{};
        byte_span const body = byte_span{frame}.first(size);
        random.fill(body);
        std::uint16_t const crc = crc16(body);
        frame[size] = to_byte(crc);
        frame[size + 1] = to_byte(std::uint32_t{crc} >> 8U);
        if (crc16(byte_view{frame}.first(size + 2)) != 0) {
            return false;
        }
    }
    return true;
}
PROOF("over a frame with its CRC, low octet first, the CRC is zero", is_zero_over_a_frame)

constexpr bool sees_every_wrong_bit()
{
    auto frame = "02 03 0C 1E 00 04 27 6C"_hex;
    for (std::byte& octet : frame) {
        for (unsigned bit = 0; bit < 8; ++bit) {
            octet ^= std::byte{1} << bit;
            if (crc16(frame) == 0) {
                return false;
            }
            octet ^= std::byte{1} << bit;
        }
    }
    return crc16(frame) == 0;
}
PROOF("no single wrong bit of a frame leaves the CRC right", sees_every_wrong_bit)

/// A few of the states and octets that the run below goes through all of.
constexpr bool forms_agree_for_some()
{
    test::random random{61};
    for (unsigned round = 0; round < 500; ++round) {
        auto const from = static_cast<std::uint16_t>(random.below(0x1'0000));
        std::byte const octet = to_byte(random.below(0x100));
        auto const bitwise = crc16_step<crc_form::bitwise>(from, octet);
        if (crc16_step<crc_form::nibble_table>(from, octet) != bitwise or
            crc16_step<crc_form::byte_table>(from, octet) != bitwise) {
            return false;
        }
    }
    return true;
}
PROOF("all forms agree for some states and octets when compiling", forms_agree_for_some)

} // namespace

TEST_CASE("all forms agree for every state and every octet")
{
    std::uint32_t disagreements = 0;
    for (std::uint32_t state = 0; state <= 0xFFFF; ++state) {
        auto const from = static_cast<std::uint16_t>(state);
        for (std::uint32_t value = 0; value <= 0xFF; ++value) {
            std::byte const octet = to_byte(value);
            auto const bitwise = crc16_step<crc_form::bitwise>(from, octet);
            disagreements += crc16_step<crc_form::nibble_table>(from, octet) != bitwise ? 1U : 0U;
            disagreements += crc16_step<crc_form::byte_table>(from, octet) != bitwise ? 1U : 0U;
        }
    }
    CHECK(disagreements == 0);
}
