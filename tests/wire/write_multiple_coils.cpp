// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Function 15 at every quantity and every size, both directions.
#include <rtuwire/wire/bits.hpp>

#include "support/golden.hpp"
#include "support/pdu_facts.hpp"
#include "support/proof.hpp"

#include <rtuwire/core/hex.hpp>

using namespace rtuwire;
using namespace rtuwire::detail;

namespace {

constexpr bit_block ten{true, false, true, true, false, false, true, true, true, false};

constexpr bool confirms_1_to_1968()
{
    using test::is;
    return is(test::counts_to<write_multiple_coils_response>(1968), "quantities") and
           is(test::has_size<write_multiple_coils_response>("0F 00 13 00 0A 00 00"_hex, 5), "sizes") and
           is(write_multiple_coils_response::decode("10 00 13 00 0A"_hex) == errc::wrong_function, "another function");
}
PROOF("a response of function 15 confirms 1 to 1968 coils", confirms_1_to_1968)

// The specification's example, and the same to everyone.
STATIC_CHECK(test::encodes(unit_id{1}, write_multiple_coils{19, ten}, "01 0F 00 13 00 0A 02 CD 01 72 CB"_hex));
STATIC_CHECK(test::encodes(broadcast, write_multiple_coils{19, ten}, "00 0F 00 13 00 0A 02 CD 01 7F 5B"_hex));
STATIC_CHECK(write_multiple_coils<bit_block<10>>::max_size == 8 and write_multiple_coils<>::max_size == 252);

constexpr bool pads_with_zeros()
{
    constexpr auto all_on = "FF FF"_hex;
    write_multiple_coils const nine{19, bit_view{all_on, 9}};
    return encode(unit_id{1}, nine)->view()[8] == std::byte{0x01} and test::needs_room(nine, 11) and
           test::survives(nine, [&](auto const& read) { return read == nine and read.values.size() == 9; });
}
PROOF("function 15 fills its last byte with zeros", pads_with_zeros)

constexpr bool tells_writes_apart()
{
    constexpr bit_block<10> other{};
    constexpr auto padded = "0F 00 13 00 0A 02 CD FD"_hex;
    write_multiple_coils const one{19, ten};
    return one == write_multiple_coils{19, ten} and not(one == write_multiple_coils{20, ten}) and
           not(one == write_multiple_coils{19, other}) and *write_multiple_coils<>::decode(padded) == one;
}
PROOF("requests of function 15 differ by address and by coils, not by what is behind the last coil", tells_writes_apart)

/// Behind a request a writer has room for what it did not take.
constexpr bool writes_its_size()
{
    std::array<std::byte, 32> place{};
    byte_writer out{place};
    constexpr bit_block nine{true, false, true, true, false, false, true, true, true};
    write_multiple_coils const asked{0x13, nine};
    asked.write(out);
    return out.size() == asked.size() and asked.size() == 8;
}
PROOF("function 15 writes as many bytes as it has", writes_its_size)

} // namespace

TEST_CASE("a response of function 15 is read with a quantity of 1 to 1968 of all 65536")
{
    CHECK(test::misread_quantities<write_multiple_coils_response>(1968) == 0);
}

TEST_CASE("function 15 writes 1 to 1968 coils up to address 65535, and nothing else is written")
{
    test::sample const some{15};
    unsigned wrong = 0;
    for (std::size_t count = 0; count <= 1977; ++count) {
        bit_view const bits{some.bytes, count};
        auto const last = static_cast<std::uint16_t>(0x1'0000 - count);
        write_multiple_coils const tell{count == 0 ? std::uint16_t{0} : last, bits};
        bool const is_right =
            count >= 1 and count <= 1968
                ? test::survives(tell, [&](auto const& read) { return read == tell and read.values.size() == count; })
                : test::is_refused(tell, errc::invalid_quantity);
        bool const is_past = count < 2 or count > 1968 or
                             test::is_refused(write_multiple_coils{static_cast<std::uint16_t>(last + 1), bits},
                                              errc::invalid_address_range);
        wrong += is_right and is_past ? 0U : 1U;
    }
    CHECK(wrong == 0);
}

TEST_CASE("a request of function 15 is read only when quantity, byte count and size agree")
{
    test::sample pdu{16};
    pdu.bytes[0] = std::byte{15};
    unsigned wrong = 0;
    for (std::uint32_t quantity : {0U, 1U, 7U, 8U, 9U, 16U, 17U, 1960U, 1961U, 1968U, 1969U, 2000U, 0x0801U, 0xFFFFU}) {
        for (std::uint32_t byte_count = 0; byte_count <= 255; ++byte_count) {
            for (std::size_t size = 1; size <= pdu.bytes.size(); ++size) {
                put_u16(&pdu.bytes[3], static_cast<std::uint16_t>(quantity));
                pdu.bytes[5] = to_byte(byte_count);
                test::exact_bytes const part{pdu.first(size)};
                errc const expected = size < 6 or size != 6 + byte_count ? errc::wrong_length
                                      : quantity == 0 or quantity > 1968 ? errc::invalid_quantity
                                      : byte_count != (quantity + 7) / 8 ? errc::wrong_length
                                                                         : errc::none;
                wrong += write_multiple_coils<>::decode(part.view()).error() == expected ? 0U : 1U;
            }
        }
    }
    CHECK(wrong == 0);
}
