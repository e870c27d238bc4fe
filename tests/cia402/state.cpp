// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// The status word: of the 128 values of bits 0 to 6 exactly 24 tell one state, and none tells two.
#include <rtuwire/cia402/state.hpp>

#include "support/proof.hpp"

using namespace rtuwire;
using namespace rtuwire::cia402;
using namespace rtuwire::detail;

namespace {

constexpr bool tells_one_state_or_none()
{
    unsigned known = 0;
    for (std::uint16_t word = 0; word < 128; ++word) {
        unsigned hits = 0;
        for (auto const& each : state_patterns) {
            hits += (word & each.mask) == each.value ? 1U : 0U;
        }
        if (hits > 1 or (hits == 1) != (decode(word) != state::unknown)) {
            return false;
        }
        known += hits;
    }
    return known == 24;
}
PROOF("24 of 128 words tell one state, 104 none", tells_one_state_or_none)

constexpr bool ignores_the_other_bits()
{
    for (std::uint32_t high = 0; high < 0x200; ++high) {
        auto const word = static_cast<std::uint16_t>((high << 7U) | 0x37U);
        if (decode(word) != state::operation_enabled) {
            return false;
        }
    }
    return true;
}
PROOF("bits 7 to 15 say nothing of the state", ignores_the_other_bits)

constexpr bool shows_what_it_decodes()
{
    for (auto const& each : state_patterns) {
        if (decode(status_bits(each.meaning)) != each.meaning or
            decode(status_bits(each.meaning) | 0x10U) != each.meaning) {
            return false;
        }
    }
    return status_bits(state::unknown) == 0;
}
PROOF("what a state shows decodes to it, with bit 4 of either sense", shows_what_it_decodes)

// The manuals' words, and those seen on drives.
STATIC_CHECK(decode(0x0250) == state::switch_on_disabled);
STATIC_CHECK(decode(0x0231) == state::ready_to_switch_on);
STATIC_CHECK(decode(0x0233) == state::switched_on);
STATIC_CHECK(decode(0x0237) == state::operation_enabled);
STATIC_CHECK(decode(0x8637) == state::operation_enabled);
STATIC_CHECK(decode(0x0017) == state::quick_stop_active);
STATIC_CHECK(decode(0x0218) == state::fault and decode(0x0038) == state::fault);
STATIC_CHECK(decode(0x0240) == state::switch_on_disabled); // an ATV28 with mains
STATIC_CHECK(decode(0x0001) == state::unknown and decode(0x0022) == state::unknown);

STATIC_CHECK(name_of(state::operation_enabled) == literal{"operation enabled"});
STATIC_CHECK(name_of(state::unknown) == literal{"unknown"});
STATIC_CHECK(has_power(state::quick_stop_active) and not has_power(state::switched_on));

/// Bits 6 to 0 as the manuals print them, bit 4 aside; whether the motor may have power; whether there is a fault.
struct printed {
    state which;
    std::uint16_t bits;
    bool has_power;
    bool is_in_fault;
};
constexpr printed table[]{{state::unknown, 0x00, false, false},
                          {state::not_ready_to_switch_on, 0x00, false, false},
                          {state::switch_on_disabled, 0x40, false, false},
                          {state::ready_to_switch_on, 0x21, false, false},
                          {state::switched_on, 0x23, false, false},
                          {state::operation_enabled, 0x27, true, false},
                          {state::quick_stop_active, 0x07, true, false},
                          {state::fault_reaction_active, 0x2F, true, true},
                          {state::fault, 0x28, false, true}};
constexpr bool is_as_printed()
{
    for (printed const& each : table) {
        if (status_bits(each.which) != each.bits or has_power(each.which) != each.has_power or
            is_in_fault(each.which) != each.is_in_fault) {
            return false;
        }
    }
    return true;
}
PROOF("each state shows its bits, and says whether there is power and whether a fault", is_as_printed)

} // namespace
