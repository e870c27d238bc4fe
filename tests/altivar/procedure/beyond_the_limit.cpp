// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// The last requests of a conversation whose limit is over: they leave the drive safe, and the outcome tells what was
// read and confirmed.
#include "altivar/procedure/by_hand.hpp"
#include "altivar/procedure/status_words.hpp"
#include "support/proof.hpp"

#include <rtuwire/altivar/atv28.hpp>
#include <rtuwire/altivar/atv320.hpp>
#include <rtuwire/altivar/procedure/commissioning/channel.hpp>
#include <rtuwire/altivar/procedure/commissioning/recall_from_eeprom.hpp>
#include <rtuwire/altivar/procedure/commissioning/release_link.hpp>
#include <rtuwire/altivar/procedure/commissioning/restore_factory_settings.hpp>
#include <rtuwire/altivar/procedure/motion/change_reference.hpp>
#include <rtuwire/altivar/procedure/motion/reset_fault.hpp>

using namespace rtuwire;
using namespace rtuwire::detail;
using namespace rtuwire::altivar;
using test::by_hand, test::disabled_word, test::enabled_word, test::fault_word;
using kind = outcome_kind;

namespace {

constexpr station<atv28::device> old{unit_id{7}};
constexpr station<atv320::device> drive{unit_id{7}};
constexpr duration limit = milliseconds(1'000);
constexpr std::uint16_t command = 400, control = 402, status = 458;
constexpr std::uint16_t cmd = 8501, cmi = 8504, eta = 3201, chcf = 8401;

/// A release up to the word that releases, which is under way.
struct released : by_hand<atv28::release_link> {
    bool is_right;
    constexpr released() : by_hand{atv28::release_link{old, {}, limit}}, is_right{true}
    {
        wait(0);
        is_right = reads_and_hears(status, disabled_word) and reads_and_hears(6, 1) and writes(command, 0x8100);
    }
    /// The motor was read to run: the word that takes its power away, and the end.
    constexpr bool is_cut()
    {
        wait(50);
        return conversation.intent() == effect::stopping and writes_and_confirms(command, 0x8000) and
               ended_as(kind::started_by_terminals);
    }
};

constexpr bool cuts_a_motor_read_at_the_limit()
{
    released it;
    it.confirm();
    it.wait(50);
    bool const looks = it.reads(status);
    it.wait(950); // the limit passes while the answer is under way
    it.hear(enabled_word);
    return it.is_right and looks and it.is_cut();
}
PROOF("a motor that a release found running at its limit loses its power", cuts_a_motor_read_at_the_limit)

constexpr bool looks_beyond_the_limit()
{
    released waiting;
    waiting.confirm();
    waiting.wait(1'000); // the limit passes in the wait
    bool ok = waiting.is_right and waiting.reads_and_hears(status, enabled_word) and waiting.is_cut();
    released unanswered;
    unanswered.wait(1'000); // and here while the response to the release is missing
    unanswered.miss();
    unanswered.wait(1);
    ok = ok and unanswered.is_right and unanswered.reads_and_hears(status, enabled_word) and unanswered.is_cut();
    released at_rest;
    at_rest.miss();
    return ok and at_rest.is_right and at_rest.reads_and_hears(status, disabled_word) and
           at_rest.ended_as(kind::silent);
}
PROOF("a release looks again at its end, answered or not, in time or not", looks_beyond_the_limit)

constexpr bool cuts_without_a_look()
{
    released it;
    it.confirm();
    it.wait(1'000);
    it.wait(2'999); // the look has no turn on the line
    bool ok = it.is_right and it.conversation.intent() == effect::none and not it.conversation.settled();
    it.wait(1);
    ok = ok and it.conversation.intent() == effect::stopping;
    it.wait(10'000); // and the word none for a while
    ok = ok and it.writes_and_confirms(command, 0x8000);
    return ok and it.ended_as(kind::aborted);
}
PROOF("a release that cannot look takes the power away 3 s after its limit", cuts_without_a_look)

constexpr bool cuts_after_a_setting()
{
    for (bool const is_answered : {false, true}) {
        by_hand<set_channel> it{set_channel{
            drive, channel_settings<atv320::device>{}.with<atv320::chcf>(atv320::channel_mode::sep), {}, limit}};
        it.wait(0);
        bool ok = it.reads_and_hears(chcf, 1) and it.reads_and_hears(eta, disabled_word) and
                  it.reads_and_hears(11101, 1) and it.writes_and_confirms(cmd, 0) and it.writes(chcf, 2);
        it.wait(1'000);
        is_answered ? it.confirm() : it.miss();
        it.wait(1);
        ok = ok and it.reads(eta);
        it.wait(5'000); // longer than the time for this look
        it.hear(enabled_word);
        it.wait(1);
        ok = ok and it.conversation.intent() == effect::stopping and it.writes_and_confirms(cmd, 0) and
             it.ended_as(kind::started_by_terminals) and it.conversation.address() == eta;
        if (not ok) {
            return false;
        }
    }
    return true;
}
PROOF("a motor that runs after a setting was sent is withdrawn beyond the limit", cuts_after_a_setting)

/// A recall up to its order, which is under way.
struct recalled : by_hand<recall_from_eeprom> {
    bool is_right;
    constexpr recalled() : by_hand{recall_from_eeprom{old, {}, milliseconds(5'000)}}, is_right{true}
    {
        wait(0);
        is_right = reads_and_hears(status, disabled_word) and reads_and_hears(478, 0) and
                   reads_and_hears(control, 0x8200) and writes(control, 0x8204);
    }
    constexpr bool is_cleared()
    {
        wait(1);
        return writes_and_confirms(control, 0x8200) and conversation.settled();
    }
};

constexpr bool clears_a_recall()
{
    recalled unanswered;
    unanswered.wait(5'000);
    unanswered.miss();
    bool ok = unanswered.is_right and unanswered.is_cleared() and unanswered.ended_as(kind::executed_unconfirmed);
    recalled not_taken;
    not_taken.confirm();
    not_taken.wait(4'000);
    ok = ok and not_taken.is_right and not_taken.reads(control);
    not_taken.wait(1'000);
    not_taken.hear(0x8204);
    return ok and not_taken.is_cleared() and not_taken.ended_as(kind::not_taken);
}
PROOF("a recall leaves no order in CMI at its limit", clears_a_recall)

constexpr bool is_given_up_before_its_order()
{
    by_hand<recall_from_eeprom> it{recall_from_eeprom{old, {}, limit}};
    it.wait(0);
    bool const ok =
        it.reads_and_hears(status, disabled_word) and it.reads_and_hears(478, 0) and it.reads_and_hears(control, 0);
    it.wait(1'000); // the order has no turn on the line
    return ok and it.ended_as(kind::aborted);
}
PROOF("a recall whose order was never sent is not said to be executed", is_given_up_before_its_order)

constexpr bool clears_a_restore()
{
    by_hand<restore_factory_settings> it{restore_factory_settings{drive, losing_control_and_address{}, {}, limit}};
    it.wait(0);
    bool ok = it.reads_and_hears(eta, disabled_word) and it.reads_and_hears(5202, 0) and
              it.reads_and_hears(cmi, 0x8200) and it.writes(cmi, 0x8201);
    it.wait(1'000);
    it.confirm();
    it.wait(1);
    ok = ok and it.writes(cmi, 0x8200);
    it.miss(); // it may have another address now
    return ok and it.ended_as(kind::executed_unconfirmed);
}
PROOF("a restore that was confirmed at its limit is executed, and its order cleared", clears_a_restore)

constexpr bool leaves_bit_7_low()
{
    by_hand<reset_fault> it{reset_fault{drive, limit}};
    it.wait(0);
    bool ok = it.reads_and_hears(eta, fault_word) and it.writes_and_confirms(cmd, 0) and it.writes(cmd, 0x0080);
    it.wait(1'000);
    it.confirm();
    it.wait(1);
    ok = ok and it.writes_and_confirms(cmd, 0);
    return ok and it.ended_as(kind::state_timeout) and it.conversation.reason().fault == 0;
}
PROOF("a reset leaves bit 7 low at its limit, and claims no fault from before", leaves_bit_7_low)

constexpr bool believes_the_second_look()
{
    by_hand<change_reference> it{change_reference{drive, 40_Hz}};
    it.wait(0);
    bool ok = it.reads_and_hears(eta, 0x0A37) and it.reads_and_hears(cmd, 0x000F) and it.reads_and_hears(8502, 600) and
              it.writes_and_confirms(8502, 400);
    it.wait(50);
    ok = ok and it.reads_and_hears(eta, 0x0A37) and not it.conversation.settled(); // limited, by the reference before
    for (unsigned i = 0; i < 2; ++i) {
        it.wait(50);
        ok = ok and it.reads_and_hears(eta, 0x0637) and it.reads_and_hears(3202, 400);
    }
    return ok and it.reads_and_hears(8502, 400) and it.reads_and_hears(eta, 0x0637) and it.conversation.succeeded();
}
PROOF("a drive that was limited by the reference before is not said to be limited", believes_the_second_look)

} // namespace
