// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// When a cycle says the word that stops, how soon, and when it has no reason to.
#include <rtuwire/altivar/cyclic/cyclic.hpp>

#include "altivar/cyclic/cycle_by_hand.hpp"
#include "support/proof.hpp"

#include <rtuwire/altivar/atv12.hpp>

using namespace rtuwire;
using namespace rtuwire::altivar;
using namespace rtuwire::test;

namespace {

using cycle = cycle_by_hand<atv12::device>;

constexpr bool keeps_a_stop_that_was_not_said()
{
    cycle it; // the drive is one word away from running
    bool ok = it.begins(ready) and it.exchange(ready);
    it.loop.stop();
    ok = ok and not it.loop.run(1'500_rpm);
    return ok and it.asks_at_once() and it.says(0x0000);
}
PROOF("an order that is refused takes back no stop: its word goes at once", keeps_a_stop_that_was_not_said)

constexpr bool stops_at_once_behind_a_miss()
{
    cycle it;
    bool ok = it.runs() and it.asks();
    it.loop.stop(); // while an exchange is under way
    it.miss();
    ok = ok and it.asks_at_once() and it.says(0x0007);
    it.miss();
    return ok and it.asks_later() and it.says(0x0000);
}
PROOF("a stop does not wait behind a request that was missed; its own word goes once a period",
      stops_at_once_behind_a_miss)

constexpr bool looks_for_a_halt_at_once_behind_a_miss()
{
    cycle it;
    bool ok = it.runs() and it.asks();
    it.loop.stop(stop_by::halt);
    it.miss();
    return ok and it.asks_at_once() and it.reads(inputs_address, 4);
}
PROOF("nor does the look before a halt", looks_for_a_halt_at_once_behind_a_miss)

constexpr bool looks_a_period_behind_a_stop()
{
    cycle it;
    bool ok = it.runs();
    it.loop.stop();
    ok = ok and it.asks_at_once() and it.says(0x0007);
    it.confirm();
    return ok and it.asks_later() and it.reads(inputs_address, 4);
}
PROOF("a period behind the word that stops the drive is looked at", looks_a_period_behind_a_stop)

/// A motor that runs, of which two requests in a row were not answered, and its stop that is then taken.
constexpr bool is_stopped_in_a_loss(cycle& it)
{
    bool ok = it.runs() and it.fails() and it.fails() and it.loop.link_lost();
    ok = ok and it.asks() and it.says(0x0000);
    it.confirm();
    return ok and it.asks_at_once() and it.reads(eta_address);
}
constexpr bool looks_at_once_in_a_loss()
{
    cycle it;
    return is_stopped_in_a_loss(it);
}
PROOF("after a loss a running drive is told to stop, and looked at right behind that", looks_at_once_in_a_loss)

constexpr bool sees_it_stand_twice()
{
    cycle it;
    bool ok = is_stopped_in_a_loss(it) and it.is_known(running);
    ok = ok and it.asks_at_once() and it.looks_before(0x0007);
    it.confirm();
    ok = ok and it.exchange(running, 0) and it.asks_at_once() and it.looks_before(0x0007);
    it.confirm();
    return ok and it.exchange(running, 0) and it.asks_at_once() and it.says(0x0000);
}
PROOF("no power is taken from a motor before its speed was read as 0 twice; a status word alone "
      "tells no speed",
      sees_it_stand_twice)

/// A stop that a drive without power took, before it is looked at.
constexpr bool is_stopped_in_ready(cycle& it)
{
    bool ok = it.begins(ready) and it.exchange(ready);
    it.loop.stop();
    ok = ok and it.asks_at_once() and it.says(0x0000);
    it.confirm();
    return ok;
}
constexpr bool says_a_stop_again_where_it_is_lost()
{
    cycle it;
    bool const is_lost = is_stopped_in_ready(it) and it.fails() and it.fails() and it.loop.link_lost();
    return is_lost and it.asks() and it.says(0x0000);
}
PROOF("a stop whose drive is lost before it was read to rest is said again", says_a_stop_again_where_it_is_lost)

constexpr bool leaves_alone_what_rests()
{
    cycle it;
    bool ok = is_stopped_in_ready(it) and it.exchange() and it.exchange();
    ok = ok and it.fails() and it.fails() and it.loop.link_lost();
    return ok and it.asks() and it.reads(eta_address);
}
PROOF("a drive that was read to rest behind a stop is only looked at where it is lost", leaves_alone_what_rests)

constexpr bool leaves_alone_what_it_never_ordered()
{
    cycle it;
    bool ok = it.begins() and it.exchange() and it.fails() and it.fails() and it.loop.link_lost();
    return ok and it.asks() and it.reads(eta_address);
}
PROOF("a drive that was never ordered is only looked at where it is lost", leaves_alone_what_it_never_ordered)

constexpr bool says_nothing_to_who_never_answered()
{
    cycle it;
    bool ok = true;
    for (unsigned i = 0; i < 6; ++i) {
        ok = ok and it.asks() and it.reads(eta_address);
        it.miss();
    }
    return ok;
}
PROOF("a drive that never answered hears no word, only looks", says_nothing_to_who_never_answered)

constexpr bool brings_down_by_single_words()
{
    cycle quick;
    bool ok = quick.begins() and quick.exchange(quick_stop_active);
    ok = ok and quick.asks() and quick.looks_before(0x0002);
    cycle strange;
    ok = ok and strange.begins(no_state);
    return ok and strange.asks() and strange.looks_before(0x0007);
}
PROOF("a quick stop that somebody began, and a state that nobody knows, are told to stop by single "
      "words: nothing is exchanged",
      brings_down_by_single_words)

constexpr bool takes_back_what_is_not_followed()
{
    cycle it{{.enable_timeout = milliseconds(250)}};
    bool ok = it.begins(ready) and it.loop.run(1'500_rpm);
    it.loop.advance(it.now); // the visit from which the limit counts
    ok = ok and it.asks() and it.exchanges(0x0007, 1'500);
    it.hear({ready, 0, 0, 0});
    ok = ok and it.asks() and it.reads(inputs_address, 4);
    it.hear({ready, 0, 0, 0});
    return ok and it.asks() and it.exchanges(0x0000, 0);
}
PROOF("a word that was not followed in time is taken back, and the reference with it", takes_back_what_is_not_followed)

constexpr bool runs_again_from_where_it_fell()
{
    cycle it;
    bool ok = it.runs() and it.exchange(running | with_stop_key, 1'500);
    ok = ok and it.asks_at_once() and it.looks_before(0x0007);
    it.confirm();
    ok = ok and it.asks_later() and it.reads(eta_address) and it.is_known(ready | with_stop_key);
    ok = ok and it.loop.run(1'500_rpm);
    return ok and it.asks() and it.exchanges(0x0007, 1'500);
}
PROOF("an order behind a stop that led to ready goes on from there, although the stop's word was "
      "the same",
      runs_again_from_where_it_fell)

constexpr bool stops_its_own_motor_where_the_scanner_moved()
{
    cycle it;
    bool ok = it.begins() and it.enables() and it.fails(); // the command to run may have arrived
    ok = ok and it.asks() and it.reads(eta_address);
    ok = ok and it.is_known(running, 100, {cmd_address, 8'503, 0, 0});
    ok = ok and it.loop.control().reason().kind == outcome_kind::misconfigured;
    return ok and it.asks_at_once() and it.says(0x0000);
}
PROOF("a motor that was ordered, and whose scanner stands for other words then, is told to stop at "
      "once",
      stops_its_own_motor_where_the_scanner_moved)

constexpr bool leaves_another_masters_motor()
{
    cycle it;
    bool ok = it.asks() and it.is_known(running, 100, {cmd_address, 8'503, 0, 0});
    ok = ok and it.loop.control().reason().kind == outcome_kind::misconfigured;
    return ok and it.asks_later() and it.reads(eta_address);
}
PROOF("a motor that somebody else runs hears nothing where its scanner stands for other words",
      leaves_another_masters_motor)

} // namespace
