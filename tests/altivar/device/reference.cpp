// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// The words of a reference: what it is in the other direction, for any word.
#include <rtuwire/altivar/device/reference.hpp>

#include "support/catch.hpp"
#include "support/proof.hpp"

using namespace rtuwire;
using namespace rtuwire::altivar;

namespace {

constexpr std::uint16_t turned(std::uint16_t word) { return reference_write{1, word}.reversed().word; }
constexpr std::uint16_t kept(std::uint16_t word, std::uint16_t status)
{
    return reference_write{1, word}.keeping(status).word;
}

STATIC_CHECK(turned(1'500) == 0xFA24 and turned(0xFA24) == 1'500);
STATIC_CHECK(turned(0) == 0xFFFF and turned(0xFFFF) == 1);           // 0 has no sign, and one count has
STATIC_CHECK(turned(0x7FFF) == 0x8001 and turned(0x8000) == 0x7FFF); // -32768 has no counterpart
STATIC_CHECK(kept(0, 0x8237) == 0xFFFF and kept(0, 0x0237) == 0);
STATIC_CHECK(kept(300, 0x8237) == 300 and kept(0xFED4, 0x0237) == 0xFED4);
STATIC_CHECK(reference_write{1, 0xFFFF, true}.at_least(3).word == 0xFFFD);
STATIC_CHECK(reference_write{1, 0xFFFD, true}.at_least(3).word == 0xFFFD);
STATIC_CHECK(reference_write{1, 0xFFFC, true}.at_least(3).word == 0xFFFC);
STATIC_CHECK(reference_write{1, 1, true}.at_least(3).word == 1 and reference_write{1, 0, true}.at_least(3).word == 0);
STATIC_CHECK(reference_write{1, 0xFFFF}.at_least(3).word == 0xFFFF); // 0.1 Hz
STATIC_CHECK(reference_write{1, 0}.under(0x080F).word == 0xFFFF and reference_write{1, 0}.under(0x000F).word == 0);

} // namespace

TEST_CASE("every word of a reference is of the other direction when it is turned round")
{
    unsigned wrong = 0;
    for (unsigned word = 0; word <= 0xFFFF; ++word) {
        auto const given = static_cast<std::uint16_t>(word);
        bool const is_back = static_cast<std::int16_t>(given) < 0;
        bool const is_back_turned = static_cast<std::int16_t>(turned(given)) < 0;
        wrong += is_back == is_back_turned ? 1U : 0U;
    }
    CHECK(wrong == 0);
}
