// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Function 22: every size; every bit by the specification's rule.
#include <rtuwire/wire/registers.hpp>

#include "support/golden.hpp"
#include "support/pdu_facts.hpp"
#include "support/proof.hpp"

#include <rtuwire/core/hex.hpp>

using namespace rtuwire;

namespace {

constexpr bool has_seven_bytes()
{
    for (unsigned const number : {0x0000U, 0x0001U, 0x8000U, 0xFFFFU}) {
        auto const word = static_cast<std::uint16_t>(number);
        if (not test::goes_there_and_back(mask_write_register{word, 0x00F2, 0x0025}) or
            not test::goes_there_and_back(mask_write_register{4, word, 0x0025}) or
            not test::goes_there_and_back(mask_write_register{4, 0x00F2, word})) {
            return false;
        }
    }
    return test::has_size<mask_write_register>("16 00 04 00 F2 00 25 00 00"_hex, 7);
}
PROOF("function 22 has seven bytes, with any address and any masks", has_seven_bytes)

constexpr auto printed = "16 00 04 00 F2 00 25"_hex;
STATIC_CHECK(mask_write_register::decode(printed) == mask_write_register{4, 0x00F2, 0x0025});
STATIC_CHECK(mask_write_register{4, 0x00F2, 0x0025}.applied_to(0x0012) == 0x0017);
STATIC_CHECK(mask_write_register::decode("15 00 04 00 F2 00 25"_hex) == errc::wrong_function);
STATIC_CHECK(test::encodes(unit_id{1}, mask_write_register{4, 0x00F2, 0x0025}, "01 16 00 04 00 F2 00 25 67 EE"_hex));

/// Bit by bit: a bit whose AND mask is 1 stays, any other becomes that of the OR mask.
constexpr bool masks_each_bit()
{
    for (unsigned bit = 0; bit < 16; ++bit) {
        for (unsigned each = 0; each < 8; ++each) {
            auto const in_bit = [&](unsigned from) { return static_cast<std::uint16_t>(((each >> from) & 1U) << bit); };
            mask_write_register const mask{0, in_bit(0), in_bit(1)};
            unsigned const becomes = (each & 1U) != 0 ? (each >> 2U) & 1U : (each >> 1U) & 1U;
            if (mask.applied_to(in_bit(2)) != becomes << bit) {
                return false;
            }
        }
    }
    return mask_write_register{0, 0, 0xBEEF}.applied_to(0x1234) == 0xBEEF and
           mask_write_register{0, 0xFFFF, 0xBEEF}.applied_to(0x1234) == 0x1234;
}
PROOF("function 22 keeps each bit of its AND mask, and sets the others by its OR mask", masks_each_bit)

} // namespace
