// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Function 23 at every quantity and every size, both halves.
#include <rtuwire/wire/registers.hpp>

#include <array>

#include "support/encode_space.hpp"
#include "support/proof.hpp"
#include "support/random.hpp"

using namespace rtuwire;
using namespace rtuwire::detail;
using rtuwire::test::is_refused;
using rtuwire::test::needs_room;
using rtuwire::test::survives;

namespace {

constexpr bool needs_its_room()
{
    register_block const values{0x000F, 0x05DC, 0x0000};
    return needs_room(read_write_multiple_registers{12741, 3, 12761, values}, 19) and
           needs_room(read_write_multiple_registers_response{values}, 11);
}
PROOF("a frame of function 23 needs all of its bytes", needs_its_room)

constexpr bool reads_1_to_125()
{
    register_block const values{0x000F};
    for (std::uint32_t count = 0; count <= 127; ++count) {
        read_write_multiple_registers const both{1, static_cast<std::uint16_t>(count), 2, values};
        bool const is_right = count >= 1 and count <= 125
                                  ? survives(both, [&](auto const& read) { return read == both; })
                                  : is_refused(both, errc::invalid_quantity);
        if (not is_right) {
            return false;
        }
    }
    return true;
}
PROOF("function 23 reads 1 to 125 registers", reads_1_to_125)

constexpr bool keeps_its_fields_apart()
{
    register_block const values{0x0506, 0x0708};
    read_write_multiple_registers const both{0x0102, 3, 0x0304, values};
    return survives(both, [](read_write_multiple_registers<> const& read) {
        using test::is;
        return is(read.read_start == 0x0102, "read_start") and is(read.read_count == 3, "read_count") and
               is(read.write_start == 0x0304, "write_start") and is(read.values.size() == 2, "two values") and
               is(read.values[0] == 0x0506, "the first value") and is(read.values[1] == 0x0708, "the second value");
    });
}
PROOF("the two halves of function 23 are not taken for each other", keeps_its_fields_apart)

struct sample {
    std::array<std::byte, 268> bytes{};

    explicit constexpr sample(std::uint32_t seed) { test::random{seed}.fill(bytes); }
    [[nodiscard]] constexpr register_view registers(std::size_t count) const
    {
        return register_view{byte_view{bytes}.first(2 * count)};
    }
};

} // namespace

TEST_CASE("function 23 writes 1 to 121 registers, and nothing else is written")
{
    sample const some{23};
    for (std::size_t count = 0; count <= 122; ++count) {
        CAPTURE(count);
        read_write_multiple_registers const both{3201, 125, 8501, some.registers(count)};
        if (count >= 1 and count <= 121) {
            CHECK(survives(both, [&](auto const& read) { return read == both; }));
        } else {
            CHECK(is_refused(both, errc::invalid_quantity));
        }
    }
}

TEST_CASE("neither half of function 23 runs past register 65535")
{
    sample const some{24};
    for (std::size_t count = 2; count <= 121; ++count) {
        CAPTURE(count);
        auto const last = static_cast<std::uint16_t>(65536 - count);
        auto const past = static_cast<std::uint16_t>(last + 1);
        auto const quantity = static_cast<std::uint16_t>(count);
        auto const values = some.registers(count);
        using both = read_write_multiple_registers<>;
        CHECK(both{last, quantity, last, values}.check() == errc::none);
        CHECK(is_refused(both{past, quantity, last, values}, errc::invalid_address_range));
        CHECK(is_refused(both{last, quantity, past, values}, errc::invalid_address_range));
    }
}

TEST_CASE("a request of function 23 is read only when quantity, byte count and size agree")
{
    sample pdu{25};
    pdu.bytes[0] = std::byte{23};
    unsigned wrong = 0;
    for (std::uint32_t const reads : {0U, 1U, 125U, 126U, 256U}) {
        for (std::uint32_t const writes : {0U, 1U, 120U, 121U, 122U, 127U, 129U, 257U}) {
            for (std::uint32_t byte_count = 0; byte_count <= 255; ++byte_count) {
                pdu.bytes[3] = to_byte(reads >> 8U);
                pdu.bytes[4] = to_byte(reads);
                pdu.bytes[7] = to_byte(writes >> 8U);
                pdu.bytes[8] = to_byte(writes);
                pdu.bytes[9] = to_byte(byte_count);
                for (std::size_t size = 9 + byte_count; size <= 11 + byte_count; ++size) {
                    bool const is_legal = reads - 1 < 125 and writes - 1 < 121;
                    errc const expected = size != 10 + byte_count    ? errc::wrong_length
                                          : not is_legal             ? errc::invalid_quantity
                                          : byte_count != 2 * writes ? errc::wrong_length
                                                                     : errc::none;
                    test::exact_bytes const part{byte_view{pdu.bytes}.first(size)};
                    auto const read = read_write_multiple_registers<>::decode(part.view());
                    wrong += read.error() == expected ? 0U : 1U;
                }
            }
        }
    }
    CHECK(wrong == 0);
}

TEST_CASE("a response of function 23 holds 1 to 125 registers")
{
    sample const some{26};
    for (std::size_t count = 0; count <= 126; ++count) {
        CAPTURE(count);
        read_write_multiple_registers_response const response{some.registers(count)};
        if (count >= 1 and count <= 125) {
            CHECK(survives(response, [&](auto const& read) { return read.registers == response.registers; }));
        } else {
            CHECK(is_refused(response, errc::invalid_quantity));
        }
    }
}
