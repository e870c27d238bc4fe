// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Function 16 at every quantity and every size, both directions.
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
    return needs_room(write_multiple_registers{9001, register_block{0x0014, 0x001E}}, 13) and
           needs_room(write_multiple_registers_response{9001, 2}, 8);
}
PROOF("a frame of function 16 needs all of its bytes", needs_its_room)

constexpr bool confirms_1_to_123()
{
    for (std::uint32_t count = 0; count <= 125; ++count) {
        write_multiple_registers_response const response{400, static_cast<std::uint16_t>(count)};
        bool const is_right = count >= 1 and count <= 123
                                  ? survives(response, [&](auto const& read) { return read == response; })
                                  : is_refused(response, errc::invalid_quantity);
        if (not is_right) {
            return false;
        }
    }
    return true;
}
PROOF("a response of function 16 confirms 1 to 123 registers", confirms_1_to_123)

struct sample {
    std::array<std::byte, 264> bytes{};

    explicit constexpr sample(std::uint32_t seed) { test::random{seed}.fill(bytes); }
    [[nodiscard]] constexpr register_view registers(std::size_t count) const
    {
        return register_view{byte_view{bytes}.first(2 * count)};
    }
};

} // namespace

TEST_CASE("function 16 writes 1 to 123 registers, and nothing else is written")
{
    sample const some{16};
    for (std::size_t count = 0; count <= 124; ++count) {
        CAPTURE(count);
        write_multiple_registers const tell{8501, some.registers(count)};
        if (count >= 1 and count <= 123) {
            CHECK(survives(tell, [&](auto const& read) { return read == tell and read.values.size() == count; }));
        } else {
            CHECK(is_refused(tell, errc::invalid_quantity));
        }
    }
}

TEST_CASE("function 16 writes nothing past register 65535")
{
    sample const some{17};
    for (std::size_t count = 1; count <= 123; ++count) {
        CAPTURE(count);
        auto const last = static_cast<std::uint16_t>(65536 - count);
        CHECK(write_multiple_registers{last, some.registers(count)}.check() == errc::none);
        if (count > 1) {
            auto const past = static_cast<std::uint16_t>(last + 1);
            CHECK(is_refused(write_multiple_registers{past, some.registers(count)}, errc::invalid_address_range));
        }
    }
}

TEST_CASE("a request of function 16 is read only when quantity, byte count and size agree")
{
    sample pdu{18};
    pdu.bytes[0] = std::byte{16};
    unsigned wrong = 0;
    for (std::uint32_t quantity : {0U, 1U, 2U, 122U, 123U, 124U, 127U, 128U, 129U, 256U, 257U}) {
        for (std::uint32_t byte_count = 0; byte_count <= 255; ++byte_count) {
            for (std::size_t size = 1; size <= pdu.bytes.size(); ++size) {
                pdu.bytes[3] = to_byte(quantity >> 8U);
                pdu.bytes[4] = to_byte(quantity);
                pdu.bytes[5] = to_byte(byte_count);
                test::exact_bytes const part{byte_view{pdu.bytes}.first(size)};
                errc const expected = size < 6 or size != 6 + byte_count ? errc::wrong_length
                                      : quantity == 0 or quantity > 123  ? errc::invalid_quantity
                                      : byte_count != 2 * quantity       ? errc::wrong_length
                                                                         : errc::none;
                auto const read = write_multiple_registers<>::decode(part.view());
                wrong += read.error() == expected ? 0U : 1U;
            }
        }
    }
    CHECK(wrong == 0);
}
