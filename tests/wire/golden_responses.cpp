// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// The responses of the drives' manuals, byte by byte, named as in the list of frames.
#include <rtuwire/wire/adu.hpp>

#include "support/golden.hpp"
#include "support/proof.hpp"

#include <rtuwire/core/hex.hpp>
#include <rtuwire/core/literal.hpp>
#include <rtuwire/wire/raw.hpp>
#include <rtuwire/wire/registers.hpp>
#include <rtuwire/wire/serial_line/device_identification.hpp>
#include <rtuwire/wire/serial_line/diagnostics.hpp>

using namespace rtuwire;
using namespace rtuwire::detail;
using rtuwire::test::encodes;
using rtuwire::test::is_told;

namespace {

constexpr result<device_identification> page_of(byte_view frame)
{
    auto const taken = decode_adu(frame);
    if (not taken) {
        return taken.error();
    }
    return device_identification::decode(taken->pdu());
}

constexpr errc decode_page(byte_view frame) { return page_of(frame).error(); }

constexpr bool reencodes(byte_view frame)
{
    auto const page = page_of(frame);
    if (not page) {
        return false;
    }
    return encode(unit_id{2}, *page) == frame;
}

constexpr bool object_is(byte_view frame, std::uint8_t id, literal expected)
{
    auto const page = page_of(frame);
    auto const value = page ? page->find(id) : std::nullopt;
    if (not value or value->size() != expected.size()) {
        return false;
    }
    for (std::size_t i = 0; i < expected.size(); ++i) {
        if (to_u8((*value)[i]) != static_cast<unsigned char>(expected[i])) {
            return false;
        }
    }
    return true;
}

// fc03_rsp
constexpr register_block four{0x0028, 0x0258, 0x01F4, 0x0000};
STATIC_CHECK(encodes(unit_id{2}, read_holding_registers_response{four}, "02 03 08 00 28 02 58 01 F4 00 00 52 B0"_hex));
// fc16_rsp
STATIC_CHECK(encodes(unit_id{2}, write_multiple_registers_response{9001, 2}, "02 10 23 29 00 02 9B B7"_hex));
// fc43_rsp_ok
constexpr auto fc43_rsp_ok = "02 2B 0E 01 02 00 00 03 00 12 53 63 68 6E 65 69 64 65 72 20 45 6C 65 63 "
                             "74 72 69 63 01 0C 41 54 56 33 31 30 48 30 33 37 4E 34 02 04 30 32 30 31 "
                             "B0 38 "_hex;
STATIC_CHECK(reencodes(fc43_rsp_ok));
STATIC_CHECK(is_told(direction::response, fc43_rsp_ok));
STATIC_CHECK(object_is(fc43_rsp_ok, vendor_name, "Schneider Electric"));
STATIC_CHECK(object_is(fc43_rsp_ok, product_code, "ATV310H037N4"));
STATIC_CHECK(object_is(fc43_rsp_ok, major_minor_revision, "0201"));
// fc43_rsp_as_printed
// Length byte 0B for a reference of 12 characters.
constexpr auto fc43_rsp_as_printed = "02 2B 0E 01 02 00 00 03 00 12 53 63 68 6E 65 69 64 65 72 20 45 6C 65 63 "
                                     "74 72 69 63 01 0B 41 54 56 33 31 30 48 30 33 37 4E 34 02 04 30 32 30 31 "
                                     "05 4C "_hex;
STATIC_CHECK(crc16(fc43_rsp_as_printed) == 0);
STATIC_CHECK(decode_page(fc43_rsp_as_printed) == errc::malformed);
// fc43_rsp_11
constexpr auto fc43_rsp_11 = "02 2B 0E 01 02 00 00 03 00 12 53 63 68 6E 65 69 64 65 72 20 45 6C 65 63 "
                             "74 72 69 63 01 0B 41 54 56 33 31 30 48 30 33 37 4E 02 04 30 32 30 31 3D "
                             "43 "_hex;
STATIC_CHECK(reencodes(fc43_rsp_11));
STATIC_CHECK(is_told(direction::response, fc43_rsp_11));
STATIC_CHECK(object_is(fc43_rsp_11, vendor_name, "Schneider Electric"));
STATIC_CHECK(object_is(fc43_rsp_11, product_code, "ATV310H037N"));
STATIC_CHECK(object_is(fc43_rsp_11, major_minor_revision, "0201"));
// exc_fc03
STATIC_CHECK(encodes(unit_id{2}, exception_response{static_cast<function_code>(3), 0x02}, "02 83 02 30 F1"_hex));
// exc_fc06
STATIC_CHECK(encodes(unit_id{2}, exception_response{static_cast<function_code>(6), 0x03}, "02 86 03 F2 61"_hex));
// exc_fc16
STATIC_CHECK(encodes(unit_id{2}, exception_response{static_cast<function_code>(16), 0x03}, "02 90 03 FC 01"_hex));
// exc_fc23
STATIC_CHECK(encodes(unit_id{2}, exception_response{static_cast<function_code>(23), 0x02}, "02 97 02 3F F1"_hex));
// exc_fc43
STATIC_CHECK(encodes(unit_id{2}, exception_response{static_cast<function_code>(43), 0x01}, "02 AB 01 6E F0"_hex));
// atv28_fc16_rsp
STATIC_CHECK(encodes(unit_id{2}, write_multiple_registers_response{400, 2}, "02 10 01 90 00 02 40 2A"_hex));
// scan_write_rsp
STATIC_CHECK(encodes(unit_id{3}, write_multiple_registers_response{12761, 4}, "03 10 31 D9 00 04 1F 2F"_hex));
// fc23_rsp
constexpr register_block three{0x0237, 0x05DC, 0x0000};
STATIC_CHECK(encodes(unit_id{2}, read_write_multiple_registers_response{three},
                     "02 17 06 02 37 05 DC 00 00 00 6A"_hex));

} // namespace
