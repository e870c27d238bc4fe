// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// The three forms of the CRC agree when they run, too.
#include <rtuwire/core/crc16.hpp>

#include <array>

#include "support/catch.hpp"
#include "support/random.hpp"

using namespace rtuwire;

TEST_CASE("the forms agree on random frames of every length")
{
    test::random random{11};
    std::array<std::byte, 256> octets{};
    for (std::size_t size = 0; size <= octets.size(); ++size) {
        random.fill(octets);
        std::uint16_t bitwise = 0xFFFF, nibbles = 0xFFFF;
        for (std::size_t i = 0; i < size; ++i) {
            bitwise = crc16_step<crc_form::bitwise>(bitwise, octets[i]);
            nibbles = crc16_step<crc_form::nibble_table>(nibbles, octets[i]);
        }
        std::uint16_t const bytes = crc16(byte_view{octets}.first(size));
        REQUIRE(bitwise == bytes);
        REQUIRE(nibbles == bytes);
    }
}
