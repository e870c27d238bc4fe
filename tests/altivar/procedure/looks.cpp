// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// What single words and failures make of the checks before an order, of a channel's set-up, and of an ATV28's link.
#include "support/commissioned.hpp"
#include "support/proof.hpp"

#include <rtuwire/altivar/atv12.hpp>
#include <rtuwire/altivar/atv28.hpp>
#include <rtuwire/altivar/atv310.hpp>
#include <rtuwire/altivar/atv320.hpp>
#include <rtuwire/altivar/procedure/commissioning/channel.hpp>
#include <rtuwire/altivar/procedure/commissioning/recall_from_eeprom.hpp>
#include <rtuwire/altivar/procedure/commissioning/release_link.hpp>
#include <rtuwire/altivar/procedure/commissioning/restore_factory_settings.hpp>
#include <rtuwire/altivar/procedure/inspection/at_rest.hpp>
#include <rtuwire/altivar/procedure/inspection/supervision.hpp>
#include <rtuwire/altivar/procedure/motion/direct_control.hpp>

using namespace rtuwire;
using namespace rtuwire::altivar;
using kind = event::kind;

namespace {

constexpr auto const& later = atv320::device::layout;
constexpr auto const& old = atv28::device::layout;
constexpr std::uint16_t locked = 0x0250, running = 0x0237, faulty = 0x0238, reacting = 0x023F, starting = 0x0210,
                        quick = 0x0217;

/// Of an ATV28 a look reads the status behind LFT.
constexpr event read(std::uint16_t word) { return {kind::word_read, word, errc::none, word}; }
constexpr event fails(errc error) { return {kind::failed, 0, error}; }
constexpr event begins{kind::begun}, written{kind::written}, goes_on{kind::pause_over}, late{kind::late};

/// The last action of a procedure after all these events.
template <typename Script, typename... Events> constexpr action after(Script& it, Events... events)
{
    action last = to_end;
    ((last = it.step(events)), ...);
    return last;
}
template <typename Script, typename... Events> constexpr reason told(Script it, Events... events)
{
    static_cast<void>(after(it, events...));
    return it.reason();
}
constexpr bool ends(reason const& at, outcome_kind kind, errc error = errc::none)
{
    return at.kind == kind and at.error == error;
}
constexpr bool reads(action what, std::uint16_t address)
{
    return what_of(what) == action_kind::read and address_of(what) == address;
}
constexpr bool writes(action what, std::uint16_t address, std::uint16_t word)
{
    return what_of(what) == action_kind::write and address_of(what) == address and word_of(what) == word;
}

/// How long a conversation takes at most, told before its first request.
template <typename Conversation> constexpr duration limit_of(Conversation conversation)
{
    conversation.advance(instant{0xFFFF'FF00U});
    return *conversation.poll_deadline() - instant{0xFFFF'FF00U};
}
/// The same of one that is never answered.
template <typename Conversation> constexpr duration ends_unanswered_after(Conversation conversation)
{
    instant const begin{0xFFFF'FF00U};
    instant now = begin;
    for (conversation.advance(now); not conversation.settled() and now - begin < milliseconds(60'000);
         conversation.advance(now)) {
        if (conversation.next()) {
            conversation.accept(errc::timed_out);
        }
        now = now + milliseconds(500);
    }
    return now - begin;
}
constexpr bool ends_in_time()
{
    constexpr station<atv320::device> drive{unit_id{7}};
    constexpr station<atv28::device> other{unit_id{7}};
    using settings = channel_settings<atv320::device>;
    return limit_of(check_supervision{drive}) == milliseconds(10'000) and
           limit_of(set_channel{drive, settings::by_modbus()}) == milliseconds(10'000) and
           limit_of(atv28::release_link{other}) == milliseconds(3'000) and
           limit_of(atv28::activate_link{other}) == milliseconds(3'000) and
           limit_of(atv28::direct_start{other, 50_Hz}) == milliseconds(3'000) and
           ends_unanswered_after(atv28::direct_stop{other, atv28::direct_stop_by::ramp}) == milliseconds(30'000) and
           limit_of(recall_from_eeprom{other}) == milliseconds(8'000) and
           limit_of(restore_factory_settings{drive, losing_control_and_address{}}) == milliseconds(5'000) and
           atv28::direct_start_procedure::grace == milliseconds(30'000);
}
PROOF("who names no limit has one, from the first pass on: looks and links", ends_in_time)

constexpr supervision_procedure check{later, test::unlimited, false};
constexpr errc missing = errc::illegal_data_address;

// Words that nobody has described are no safeguards.
STATIC_CHECK(ends(told(check, begins, read(3)), outcome_kind::unknown_register));
STATIC_CHECK(ends(told(check, begins, read(9)), outcome_kind::unknown_register));
STATIC_CHECK(ends(told(check, begins, read(1), read(100), read(0)), outcome_kind::unknown_register));
STATIC_CHECK(ends(told(check, begins, read(1), read(100), read(4)), outcome_kind::unknown_register));
STATIC_CHECK(ends(told(check, begins, read(1), read(0)), outcome_kind::unsupervised));
// What is not the drive's answer ends it as what it is.
STATIC_CHECK(ends(told(check, begins, fails(errc::timed_out)), outcome_kind::silent, errc::timed_out));
STATIC_CHECK(ends(told(check, begins, fails(errc::server_device_failure)), outcome_kind::refused,
                  errc::server_device_failure));
STATIC_CHECK(ends(told(check, begins, late), outcome_kind::aborted));
STATIC_CHECK(ends(told(check, begins, written), outcome_kind::aborted));
// What a lost response says is told at the limit, until the check is over.
STATIC_CHECK(ends(told(check, begins, read(1), fails(errc::timed_out), late), outcome_kind::aborted, errc::timed_out));
STATIC_CHECK(ends(told(check, begins, read(1), fails(errc::crc_mismatch), read(1), late), outcome_kind::aborted,
                  errc::crc_mismatch));

constexpr bool accepts_all_that_is_missing()
{
    supervision_procedure it{
        later, {.risks = {.accept_unknown_registers = true}, .beyond = beyond_limits::limit}, false};
    action last = it.step(begins);
    unsigned requests = 0;
    while (what_of(last) == action_kind::read and address_of(last) != later.eta) {
        last = it.step(fails(missing));
        ++requests;
    }
    last = it.step(read(locked));
    // SLL, TTO, CHCF, CD1, FR1, FLO, ATR, DOTD.
    using test::is;
    return is(requests == 8, "eight registers are asked for") and
           is(what_of(last) == action_kind::end, "it has ended") and
           is(it.reason().kind == outcome_kind::succeeded, "it has succeeded") and
           is(it.reason().error == errc::none, "it has no error") and
           is(it.report().period.timeout == duration{}, "the time-out is not known") and
           is(it.report().words == word_meaning::unknown, "what the words mean is not known") and
           is(it.reason().state == cia402::state::switch_on_disabled, "the state is known");
}
PROOF("a drive that has none of the registers is ready only where that was accepted", accepts_all_that_is_missing)

constexpr bool takes_no_status_for_granted()
{
    supervision_procedure it{
        atv12::device::layout, {.risks = {.accept_unknown_registers = true}, .beyond = beyond_limits::limit}, false};
    action const last = after(it, begins, read(1), read(100), read(1), read(164), read(0));
    return reads(last, 3201) and what_of(it.step(fails(missing))) == action_kind::end and
           it.reason().kind == outcome_kind::refused and it.reason().error == missing;
}
PROOF("a status that is not there is no risk that could be accepted", takes_no_status_for_granted)

constexpr bool is_ready_without_a_wiring_register()
{
    supervision_procedure it{old, test::unlimited, false};
    action last = after(it, begins, read(0), read(0)); // CMI, ATR
    bool ok = reads(last, 6);
    last = it.step(fails(missing)); // TCC: as in two-wire control
    ok = ok and reads(last, 478);
    last = it.step(read(0x0001));
    return ok and it.reason().kind == outcome_kind::run_input_closed;
}
PROOF("an input counts where nobody says how it is wired", is_ready_without_a_wiring_register)

constexpr at_rest_procedure look{later, {}};
STATIC_CHECK(ends(told(look, begins, read(starting)), outcome_kind::aborted));
STATIC_CHECK(ends(told(look, begins, read(running)), outcome_kind::refused_while_running));
STATIC_CHECK(ends(told(look, begins, read(quick)), outcome_kind::refused_while_running));
STATIC_CHECK(ends(told(look, begins, read(reacting), read(5)), outcome_kind::in_fault));
STATIC_CHECK(told(look, begins, read(faulty), read(5)).fault == 5);
STATIC_CHECK(ends(told(look, begins, read(locked), read(0), read(0)), outcome_kind::succeeded));
STATIC_CHECK(ends(told(look, begins, read(0x0231), read(0), read(4)), outcome_kind::succeeded));
STATIC_CHECK(ends(told(look, begins, read(0x0233), read(1)), outcome_kind::succeeded));
STATIC_CHECK(ends(told(look, begins, read(locked), read(0), read(2)), outcome_kind::run_input_closed));
STATIC_CHECK(ends(told(look, begins, read(locked), fails(missing), read(1)), outcome_kind::run_input_closed));
STATIC_CHECK(ends(told(look, begins, read(locked), read(0), fails(missing)), outcome_kind::unknown_register, missing));
STATIC_CHECK(ends(told(look, begins, fails(missing)), outcome_kind::refused, missing));
STATIC_CHECK(ends(told(look, begins, read(faulty), fails(missing)), outcome_kind::refused, missing));
STATIC_CHECK(ends(told(look, begins, fails(errc::timed_out)), outcome_kind::silent, errc::timed_out));
STATIC_CHECK(ends(told(look, begins, late), outcome_kind::aborted));
// A fault is trusted where it is said, its reaction never.
constexpr at_rest_procedure remedy{later, {}, {.accepts_fault = true, .ends_three_wire = true}};
STATIC_CHECK(ends(told(remedy, begins, read(faulty), read(0)), outcome_kind::succeeded));
STATIC_CHECK(ends(told(remedy, begins, read(faulty), read(1)), outcome_kind::run_input_closed));
STATIC_CHECK(ends(told(remedy, begins, read(reacting), read(9)), outcome_kind::in_fault));
// Without inputs to look at, or with none that runs.
constexpr at_rest_procedure unseen{atv310::device::layout, {.accept_unseen_inputs = true}};
STATIC_CHECK(ends(told(unseen, begins, read(locked)), outcome_kind::succeeded));
constexpr at_rest_procedure blind{atv310::device::layout, {}};
STATIC_CHECK(ends(told(blind, begins, read(locked)), outcome_kind::unknown_register));
constexpr at_rest_procedure no_input{later, {.run_inputs = 0}};
STATIC_CHECK(ends(told(no_input, begins, read(locked)), outcome_kind::succeeded));

constexpr channel_procedure one{later, {{{8413, 164}, {}, {}, {}}}, {.run_inputs = 0}};

constexpr bool sets_one_setting()
{
    channel_procedure it = one;
    bool ok = reads(it.step(begins), 8413);
    ok = ok and reads(it.step(read(1)), later.eta);
    ok = ok and writes(it.step(read(locked)), later.cmd, 0);
    ok = ok and writes(it.step(written), 8413, 164) and it.written() == 0;
    ok = ok and reads(it.step(written), 8413) and it.written() == 1 and it.address() == 8413;
    ok = ok and reads(it.step(read(164)), 8413); // all of them, once more
    ok = ok and what_of(it.step(read(164))) == action_kind::pause;
    ok = ok and reads(it.step(goes_on), later.eta);
    ok = ok and what_of(it.step(read(locked))) == action_kind::end;
    return ok and it.reason().kind == outcome_kind::succeeded and it.address() == 0;
}
PROOF("a setting is read, cleared for, written, read back twice and looked at", sets_one_setting)

constexpr bool is_set_without_a_write()
{
    channel_procedure it = one;
    bool ok = reads(it.step(begins), 8413);
    ok = ok and what_of(it.step(read(164))) == action_kind::end;
    return ok and it.reason().kind == outcome_kind::succeeded and it.written() == 0 and it.address() == 0;
}
PROOF("a setting that is right already is neither written nor looked at again", is_set_without_a_write)

constexpr bool finds_a_setting_that_was_lost()
{
    channel_procedure it{later, {{{8413, 164}, {8423, 10}, {}, {}}}, {.run_inputs = 0}};
    bool ok = reads(it.step(begins), 8413) and reads(it.step(read(1)), 8423);
    ok = ok and reads(it.step(read(1)), later.eta) and writes(it.step(read(locked)), later.cmd, 0);
    ok = ok and writes(it.step(written), 8413, 164) and reads(it.step(written), 8413);
    ok = ok and reads(it.step(read(164)), later.eta) and writes(it.step(read(locked)), 8423, 10);
    ok = ok and reads(it.step(written), 8423) and reads(it.step(read(10)), 8413);
    // Its power was gone for a moment behind the first.
    ok = ok and reads(it.step(read(1)), later.eta); // before it ends: the terminals may have started the motor
    ok = ok and what_of(it.step(read(locked))) == action_kind::end;
    return ok and it.reason().kind == outcome_kind::not_taken and it.address() == 8413 and it.word() == 1;
}
PROOF("a setting that was taken and is gone at the end is told", finds_a_setting_that_was_lost)

/// The set-up above, up to the look behind its last write.
template <typename... Events> constexpr reason behind_the_write(Events... events)
{
    return told(one, begins, read(1), read(locked), written, written, read(164), read(164), goes_on, events...);
}
STATIC_CHECK(ends(behind_the_write(read(faulty), read(9)), outcome_kind::in_fault));
STATIC_CHECK(behind_the_write(read(faulty), read(9)).fault == 9);
STATIC_CHECK(ends(behind_the_write(read(running), written), outcome_kind::started_by_terminals));
STATIC_CHECK(ends(behind_the_write(read(running), fails(errc::timed_out)), outcome_kind::started_by_terminals,
                  errc::timed_out));
STATIC_CHECK(ends(behind_the_write(fails(errc::timed_out), written), outcome_kind::silent, errc::timed_out));
STATIC_CHECK(ends(behind_the_write(late, written), outcome_kind::aborted));
STATIC_CHECK(ends(told(one, begins, fails(errc::timed_out)), outcome_kind::silent, errc::timed_out));
STATIC_CHECK(ends(told(one, begins, read(1), late), outcome_kind::aborted));
STATIC_CHECK(ends(told(one, begins, read(1), read(locked), written, fails(missing), read(locked)),
                  outcome_kind::refused, missing));

using atv28::link_procedure;
constexpr link_procedure release{true, {.run_inputs = 0}};
constexpr link_procedure activate{false, {.run_inputs = 0}};
constexpr std::uint16_t free_28 = 0x0240, running_28 = 0x0227, fault_28 = 0x0228;
STATIC_CHECK(ends(told(release, begins, read(free_28), written, goes_on, read(free_28), read(0)),
                  outcome_kind::succeeded));
STATIC_CHECK(ends(told(release, begins, read(free_28), written, goes_on, read(free_28), read(0x4000)),
                  outcome_kind::not_taken));
STATIC_CHECK(ends(told(activate, begins, read(free_28), written, goes_on, read(free_28), read(0x4000)),
                  outcome_kind::succeeded));
STATIC_CHECK(ends(told(activate, begins, read(free_28), written, goes_on, read(free_28), read(0)),
                  outcome_kind::not_taken));
STATIC_CHECK(ends(told(release, begins, read(fault_28), read(9)), outcome_kind::in_fault));
STATIC_CHECK(ends(told(release, begins, read(free_28), fails(errc::timed_out), read(free_28)), outcome_kind::silent,
                  errc::timed_out));
STATIC_CHECK(ends(told(release, begins, read(free_28), written, goes_on, read(running_28), fails(errc::timed_out)),
                  outcome_kind::started_by_terminals, errc::timed_out));
STATIC_CHECK(ends(told(release, begins, late), outcome_kind::aborted));
STATIC_CHECK(ends(told(release, begins, read(free_28), written, late, read(free_28)), outcome_kind::aborted));

constexpr cmi_order_procedure recall{old, {.run_inputs = 0}, recall_order};
STATIC_CHECK(ends(told(recall, begins, read(fault_28), read(9)), outcome_kind::in_fault));
STATIC_CHECK(ends(told(recall, begins, read(free_28), fails(errc::timed_out)), outcome_kind::silent, errc::timed_out));
STATIC_CHECK(ends(told(recall, begins, read(free_28), read(0), fails(errc::timed_out), goes_on, read(0)),
                  outcome_kind::executed_unconfirmed, errc::timed_out));
STATIC_CHECK(ends(told(recall, begins, read(free_28), read(0), fails(missing)), outcome_kind::refused, missing));
STATIC_CHECK(ends(told(recall, begins, read(free_28), read(0), written, goes_on, late, written),
                  outcome_kind::executed_unconfirmed));
STATIC_CHECK(ends(told(recall, begins, read(free_28), read(0), fails(errc::crc_mismatch), late, written),
                  outcome_kind::executed_unconfirmed, errc::crc_mismatch)); // the response to the order
STATIC_CHECK(ends(told(recall, begins, late), outcome_kind::aborted));
STATIC_CHECK(ends(told(recall, begins, read(free_28), late), outcome_kind::aborted));

constexpr cmi_order_procedure factory{later, {.run_inputs = 0}, factory_order};
STATIC_CHECK(ends(told(factory, begins, late), outcome_kind::aborted));
STATIC_CHECK(ends(told(factory, begins, read(reacting), read(9)), outcome_kind::in_fault));
STATIC_CHECK(ends(told(factory, begins, read(locked), fails(missing)), outcome_kind::refused, missing));

using atv28::direct_start_procedure;
constexpr direct_start_procedure go{{401, 200}, supervision_procedure{old, test::commissioned()}};
constexpr bool gives_up_at_its_limit()
{
    direct_start_procedure it = go;
    action last =
        after(it, begins, read(free_28), written, written, read(200), read(free_28), read(0), written, read(200));
    bool ok = reads(last, old.eta);
    last = it.step(read(free_28)); // it does not run
    ok = ok and what_of(last) == action_kind::pause and reads(it.step(goes_on), old.eta);
    // The limit: what was told is taken back, by the ramp because the motor may run by now.
    return ok and writes(it.step(late), old.cmd, 0x0007);
}
PROOF("a direct start that does not run by its limit is taken back", gives_up_at_its_limit)
STATIC_CHECK(ends(told(go, begins, fails(errc::timed_out)), outcome_kind::silent, errc::timed_out));
STATIC_CHECK(ends(told(go, begins, read(fault_28), read(9)), outcome_kind::in_fault));
STATIC_CHECK(told(go, begins, read(fault_28), read(9)).fault == 9);
STATIC_CHECK(ends(told(go, begins, late), outcome_kind::aborted));
// Somebody commanded it between the look and its word: what was told is taken back.
constexpr bool gives_up_where_it_is_not_locked()
{
    direct_start_procedure it = go;
    action const last = after(it, begins, read(free_28), written, written, read(200), read(0x0221));
    return writes(last, old.cmd, 0x0000);
}
PROOF("a direct start finds its drive locked, or gives up", gives_up_where_it_is_not_locked)

// A fault before its word: 0000 stands there already.
STATIC_CHECK(ends(told(go, begins, read(free_28), written, written, read(200), read(fault_28), read(16)),
                  outcome_kind::in_fault));
constexpr bool tells_of_a_fault_behind_its_word()
{
    direct_start_procedure it = go;
    action const last = after(it, begins, read(free_28), written, written, read(200), read(free_28), read(0), written,
                              read(200), read(fault_28));
    bool ok = reads(last, old.lft);
    ok = ok and writes(it.step(read(16)), old.cmd, 0x0007); // its reset must not run it
    ok = ok and reads(it.step(written), old.lft);           // and ETA behind it
    ok = ok and what_of(it.step({kind::word_read, 16, errc::none, fault_28})) == action_kind::end;
    return ok and it.reason().kind == outcome_kind::in_fault and it.reason().fault == 16;
}
PROOF("a direct start into a fault is taken back and tells of it", tells_of_a_fault_behind_its_word)

} // namespace
