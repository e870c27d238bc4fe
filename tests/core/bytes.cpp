// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Cursors that cannot overrun.
#include <rtuwire/core/bytes.hpp>

#include <array>
#include <type_traits>

#include "support/exact.hpp"
#include "support/proof.hpp"

#include <rtuwire/core/hex.hpp>

using namespace rtuwire;
using namespace rtuwire::detail;

namespace {

constexpr bool writes_no_half_word()
{
    test::exact_bytes place{1, std::byte{0xA5}};
    byte_writer out{place.span()};
    out.u16(0x1234);
    bool const refused = not out.ok() and out.size() == 0 and out.written().empty();
    out.u8(0x56);
    out.bytes({});
    return refused and not out.ok() and out.size() == 0 and place.view()[0] == std::byte{0xA5};
}
PROOF("a word of which only half fits is not written, nor is anything afterwards", writes_no_half_word)

constexpr bool gives_whole_parts()
{
    test::exact_bytes place{5};
    byte_writer out{place.span()};
    out.u8(1);
    bool const fits = out.take(3) == place.view().data() + 1 and out.ok() and out.size() == 4;
    bool const refused = out.take(2) == nullptr and not out.ok() and out.size() == 4;
    return fits and refused and out.take(1) == nullptr;
}
PROOF("a writer gives a part that fits whole, or none and nothing afterwards", gives_whole_parts)

constexpr bool fills_to_the_last_byte()
{
    test::exact_bytes place{3};
    byte_writer out{place.span()};
    out.u16(0x1'0203);
    out.u8(0x104);
    out.bytes({});
    return out.ok() and out.size() == 3 and same_bytes(out.written(), "02 03 04"_hex);
}
PROOF("a writer fills its target to the last byte with the low bits", fills_to_the_last_byte)

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

constexpr bool writes_all_bytes_or_none()
{
    std::array<std::byte, 2> place{};
    byte_writer out{place};
    out.bytes("01 02 03"_hex);
    bool const refused = not out.ok() and out.written().empty();
    byte_writer again{place};
    again.bytes("07 08"_hex);
    return refused and again.ok() and same_bytes(again.written(), "07 08"_hex);
}
PROOF("bytes are written all or not at all", writes_all_bytes_or_none)

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

constexpr bool is_equal_by_what_it_holds()
{
    constexpr auto one = "01"_hex;
    fixed_buffer<2> buffer;
    byte_writer{buffer.storage()}.u16(0x01FF);
    buffer.resize(1);
    fixed_buffer<2> const copy = buffer;
    byte_writer{buffer.storage()}.u16(0x02FF);
    byte_view const viewed = copy;
    return copy == byte_view{one} and not(buffer == byte_view{one}) and same_bytes(viewed, one);
}
PROOF("a fixed buffer is equal by what it holds, not by what lies behind, and a copy is its own",
      is_equal_by_what_it_holds)

STATIC_CHECK(std::is_trivially_copyable_v<fixed_buffer<256>>);
STATIC_CHECK(sizeof(fixed_buffer<256>) == 258);

} // namespace
