// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Cursors that cannot overrun.
#include <rtuwire/core/bytes.hpp>

#include <array>

#include "support/proof.hpp"

#include <rtuwire/core/fixed_buffer.hpp>
#include <rtuwire/core/hex.hpp>

using namespace rtuwire;

namespace {

constexpr bool reads_in_order()
{
    constexpr auto octets = "01 02 03 04 05"_hex;
    byte_reader in{octets};
    bool const right = in.u8() == 1 and in.u16() == 0x0203 and in.rest().size() == 2;
    return right and same_bytes(in.take(2), "04 05"_hex) and in.ok() and in.rest().empty();
}
PROOF("a reader takes big-endian fields from the front", reads_in_order)

constexpr bool stays_failed()
{
    constexpr auto octets = "01 02 03"_hex;
    byte_reader in{octets};
    bool const none = in.take(4).empty() and not in.ok();
    return none and in.u8() == 0 and in.u16() == 0 and not in.ok();
}
PROOF("a reader past its end yields zeros and never recovers", stays_failed)

constexpr bool writes_whole_fields_only()
{
    std::array<std::byte, 3> place{};
    byte_writer out{place};
    out.u16(0xABCD);
    out.u16(0x1234);
    bool const refused = not out.ok() and out.size() == 2;
    out.u8(0x56);
    return refused and out.size() == 2 and same_bytes(place, "AB CD 00"_hex);
}
PROOF("a field that does not fit is not written, nor any after it", writes_whole_fields_only)

constexpr bool writes_all_octets_or_none()
{
    std::array<std::byte, 2> place{};
    byte_writer out{place};
    out.bytes("01 02 03"_hex);
    bool const refused = not out.ok() and out.written().empty();
    byte_writer again{place};
    again.bytes("07 08"_hex);
    return refused and again.ok() and same_bytes(again.written(), "07 08"_hex);
}
PROOF("octets are written all or not at all", writes_all_octets_or_none)

STATIC_CHECK(not same_bytes("01"_hex, "01 02"_hex));
STATIC_CHECK(not same_bytes("01 03"_hex, "01 02"_hex));
STATIC_CHECK(to_byte(0x1FF) == std::byte{0xFF});

constexpr bool keeps_its_capacity()
{
    constexpr auto one = "01"_hex;
    constexpr auto two = "01 02"_hex;
    fixed_buffer<4> buffer;
    bool const starts_empty = buffer.empty() and buffer.size() == 0;
    byte_writer{buffer.storage()}.u16(0x0102);
    buffer.resize(2);
    bool const holds = buffer == byte_view{two} and not(buffer == byte_view{one});
    buffer.resize(9);
    return starts_empty and holds and buffer.size() == 4 and buffer.capacity() == 4;
}
PROOF("a fixed buffer never holds more than its capacity", keeps_its_capacity)

} // namespace
