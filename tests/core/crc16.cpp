// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// The CRC: its published check value, its residue, and that every form is the same function.
#include <rtuwire/core/crc16.hpp>

#include <array>

#include "support/proof.hpp"
#include "support/random.hpp"

#include <rtuwire/core/hex.hpp>

using namespace rtuwire;
using namespace rtuwire::detail;

namespace {

constexpr auto check_text = "31 32 33 34 35 36 37 38 39"_hex;

STATIC_CHECK(crc16<crc_form::bitwise>(check_text) == 0x4B37);
STATIC_CHECK(crc16<crc_form::nibble_table>(check_text) == 0x4B37);
STATIC_CHECK(crc16<crc_form::byte_table>(check_text) == 0x4B37);
STATIC_CHECK(crc16<crc_form::host>(check_text) == 0x4B37);
STATIC_CHECK(crc16(check_text) == 0x4B37);
STATIC_CHECK(crc16(byte_view{}) == 0xFFFF);
STATIC_CHECK(crc16("02 03 0C 1E 00 04 27 6C"_hex) == 0);
// Two bytes FF are the CRC of nothing, which is why a frame has at least four.
STATIC_CHECK(crc16("FF FF"_hex) == 0);

constexpr bool grows_byte_by_byte()
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
PROOF("a running CRC is the CRC of the bytes so far", grows_byte_by_byte)

template <crc_form Form> constexpr bool goes_on()
{
    byte_view const all{check_text};
    for (std::size_t cut = 0; cut <= all.size(); ++cut) {
        running_crc16<Form> crc{crc16(all.first(cut))};
        for (std::byte const byte : all.subspan(cut)) {
            crc.add(byte);
        }
        if (crc.value() != 0x4B37) {
            return false;
        }
    }
    return running_crc16<Form>{0}.value() == 0 and running_crc16<Form>{0x0001}.value() == 0x0001;
}
constexpr bool goes_on_in_every_form()
{
    return goes_on<crc_form::bitwise>() and goes_on<crc_form::nibble_table>() and goes_on<crc_form::byte_table>() and
           goes_on<crc_form::host>();
}
PROOF("a running CRC goes on from that of the bytes before", goes_on_in_every_form)

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
PROOF("over a frame with its CRC, low byte first, the CRC is zero", is_zero_over_a_frame)

constexpr bool sees_every_wrong_bit()
{
    auto frame = "02 03 0C 1E 00 04 27 6C"_hex;
    for (std::byte& byte : frame) {
        for (unsigned bit = 0; bit < 8; ++bit) {
            byte ^= std::byte{1} << bit;
            if (crc16(frame) == 0) {
                return false;
            }
            byte ^= std::byte{1} << bit;
        }
    }
    return crc16(frame) == 0;
}
PROOF("no single wrong bit of a frame leaves the CRC right", sees_every_wrong_bit)

} // namespace
