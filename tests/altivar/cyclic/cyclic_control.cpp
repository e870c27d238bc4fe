// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// What a cyclic controller commands, and when it drops an order.
#include <rtuwire/altivar/cyclic/cyclic_control.hpp>

#include <utility>

#include "support/proof.hpp"

using namespace rtuwire;
using namespace rtuwire::altivar;

namespace {

// Bit 9: under remote control. No state of CiA 402 has bit 0 alone.
constexpr std::uint16_t no_state = 0x0201;
constexpr std::uint16_t operation_enabled = 0x0237, switched_on = 0x0233, ready = 0x0231, fault = 0x0208;
constexpr std::uint16_t quick_stop_active = 0x0217, local = 0x0037;
constexpr std::uint16_t with_stop_key = 0x4000 | operation_enabled;

constexpr bool begins_with_nothing()
{
    cyclic_control const control;
    using test::is;
    return is(control.reference() == 0, "no reference") and is(control.status() == 0, "no status") and
           is(not control.is_ordered(), "no order") and is(not control.is_running(), "it does not run") and
           is(control.reason().kind == outcome_kind::pending, "nothing has ended") and
           is(control.reason().fault == 0, "no fault") and
           is(control.state() == cia402::state::unknown, "the state is not known");
}
PROOF("before anything is known or ordered it says so", begins_with_nothing)

/// An order at a drive with this status.
constexpr cyclic_control ordered(std::uint16_t status)
{
    cyclic_control control;
    control.note_status(status, false);
    static_cast<void>(control.run(100));
    return control;
}
constexpr bool is_dropped(cyclic_control const& control, outcome_kind kind)
{
    return not control.is_ordered() and control.reason().kind == kind;
}

constexpr bool says_nothing_to_who_was_not_heard()
{
    cyclic_control control;
    bool const is_silent =
        control.next_command() == 0 and not control.is_able() and not control.run(100) and control.next_command() == 0;
    control.note_loss(errc::timed_out);
    return is_silent and control.next_command() == 0 and not control.is_able();
}
PROOF("a drive that was not heard is commanded nothing", says_nothing_to_who_was_not_heard)

constexpr bool stops_who_was_lost_running()
{
    cyclic_control ramp;
    ramp.note_status(operation_enabled, false);
    cyclic_control quick = ramp;
    quick.stop(stop_by::quick_stop);
    ramp.note_loss(errc::timed_out);
    quick.note_loss(errc::timed_out);
    cyclic_control stood;
    stood.note_status(ready, false);
    stood.note_loss(errc::timed_out);
    return ramp.next_command() == 0x0007 and quick.next_command() == 0x0002 and stood.next_command() == 0 and
           not ramp.is_able();
}
PROOF("a drive that was lost with power is told to stop, in the way that was wanted", stops_who_was_lost_running)

constexpr bool ramps_down_what_may_turn()
{
    cyclic_control control;
    control.note_status(no_state, false);
    return control.next_command() == 0x0007 and not control.is_able();
}
PROOF("a state that nobody knows may be operation: its motor stops on the ramp", ramps_down_what_may_turn)

constexpr bool ends_no_quick_stop_under_way()
{
    cyclic_control control;
    bool is_kept = true;
    for (bool const stands : {false, true, false, true}) {
        control.note_status(quick_stop_active, stands);
        is_kept = is_kept and control.next_command() == 0x0002 and not control.is_able();
    }
    control.note_status(quick_stop_active, true);
    return is_kept and control.next_command() == 0 and not control.run(100);
}
PROOF("a quick stop goes on until the motor was seen to stand twice, whoever began it", ends_no_quick_stop_under_way)

constexpr bool stops_in_each_way()
{
    bool ok = true;
    for (auto const& [kind, word] : {std::pair{stop_by::ramp, 0x0007}, std::pair{stop_by::quick_stop, 0x0002},
                                     std::pair{stop_by::freewheel, 0x0000}, std::pair{stop_by::halt, 0x010F}}) {
        cyclic_control control = ordered(operation_enabled);
        control.stop(kind);
        ok = ok and control.next_command() == word and not control.is_ordered() and not control.run(100);
        control.note_status(operation_enabled, true);
        control.note_status(operation_enabled, true);
        // At rest a drive needs no power; only a halt keeps it, and can be ended by an order.
        ok = ok and control.next_command() == (kind == stop_by::halt ? 0x010F : 0);
        ok = ok and control.run(100) == (kind == stop_by::halt);
    }
    return ok;
}
PROOF("a stop takes the order away, and is over once the motor stands", stops_in_each_way)

constexpr bool freewheels_on()
{
    cyclic_control control = ordered(operation_enabled);
    control.stop(stop_by::freewheel);
    control.stop(stop_by::ramp);
    return control.next_command() == 0;
}
PROOF("a freewheel is not made less by another stop", freewheels_on)

constexpr bool is_refused_in_local_control()
{
    cyclic_control control;
    control.note_status(local, false);
    bool const is_refused = not control.is_able() and not control.run(100);
    cyclic_control running = ordered(operation_enabled);
    running.note_status(local, false);
    return is_refused and is_dropped(running, outcome_kind::local_control);
}
PROOF("local control refuses an order, and drops one", is_refused_in_local_control)

constexpr bool drops_when_the_drive_falls_back()
{
    cyclic_control control = ordered(operation_enabled);
    control.note_status(ready, false);
    cyclic_control enabling = ordered(ready);
    enabling.note_status(switched_on, false);
    return is_dropped(control, outcome_kind::fell_back) and enabling.is_ordered();
}
PROOF("a drive that falls back has lost its order", drops_when_the_drive_falls_back)

constexpr bool drops_where_nobody_here_told_it_to_run()
{
    cyclic_control told = ordered(switched_on);
    bool const goes_up = told.next_command() == 0x0007; // as often as it is found there
    told.note_status(switched_on, false);
    cyclic_control early = told;
    early.note_status(operation_enabled, false);
    bool const runs = told.next_command() == 0x000F;
    told.note_status(switched_on, false); // it follows later
    told.note_status(operation_enabled, false);
    return goes_up and runs and told.is_ordered() and is_dropped(early, outcome_kind::overwritten);
}
PROOF("a drive that runs without having been told to has lost its order", drops_where_nobody_here_told_it_to_run)

constexpr bool drops_at_the_stop_key()
{
    cyclic_control control = ordered(operation_enabled);
    control.note_status(with_stop_key, false);
    // Pressed before the order, let go, and pressed again.
    cyclic_control again = ordered(with_stop_key);
    again.note_status(with_stop_key, false);
    bool const was_before = again.is_ordered();
    again.note_status(operation_enabled, false);
    bool const is_still = again.is_ordered();
    again.note_status(with_stop_key, false);
    return is_dropped(control, outcome_kind::stop_key) and was_before and is_still and
           is_dropped(again, outcome_kind::stop_key);
}
PROOF("the stop key drops an order, but not one that was given while it was pressed", drops_at_the_stop_key)

constexpr bool says_why_without_an_order()
{
    cyclic_control control;
    control.note_loss(errc::timed_out);
    bool const is_silent = control.reason().kind == outcome_kind::silent and
                           control.reason().error == errc::timed_out and control.reason().fault == 0;
    control.note_status(fault, false);
    return is_silent and control.reason().kind == outcome_kind::silent;
}
PROOF("the first reason stands, with or without an order", says_why_without_an_order)

constexpr bool resets_by_an_edge()
{
    cyclic_control control;
    control.note_status(fault, false);
    bool const is_idle = control.next_command() == 0;
    control.reset_fault();
    bool const is_edge = control.next_command() == 0x0000 and control.next_command() == 0x0080 and
                         control.next_command() == 0x0000 and control.next_command() == 0x0000;
    control.note_status(ready, false);
    control.reset_fault(); // no fault, nothing to reset
    return is_idle and is_edge and control.next_command() == 0 and control.next_command() == 0;
}
PROOF("a fault is reset by a word without the bit, one with it and one without", resets_by_an_edge)

constexpr bool forgets_a_reset()
{
    cyclic_control lost;
    lost.note_status(fault, false);
    lost.reset_fault();
    cyclic_control misconfigured = lost;
    lost.note_loss(errc::timed_out);
    misconfigured.note_finding(outcome_kind::misconfigured);
    bool ok = true;
    for (unsigned i = 0; i < 4; ++i) {
        ok = ok and lost.next_command() == 0 and misconfigured.next_command() == 0;
    }
    return ok;
}
PROOF("no reset goes on after a loss, or where the words are not the drive's", forgets_a_reset)

} // namespace
