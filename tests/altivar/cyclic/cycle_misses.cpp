// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// What a cycle asks behind a request that was not answered, behind a loss, and behind what it cannot believe.
#include <rtuwire/altivar/cyclic/cyclic.hpp>

#include "altivar/cyclic/cycle_by_hand.hpp"
#include "support/proof.hpp"

#include <rtuwire/altivar/atv12.hpp>

using namespace rtuwire;
using namespace rtuwire::altivar;
using namespace rtuwire::test;

namespace {

using cycle = cycle_by_hand<atv12::device>;

constexpr bool is_lost_at_once_by(errc why)
{
    cycle it{{.tolerated_misses = 200}};
    bool const is_lost = it.begins() and it.exchange() and it.fails(why) and it.loop.link_lost();
    return is_lost and it.loop.control().reason().error == why;
}
constexpr bool tolerates_no_end()
{
    return is_lost_at_once_by(errc::unit_lost) and is_lost_at_once_by(errc::too_many_ordered);
}
PROOF("a unit that the client calls lost, or has no place for, is lost at once", tolerates_no_end)

constexpr bool goes_on_without_an_order()
{
    cycle it;
    bool ok = it.begins() and it.exchange() and it.fails();
    return ok and it.asks_later() and it.exchanges(0x0000, 0);
}
PROOF("a miss that is tolerated is followed by an exchange where nothing is ordered", goes_on_without_an_order)

constexpr bool goes_on_running()
{
    cycle it;
    bool ok = it.runs() and it.fails();
    ok = ok and it.asks_later() and it.reads(eta_address);
    it.hear({running});
    ok = ok and it.asks() and it.reads(lft_address);
    it.hear({0});
    return ok and it.asks() and it.exchanges(0x000F, 1'500);
}
PROOF("and where the motor runs, by a look at it, then with its order", goes_on_running)

constexpr bool says_a_missed_word_again()
{
    cycle it;
    bool ok = it.begins(ready) and it.loop.run(1'500_rpm) and it.asks();
    ok = ok and it.exchanges(0x0007, 1'500);
    it.miss();
    ok = ok and it.asks_later() and it.reads(eta_address) and not it.loop.link_lost();
    ok = ok and it.is_known(ready);
    return ok and it.asks_at_once() and it.exchanges(0x0007, 1'500);
}
PROOF("on the way up a drive is looked at and checked behind a miss; the word that was not answered "
      "goes again",
      says_a_missed_word_again)

constexpr bool loses_no_link_by_a_look()
{
    cycle it;
    bool ok = it.begins(ready) and it.loop.run(1'500_rpm) and it.fails() and it.asks();
    it.hear({ready});
    return ok and not it.loop.link_lost() and it.loop.control().is_ordered();
}
PROOF("the look behind a miss that is tolerated loses neither link nor order", loses_no_link_by_a_look)

constexpr bool says_no_taken_word_again()
{
    cycle it;
    bool ok = it.begins(ready) and it.loop.run(1'500_rpm) and it.asks();
    it.hear({ready, 0, 0, 0});
    for (unsigned i = 0; i < 3; ++i) {
        ok = ok and it.asks_later() and it.reads(inputs_address, 4);
        it.hear({ready, 0, 0, 0});
    }
    return ok;
}
PROOF("a word that was taken and not followed is not said again: the drive is only looked at", says_no_taken_word_again)

constexpr bool reads_back_again_behind_a_miss()
{
    cycle it;
    bool ok = it.begins() and it.enables() and it.asks() and it.exchanges(0x000F, 1'500);
    it.miss();
    ok = ok and it.asks_later() and it.reads(eta_address) and it.is_known(switched_on);
    ok = ok and it.asks_at_once();
    if (it.exchanges(0x0007, 1'500)) { // it may say this again before
        it.hear({switched_on, 0, 0, 0});
        ok = ok and it.asks();
    }
    return ok and it.reads(cmd_address);
}
PROOF("a command to run that was missed goes no second time before the control word was read anew",
      reads_back_again_behind_a_miss)

constexpr bool yields_for_good()
{
    cycle it;
    bool ok = it.begins(ready) and it.loop.run(1'500_rpm) and it.fails(errc::overruled);
    ok = ok and not it.loop.control().is_ordered() and it.fails() and it.fails();
    ok = ok and it.loop.link_lost();
    return ok and it.asks() and it.reads(eta_address);
}
PROOF("a drive that another's stop has, short of running, hears no word of the cycle where it is "
      "lost later",
      yields_for_good)

constexpr bool reads_all_anew_behind_a_zero()
{
    cycle it;
    bool ok = it.begins() and it.exchange() and it.exchange(0);
    ok = ok and it.asks_at_once() and it.reads(eta_address) and not it.loop.run(1'500_rpm);
    ok = ok and it.is_known(switch_on_disabled);
    return ok and it.asks_at_once() and it.exchanges(0x0000, 0);
}
PROOF("a status of 0 in an exchange may be a drive that was switched on, or a scanner that moved: "
      "all is read anew, at once",
      reads_all_anew_behind_a_zero)

/// Whether an order goes on whose first command, or command to run, was lost on its way, while 0007 stands in the drive.
constexpr bool goes_on_from(std::uint16_t status, bool was_enabling)
{
    cycle it;
    bool ok = it.begins(was_enabling ? switch_on_disabled : status);
    ok = ok and (was_enabling ? it.enables() : it.loop.run(1'500_rpm)) and it.fails();
    ok = ok and it.asks() and it.is_known(switched_on) and it.asks() and it.exchanges(0x0007, 1'500);
    it.hear({switched_on, 0, 0, 0});
    ok = ok and it.asks() and it.reads(cmd_address);
    it.hear({0x0007});
    return ok and it.loop.control().is_ordered() and it.asks() and it.exchanges(0x000F, 1'500);
}
constexpr bool begins_its_way_anew()
{
    return goes_on_from(switch_on_disabled, true) and goes_on_from(switched_on, false) and goes_on_from(ready, false);
}
PROOF("an order goes on behind a command that was lost: it is said again, and nobody is blamed", begins_its_way_anew)

// The client tells a cycle that its unit was lost, whoever asked it.

constexpr bool stops_what_another_lost()
{
    cycle it;
    bool ok = it.runs();
    it.loop.note_loss();
    ok = ok and it.loop.link_lost() and not it.loop.control().is_ordered();
    ok = ok and it.loop.control().reason().error == errc::unit_lost;
    return ok and it.asks_at_once() and it.says(0x0000);
}
PROOF("a motor whose unit another conversation lost is told to stop at once", stops_what_another_lost)

constexpr bool takes_an_response_before_the_loss()
{
    cycle it;
    bool ok = it.runs() and it.asks();
    it.loop.note_loss(); // while an exchange is under way
    it.hear({running, 777, 0, 0});
    ok = ok and it.loop.speed() == 777 and it.loop.link_lost();
    ok = ok and it.loop.control().state() == cia402::state::unknown;
    return ok and it.asks_at_once() and it.says(0x0000);
}
PROOF("a loss that is told while a request is under way waits for what comes of it, and no longer",
      takes_an_response_before_the_loss)

constexpr bool heeds_a_loss_before_its_first_request()
{
    cycle it;
    it.loop.note_loss();
    return it.loop.control().reason().kind == outcome_kind::silent and it.asks_at_once() and it.reads(eta_address);
}
PROOF("a loss before the first request is heeded, too", heeds_a_loss_before_its_first_request)

} // namespace
