// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// What a cyclic controller commands a drive that it does not know, or whose state it does not.
#include <rtuwire/altivar/cyclic_control.hpp>

#include "support/proof.hpp"

using namespace rtuwire;
using namespace rtuwire::altivar;

namespace {

// Bit 9: under remote control. No state of CiA 402 has bit 0 alone.
constexpr std::uint16_t no_state = 0x0201;
constexpr std::uint16_t operation_enabled = 0x0237;

constexpr bool says_nothing_to_who_was_not_heard()
{
    cyclic_control control;
    bool const is_silent = control.next_command() == 0 and not control.is_able() and
                           not control.run(100, false) and control.next_command() == 0;
    control.note_status(operation_enabled);
    control.note_loss(errc::timed_out);
    return is_silent and control.next_command() == 0 and not control.is_able();
}
PROOF("a drive that was not heard, or is lost, is commanded nothing",
      says_nothing_to_who_was_not_heard)

constexpr bool ramps_down_what_may_turn()
{
    cyclic_control control;
    control.note_status(no_state);
    return control.next_command() == 0x0007 and not control.is_able();
}
PROOF("a state that nobody knows may be operation: its motor stops on the ramp",
      ramps_down_what_may_turn)

} // namespace
