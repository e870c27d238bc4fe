// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// A start whose requests go without a response, or that finds the drive otherwise than it left it: what it says next,
// and what it takes back.
#include "support/commissioned.hpp"
#include "support/proof.hpp"

#include <rtuwire/altivar/atv320.hpp>
#include <rtuwire/altivar/procedure/commissioning/restore_factory_settings.hpp>
#include <rtuwire/altivar/procedure/motion/change_reference.hpp>
#include <rtuwire/altivar/procedure/motion/direct_control.hpp>
#include <rtuwire/altivar/procedure/motion/start.hpp>

using namespace rtuwire;
using namespace rtuwire::altivar;
using kind = event::kind;

namespace {

constexpr std::uint16_t cmd = 8501, eta = 3201, rfr = 3202, lfrd = 8602;
constexpr std::uint16_t disabled = 0x0250, ready = 0x0231, on = 0x0233, enabled = 0x0237, ready_in_local = 0x0031,
                        enabled_and_there = 0x0637;
constexpr event begins{kind::begun}, written{kind::written}, goes_on{kind::pause_over};
constexpr event missed{kind::failed, 0, errc::timed_out};
constexpr event word(std::uint16_t read) { return {kind::word_read, read}; }

constexpr bool reads(action what, std::uint16_t address)
{
    return what_of(what) == action_kind::read and address_of(what) == address;
}
constexpr bool writes(action what, std::uint16_t address, std::uint16_t value)
{
    return what_of(what) == action_kind::write and address_of(what) == address and word_of(what) == value;
}

/// A start of a drive that was checked before, at 1500 rpm.
constexpr start_procedure started()
{
    supervision_procedure const check{atv320::device::layout, test::commissioned()};
    return start_procedure{atv320::device::layout, {lfrd, 1'500}, run_direction::forward, check};
}

/// Whether three requests may go without a response, each followed by a look, and the fourth takes back.
constexpr bool bears_three(start_procedure& it)
{
    bool ok = true;
    for (unsigned i = 0; i < 3; ++i) {
        ok = ok and reads(it.step(missed), eta);
    }
    return ok and writes(it.step(missed), cmd, 0x0000);
}

/// Up to the command to run, which was answered.
constexpr bool is_told_to_run(start_procedure& it)
{
    bool ok = reads(it.step(begins), eta) and writes(it.step(word(on)), cmd, 0x0007);
    ok = ok and reads(it.step(written), eta) and writes(it.step(word(on)), lfrd, 1'500);
    ok = ok and reads(it.step(written), lfrd) and reads(it.step(word(1'500)), cmd);
    ok = ok and writes(it.step(word(0x0007)), cmd, 0x000F);
    return ok and reads(it.step(written), 8401) and reads(it.step(word(1)), eta);
}

constexpr bool bears_three_misses()
{
    start_procedure first = started();
    bool ok = reads(first.step(begins), eta) and writes(first.step(word(ready)), cmd, 0x0007);
    ok = ok and bears_three(first);

    start_procedure heard = started();
    static_cast<void>(heard.step(begins));
    static_cast<void>(heard.step(word(ready)));
    ok = ok and reads(heard.step(missed), eta) and reads(heard.step(missed), eta);
    // The drive stands where it stood: the command that was not answered is given again, and the count begins anew.
    ok = ok and writes(heard.step(word(ready)), cmd, 0x0007) and bears_three(heard);

    start_procedure taken = started();
    static_cast<void>(taken.step(begins));
    static_cast<void>(taken.step(word(ready)));
    ok = ok and reads(taken.step(missed), eta) and writes(taken.step(word(ready)), cmd, 0x0007);
    return ok and reads(taken.step(written), eta) and bears_three(taken);
}
PROOF("on the way up a start bears three misses in a row, looks behind each and gives up at the "
      "fourth",
      bears_three_misses)

constexpr bool bears_one_behind_the_command_to_run()
{
    start_procedure it = started();
    bool ok = is_told_to_run(it) and reads(it.step(missed), eta);
    ok = ok and writes(it.step(missed), cmd, 0x0007); // the motor may turn by now: on its ramp
    it = started();
    ok = ok and is_told_to_run(it) and reads(it.step(missed), eta);
    return ok and what_of(it.step(word(enabled))) != action_kind::end; // what it runs at is looked at anew
}
PROOF("behind the command to run a start bears one miss, and the second brings the motor down its "
      "ramp",
      bears_one_behind_the_command_to_run)

constexpr bool gives_its_own_word_first()
{
    start_procedure it = started();
    // Somebody else brought the drive there: its word may be gone as soon as it is read.
    return reads(it.step(begins), eta) and writes(it.step(word(on)), cmd, 0x0007) and reads(it.step(written), eta) and
           writes(it.step(word(on)), lfrd, 1'500);
}
PROOF("a drive that is switched on already is told so by this start before it gets its reference",
      gives_its_own_word_first)

constexpr bool ramps_down_what_another_one_enabled()
{
    start_procedure it = started();
    bool ok = reads(it.step(begins), eta) and writes(it.step(word(ready)), cmd, 0x0007);
    return ok and reads(it.step(written), eta) and writes(it.step(word(enabled)), cmd, 0x0007);
}
PROOF("a motor that turns before it was told to is brought down its ramp", ramps_down_what_another_one_enabled)

constexpr bool leaves_local_control_alone()
{
    start_procedure it = started();
    bool ok = reads(it.step(begins), eta) and what_of(it.step(word(ready_in_local))) == action_kind::end;
    ok = ok and it.reason().kind == outcome_kind::local_control;

    supervision_procedure const check{atv28::device::layout, test::commissioned()};
    atv28::direct_start_procedure direct{{401, 200}, check};
    ok = ok and reads(direct.step(begins), atv28::device::layout.eta);
    ok = ok and what_of(direct.step(word(0x0040))) == action_kind::end;
    return ok and direct.reason().kind == outcome_kind::local_control;
}
PROOF("a drive in local control is told nothing by a start, whatever was found before", leaves_local_control_alone)

constexpr bool is_reached_at(std::uint16_t reference, bool looks_whether_it_turns)
{
    reference_procedure it{atv320::device::layout, {lfrd, reference}, beyond_limits::limit};
    bool ok = reads(it.step(begins), eta) and reads(it.step(word(enabled)), cmd);
    ok = ok and writes(it.step(word(0x000F)), lfrd, reference);
    ok = ok and what_of(it.step(written)) == action_kind::pause;
    for (action_kind const next : {action_kind::pause, action_kind::read}) {
        ok = ok and reads(it.step(goes_on), eta);
        action last = it.step(word(enabled_and_there));
        ok = ok and reads(last, rfr) == looks_whether_it_turns;
        last = looks_whether_it_turns ? it.step(word(1)) : last;
        ok = ok and what_of(last) == next;
    }
    ok = ok and reads(it.step(word(reference)), eta) and what_of(it.step(word(enabled_and_there))) == action_kind::end;
    return ok and it.reason().kind == outcome_kind::succeeded;
}
constexpr bool tells_standing_from_crawling() { return is_reached_at(0, false) and is_reached_at(1, true); }
PROOF("a change to 0 is done where the drive says twice that it is there, one to 1 rpm where it "
      "turns, too",
      tells_standing_from_crawling)

constexpr bool says_nothing_was_done()
{
    cmi_order_procedure it{atv320::device::layout, {.run_inputs = 0}, factory_order};
    bool ok = reads(it.step(begins), eta) and what_of(it.step({kind::late})) == action_kind::end;
    ok = ok and it.reason().kind == outcome_kind::aborted;
    cmi_order_procedure refused{atv320::device::layout, {.run_inputs = 0}, factory_order};
    static_cast<void>(refused.step(begins));
    ok = ok and reads(refused.step(word(disabled)), 8504);
    static_cast<void>(refused.step({kind::failed, 0, errc::illegal_data_address}));
    return ok and refused.reason().kind == outcome_kind::refused;
}
PROOF("factory settings that were not ordered yet are not said to be executed", says_nothing_was_done)

} // namespace
