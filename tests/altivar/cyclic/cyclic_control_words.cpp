// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// The words of a cyclic controller, by the status words that it hears: upward, downward, and in a fault.
#include <rtuwire/altivar/cyclic/cyclic_control.hpp>

#include <array>

#include "altivar/cyclic/cycle_by_hand.hpp"
#include "support/proof.hpp"

using namespace rtuwire;
using namespace rtuwire::detail;
using namespace rtuwire::altivar;
using namespace rtuwire::test;

namespace {

/// A drive that was read so.
constexpr cyclic_control heard(std::uint16_t status, bool stands = false)
{
    cyclic_control control;
    control.note_status(status, stands);
    return control;
}
constexpr cyclic_control ordered(std::uint16_t status)
{
    cyclic_control control = heard(status);
    static_cast<void>(control.run(100));
    return control;
}
constexpr cyclic_control stopped(std::uint16_t status, stop_by how)
{
    cyclic_control control = ordered(status);
    control.stop(how);
    return control;
}
/// Whether its next words, without anything heard, are these.
template <std::size_t Count> constexpr bool says(cyclic_control& control, std::array<std::uint16_t, Count> const& words)
{
    bool ok = true;
    for (std::uint16_t const word : words) {
        ok = ok and control.next_command() == word;
    }
    return ok;
}

constexpr bool tells_nothing_unheard()
{
    cyclic_control control;
    bool const is_new =
        control.take_power() == power_seen::nothing and not control.take_fault() and not control.take_end_of_stop();
    control.note_loss(errc::timed_out);
    return is_new and control.take_power() == power_seen::nothing and not control.take_fault() and
           not control.take_end_of_stop();
}
PROOF("of a drive that was never heard neither rest, nor a fault, nor an end of a stop is told", tells_nothing_unheard)

constexpr bool tells_a_fault_once()
{
    cyclic_control control = heard(in_fault);
    bool ok = control.take_fault() and not control.take_fault();
    control.note_status(in_fault, false);
    ok = ok and not control.take_fault();
    control.note_status(switch_on_disabled, false);
    ok = ok and not control.take_fault();
    control.note_status(in_fault, false);
    control.note_status(in_fault, false);
    return ok and control.take_fault() and not control.take_fault();
}
PROOF("each fault is told once, when it is new", tells_a_fault_once)

// Upward.

constexpr bool switches_on_itself()
{
    cyclic_control stops = stopped(running, stop_by::ramp);
    stops.note_status(switch_on_disabled, false);
    stops.note_status(switched_on, false); // somebody else led it here
    cyclic_control late = ordered(switched_on);
    late.note_late();
    bool ok = true;
    for (cyclic_control* each : {&stops, &late}) {
        ok = ok and each->run(100) and each->next_command() == 0x0007;
        each->note_status(switched_on, false);
        ok = ok and each->next_command() == 0x000F;
    }
    return ok;
}
PROOF("each order has its own 0007 before its 000F, although the drive is switched on already", switches_on_itself)

constexpr bool waits_for_a_slow_drive()
{
    cyclic_control control = ordered(switched_on);
    bool ok = control.next_command() == 0x0007;
    for (unsigned i = 0; i < 4; ++i) {
        control.note_status(switched_on, false);
        ok = ok and control.next_command() == 0x000F;
    }
    return ok;
}
PROOF("a drive that is slow to run is not told to disable operation meanwhile", waits_for_a_slow_drive)

constexpr bool is_not_able_after_a_finding()
{
    cyclic_control control = heard(ready);
    bool const was_able = control.is_able();
    control.note_finding(outcome_kind::misconfigured);
    return was_able and not control.is_able() and not control.run(100);
}
PROOF("no order is taken of a drive that was found wrong, before it was heard again", is_not_able_after_a_finding)

// Downward.

constexpr bool stops_harder()
{
    cyclic_control quicker = stopped(running, stop_by::ramp);
    quicker.stop(stop_by::quick_stop);
    cyclic_control freely = quicker;
    freely.stop(stop_by::freewheel);
    return quicker.next_command() == 0x0002 and freely.next_command() == 0x0000;
}
PROOF("a stop that is under way becomes the one that is asked for then", stops_harder)

constexpr bool stops_gently_after_a_freewheel()
{
    cyclic_control control = stopped(running, stop_by::freewheel);
    control.note_status(switch_on_disabled, false);
    bool const is_taken = control.run(100);
    control.note_status(running, false);
    control.stop(stop_by::ramp);
    return is_taken and control.next_command() == 0x0007;
}
PROOF("a freewheel that has come to its end makes no freewheel of the next stop", stops_gently_after_a_freewheel)

constexpr bool needs_two_looks_at_rest()
{
    cyclic_control control = heard(running, true);
    bool ok = control.next_command() == 0x0007;
    control.note_status(running, true);
    ok = ok and control.next_command() == 0x0000;
    control.note_loss(errc::timed_out);
    control.note_status(running, true);
    ok = ok and control.next_command() == 0x0007;
    control.note_status(running, true);
    return ok and control.next_command() == 0x0000;
}
PROOF("power is taken away where the motor was seen to stand twice, after a loss twice anew", needs_two_looks_at_rest)

/// Whether a stop has come to its end where this was read.
constexpr bool ends(stop_by how, std::uint16_t status, bool stands)
{
    cyclic_control control = stopped(running, how);
    control.note_status(status, stands);
    control.note_status(status, stands);
    return control.take_end_of_stop();
}
constexpr bool ends_where_one_word_does_not_run_it()
{
    constexpr auto ramp = stop_by::ramp;
    bool ok = true;
    for (std::uint16_t const low : {switch_on_disabled, not_ready, in_fault}) {
        ok = ok and ends(ramp, low, false);
    }
    for (std::uint16_t const high : {ready, switched_on, running, quick_stop_active, no_state}) {
        ok = ok and not ends(ramp, high, true);
    }
    return ok;
}
PROOF("a stop is over where no single word makes the drive run, or in a fault, and nowhere else",
      ends_where_one_word_does_not_run_it)

constexpr bool ends_a_halt_at_rest()
{
    return ends(stop_by::halt, running, true) and not ends(stop_by::halt, running, false);
}
PROOF("a halt is over once the motor stands, and not before", ends_a_halt_at_rest)

// In a fault.

constexpr bool resets_once()
{
    cyclic_control control = heard(in_fault);
    bool ok = control.reset_fault() and not control.reset_fault();
    ok = ok and says<10>(control, {0, 0x0080}); // and zeros
    return ok and control.reset_fault() and says<4>(control, {0, 0x0080});
}
PROOF("one order resets once, however long the fault stays; the next one resets again", resets_once)

constexpr bool resets_nothing_for_a_stop()
{
    cyclic_control idle = heard(in_fault);
    idle.note_overruled();
    cyclic_control resetting = heard(in_fault);
    bool ok = resetting.reset_fault();
    resetting.note_overruled();
    return ok and says<5>(idle, {}) and says<5>(resetting, {}) and not resetting.is_resetting();
}
PROOF("another's stop begins no reset, and ends one", resets_nothing_for_a_stop)

} // namespace
