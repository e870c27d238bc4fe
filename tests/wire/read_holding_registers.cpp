// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Function 03 at every quantity and every size, both directions.
#include <rtuwire/wire/registers.hpp>

#include <array>

#include "support/encode_space.hpp"
#include "support/proof.hpp"
#include "support/random.hpp"

#include <rtuwire/core/hex.hpp>

using namespace rtuwire;
using namespace rtuwire::detail;
using rtuwire::test::is_refused;
using rtuwire::test::needs_room;
using rtuwire::test::survives;

namespace {

constexpr bool asks_for_1_to_125()
{
    for (std::uint32_t count = 0; count <= 127; ++count) {
        read_holding_registers const ask{3201, static_cast<std::uint16_t>(count)};
        bool const is_right = count >= 1 and count <= 125
                                  ? survives(ask, [&](read_holding_registers const& read) { return read == ask; })
                                  : is_refused(ask, errc::invalid_quantity);
        if (not is_right) {
            return false;
        }
    }
    return is_refused(read_holding_registers{0, 0xFFFF}, errc::invalid_quantity);
}
PROOF("function 03 asks for 1 to 125 registers, and nothing else is written", asks_for_1_to_125)

constexpr bool asks_up_to_the_last_register()
{
    for (std::uint32_t count = 1; count <= 125; ++count) {
        auto const quantity = static_cast<std::uint16_t>(count);
        auto const last = static_cast<std::uint16_t>(65536 - count);
        auto const past = static_cast<std::uint16_t>(65537 - count);
        if (read_holding_registers{last, quantity}.check() != errc::none) {
            return false;
        }
        if (count > 1 and not is_refused(read_holding_registers{past, quantity}, errc::invalid_address_range)) {
            return false;
        }
    }
    return true;
}
PROOF("function 03 asks for nothing past register 65535", asks_up_to_the_last_register)

constexpr bool reads_requests_of_five_bytes()
{
    constexpr auto bytes = "03 0C 81 00 01 00 00"_hex;
    for (std::size_t size = 0; size <= bytes.size(); ++size) {
        test::exact_bytes const pdu{byte_view{bytes}.first(size)};
        errc const expected = size == 0 ? errc::wrong_function : size == 5 ? errc::none : errc::wrong_length;
        if (read_holding_registers::decode(pdu.view()).error() != expected) {
            return false;
        }
    }
    return true;
}
PROOF("a request of function 03 has five bytes", reads_requests_of_five_bytes)

constexpr bool needs_eight_bytes() { return needs_room(read_holding_registers{3201, 1}, 8); }
PROOF("a request of function 03 needs a place of eight bytes", needs_eight_bytes)

constexpr bool response_needs_its_room()
{
    register_block const words{0x0237, 0x05DC};
    return needs_room(read_holding_registers_response{words}, 9);
}
PROOF("a response of function 03 needs five bytes and two for each register", response_needs_its_room)

} // namespace

TEST_CASE("a request of function 03 is read with a quantity of 1 to 125 of all 65536")
{
    unsigned wrong = 0;
    for (std::uint32_t count = 0; count <= 0xFFFF; ++count) {
        std::array<std::byte, 5> pdu{std::byte{3}};
        pdu[3] = to_byte(count >> 8U);
        pdu[4] = to_byte(count);
        errc const expected = count >= 1 and count <= 125 ? errc::none : errc::invalid_quantity;
        wrong += read_holding_registers::decode(pdu).error() == expected ? 0U : 1U;
    }
    CHECK(wrong == 0);
}

TEST_CASE("a response of function 03 is read only when byte count and size agree on whole registers")
{
    std::array<std::byte, 260> bytes{};
    test::random random{3};
    random.fill(bytes);
    bytes[0] = std::byte{3};
    unsigned wrong = 0;
    for (std::uint32_t byte_count = 0; byte_count <= 255; ++byte_count) {
        bytes[1] = to_byte(byte_count);
        for (std::size_t size = 2; size <= bytes.size(); ++size) {
            test::exact_bytes const pdu{byte_view{bytes}.first(size)};
            auto const read = read_holding_registers_response::decode(pdu.view());
            bool const agrees = size == 2 + byte_count and byte_count % 2 == 0;
            bool const fits = byte_count >= 2 and byte_count <= 250;
            errc const expected = not agrees ? errc::wrong_length : not fits ? errc::invalid_quantity : errc::none;
            bool const holds =
                read.error() == expected and (not read or same_bytes(read->registers.bytes(), pdu.view().subspan(2)));
            wrong += holds ? 0U : 1U;
        }
    }
    CHECK(wrong == 0);
}

TEST_CASE("a response of function 03 with 0 to 126 registers is written when it has 1 to 125")
{
    std::array<std::byte, 252> bytes{};
    test::random random{5};
    random.fill(bytes);
    for (std::size_t count = 0; count <= 126; ++count) {
        CAPTURE(count);
        read_holding_registers_response const response{register_view{byte_view{bytes}.first(2 * count)}};
        if (count >= 1 and count <= 125) {
            CHECK(survives(response, [&](auto const& read) {
                return read.registers == response.registers and read.registers.size() == count;
            }));
        } else {
            CHECK(is_refused(response, errc::invalid_quantity));
        }
    }
}
