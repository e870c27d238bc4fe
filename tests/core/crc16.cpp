// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// The CRC: its published check value, its residue, and that every form is the same function.
#include <rtuwire/core/crc16.hpp>

#include "support/proof.hpp"

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
