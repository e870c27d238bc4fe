// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// The frame around a PDU: what is refused, and that nothing is written then.
#include <rtuwire/wire/adu.hpp>

#include <array>

#include "support/exact.hpp"
#include "support/proof.hpp"

#include <rtuwire/core/hex.hpp>
#include <rtuwire/wire/raw.hpp>
#include <rtuwire/wire/registers.hpp>

using namespace rtuwire;
using namespace rtuwire::detail;

namespace {

STATIC_CHECK(decode_adu(byte_view{}) == errc::frame_too_short);
STATIC_CHECK(decode_adu("01 03 40"_hex) == errc::frame_too_short);
STATIC_CHECK(decode_adu("FF FF"_hex) == errc::frame_too_short);
STATIC_CHECK(decode_adu("02 03 0C 1E 00 04 27 6D"_hex) == errc::crc_mismatch);
STATIC_CHECK(decode_adu(std::array<std::byte, 257>{}) == errc::frame_too_long);

constexpr bool takes_a_frame_apart()
{
    constexpr auto frame = "02 83 02 30 F1"_hex;
    auto const taken = decode_adu(frame);
    return taken and taken->unit() == 2 and taken->is_exception() and
           taken->function() == function_code::read_holding_registers and same_bytes(taken->pdu(), "83 02"_hex);
}
PROOF("a frame is taken apart into unit and PDU", takes_a_frame_apart)

/// The error of encoding into a place of a size, which must be untouched unless it is none.
template <typename Request> constexpr errc refusal(Request const& request, std::size_t room = 256)
{
    std::array<std::byte, 256> place{};
    for (std::byte& byte : place) {
        byte = std::byte{0xA5};
    }
    auto const written = encode_into(byte_span{place}.first(room), unit_id{1}, request);
    bool is_untouched = true;
    for (std::byte const byte : place) {
        is_untouched = is_untouched and byte == std::byte{0xA5};
    }
    if (written.has_value() == is_untouched) {
        return errc::device_failed;
    }
    return written.error();
}

constexpr register_block<124> many{};
constexpr register_view some(std::size_t count) { return register_view{many.view().bytes().first(2 * count)}; }

STATIC_CHECK(refusal(read_holding_registers{0, 1}) == errc::none);
STATIC_CHECK(refusal(read_holding_registers{0, 125}) == errc::none);
STATIC_CHECK(refusal(read_holding_registers{0, 0}) == errc::invalid_quantity);
STATIC_CHECK(refusal(read_holding_registers{0, 126}) == errc::invalid_quantity);
STATIC_CHECK(refusal(read_holding_registers{65535, 1}) == errc::none);
STATIC_CHECK(refusal(read_holding_registers{65535, 2}) == errc::invalid_address_range);
STATIC_CHECK(refusal(read_holding_registers{0, 1}, 7) == errc::buffer_too_small);
STATIC_CHECK(refusal(read_holding_registers{0, 1}, 0) == errc::buffer_too_small);
STATIC_CHECK(refusal(write_single_register{0, 1}, 8) == errc::none);
STATIC_CHECK(refusal(write_single_register{0, 1}, 7) == errc::buffer_too_small);
STATIC_CHECK(refusal(write_multiple_registers{0, {}}) == errc::invalid_quantity);
STATIC_CHECK(refusal(write_multiple_registers{0, some(123)}) == errc::none);
STATIC_CHECK(refusal(write_multiple_registers{0, some(124)}) == errc::invalid_quantity);
STATIC_CHECK(refusal(write_multiple_registers{65534, some(3)}) == errc::invalid_address_range);
STATIC_CHECK(refusal(write_multiple_registers{0, some(2)}, 12) == errc::buffer_too_small);
STATIC_CHECK(refusal(read_write_multiple_registers{0, 125, 0, some(121)}) == errc::none);
STATIC_CHECK(refusal(read_write_multiple_registers{0, 0, 0, some(1)}) == errc::invalid_quantity);
STATIC_CHECK(refusal(read_write_multiple_registers{0, 126, 0, some(1)}) == errc::invalid_quantity);
STATIC_CHECK(refusal(read_write_multiple_registers{0, 1, 0, {}}) == errc::invalid_quantity);
STATIC_CHECK(refusal(read_write_multiple_registers{0, 1, 0, some(122)}) == errc::invalid_quantity);
STATIC_CHECK(refusal(read_write_multiple_registers{65535, 2, 0, some(1)}) == errc::invalid_address_range);
STATIC_CHECK(refusal(read_write_multiple_registers{0, 2, 65535, some(2)}) == errc::invalid_address_range);

constexpr std::array<std::byte, 253> bytes{};
STATIC_CHECK(refusal(raw_pdu{static_cast<function_code>(0x41), byte_view{bytes}.first(252)}) == errc::none);
STATIC_CHECK(refusal(raw_pdu{static_cast<function_code>(0x41), bytes}) == errc::frame_too_long);
STATIC_CHECK(refusal(raw_pdu{static_cast<function_code>(0x00), {}}) == errc::invalid_function);
STATIC_CHECK(refusal(raw_pdu{static_cast<function_code>(0x80), {}}) == errc::invalid_function);

STATIC_CHECK(encode(destination{broadcast}, write_single_register{8501, 0}) == "00 06 21 35 00 00 92 29"_hex);

// A constant frame is as large as it has bytes, not as the largest of its function.
constexpr register_block<2> ramps{20, 30};
constexpr auto write_ramps = constant_frame([] { return encode(unit_id{2}, write_multiple_registers{9001, ramps}); });
static_assert(write_ramps.size() == 13);
STATIC_CHECK(write_ramps == "02 10 23 29 00 02 04 00 14 00 1E 73 A4"_hex);

constexpr bool refuses_every_wrong_byte()
{
    constexpr auto frame = "02 83 02 30 F1"_hex;
    for (std::size_t at = 0; at < frame.size(); ++at) {
        for (std::uint32_t other = 1; other <= 0xFF; ++other) {
            auto wrong = frame;
            wrong[at] ^= to_byte(other);
            if (not(decode_adu(wrong) == errc::crc_mismatch)) {
                return false;
            }
        }
    }
    return decode_adu(frame).has_value();
}
PROOF("a frame with any one byte wrong is refused", refuses_every_wrong_byte)

} // namespace

TEST_CASE("a frame has 4 to 256 bytes, whatever its CRC")
{
    for (std::size_t size = 0; size <= 300; ++size) {
        CAPTURE(size);
        // The CRC over nothing but its own two bytes FF, and then zeros, stays zero.
        test::exact_bytes frame{size};
        if (size >= 2) {
            frame.span()[0] = frame.span()[1] = std::byte{0xFF};
        }
        errc const expected = size < 4 ? errc::frame_too_short : size > 256 ? errc::frame_too_long : errc::none;
        auto const taken = decode_adu(frame.view());
        CHECK(taken.error() == expected);
        CHECK((not taken or taken->pdu().size() == size - 3));
    }
}
