// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Function 05: every value, every size.
#include <rtuwire/wire/bits.hpp>

#include "support/golden.hpp"
#include "support/pdu_facts.hpp"
#include "support/proof.hpp"

#include <rtuwire/core/hex.hpp>

using namespace rtuwire;
using namespace rtuwire::detail;

namespace {

constexpr bool switches_any_coil()
{
    for (unsigned const number : {0x0000U, 0x00ACU, 0x7FFFU, 0xFF00U, 0xFFFFU}) {
        auto const address = static_cast<std::uint16_t>(number);
        if (not test::goes_there_and_back(write_single_coil{address, true}) or
            not test::goes_there_and_back(write_single_coil{address, false})) {
            return false;
        }
    }
    return test::has_size<write_single_coil>("05 00 AC FF 00 00 00"_hex, 5);
}
PROOF("function 05 switches any coil on and off", switches_any_coil)

// The specification's example, and the same to everyone.
STATIC_CHECK(test::encodes(unit_id{1}, write_single_coil{172, true}, "01 05 00 AC FF 00 4C 1B"_hex));
STATIC_CHECK(test::encodes(broadcast, write_single_coil{172, false}, "00 05 00 AC 00 00 0C 3A"_hex));

} // namespace

TEST_CASE("of all 65536 values of function 05, FF00 is on, 0000 is off, and no other is read")
{
    unsigned wrong = 0;
    for (std::uint32_t value = 0; value <= 0xFFFF; ++value) {
        std::array<std::byte, 5> const pdu{std::byte{5}, {}, {}, to_byte(value >> 8U), to_byte(value)};
        auto const read = write_single_coil::decode(pdu);
        bool const is_right = value == 0xFF00 ? read and read->value
                              : value == 0    ? read and not read->value
                                              : read.error() == errc::malformed;
        wrong += is_right ? 0U : 1U;
    }
    CHECK(wrong == 0);
}
