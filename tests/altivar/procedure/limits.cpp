// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// What a conversation does when its time is over: on a line that has no time for it, with a drive that does not answer,
// and with one that does not stop.
#include "altivar/procedure/by_hand.hpp"
#include "support/commissioned.hpp"
#include "support/known_words.hpp"
#include "support/proof.hpp"

#include <rtuwire/altivar/atv12.hpp>
#include <rtuwire/altivar/atv320.hpp>
#include <rtuwire/altivar/procedure/motion/change_reference.hpp>
#include <rtuwire/altivar/procedure/motion/start.hpp>
#include <rtuwire/altivar/procedure/motion/stop.hpp>

using namespace rtuwire;
using namespace rtuwire::detail;
using namespace rtuwire::altivar;
using test::by_hand;

namespace {

constexpr station<atv320::device> drive{unit_id{7}};
constexpr station<atv12::device> other{unit_id{7}};
constexpr std::uint16_t cmd = 8501, eta = 3201, rfr = 3202;
constexpr std::uint16_t ready = 0x0231, enabled = 0x0237;

/// Whether a halt whose first look has no turn on the line becomes the ramp then, and not before.
constexpr bool is_ramp_after(std::uint32_t time_ms, duration limit)
{
    by_hand<stop> it{test::with_known_words(stop{other, stop_by::halt, limit})};
    it.wait(0);
    it.wait(time_ms - 1);
    bool ok = it.conversation.intent() == effect::none and not it.conversation.settled();
    it.wait(1);
    ok = ok and it.conversation.intent() == effect::stopping and not it.conversation.settled() and
         it.writes(cmd, 0x0007);
    it.miss();
    it.wait(static_cast<std::uint32_t>(limit.microseconds / 1'000));
    return ok and it.conversation.settled() and it.conversation.reason().kind == outcome_kind::silent and
           it.conversation.reason().is_other_stop;
}
constexpr bool says_a_word_before_its_limit()
{
    return is_ramp_after(1'000, milliseconds(30'000)) and is_ramp_after(500, milliseconds(500));
}
PROOF("a halt that cannot look for a second, or up to its limit, says the word of the ramp instead",
      says_a_word_before_its_limit)

constexpr bool is_taken_back_beyond_the_limit()
{
    by_hand<start> it{start{drive, 50_Hz, run_direction::forward, milliseconds(200), test::commissioned()}};
    it.wait(0);
    bool ok = it.reads(eta);
    it.hear(ready);
    ok = ok and it.writes(cmd, 0x0007);
    it.confirm();
    ok = ok and it.reads(eta);
    it.hear(ready); // and stays there
    it.wait(200);
    // The word that takes back has no turn on the line for a while.
    for (unsigned i = 0; i < 10; ++i) {
        ok = ok and it.conversation.intent() == effect::stopping and not it.conversation.settled();
        it.wait(100);
    }
    // It is said again and again, for the 30 s behind the limit.
    for (unsigned i = 0; i < 28; ++i) {
        ok = ok and not it.conversation.settled() and it.writes(cmd, 0x0000);
        it.miss();
        it.wait(1'000);
    }
    ok = ok and not it.conversation.settled() and it.writes(cmd, 0x0000);
    it.miss();
    it.wait(1'000);
    return ok and it.conversation.settled() and it.conversation.reason().kind == outcome_kind::state_timeout;
}
PROOF("what a start gave is taken back for half a minute behind its limit, however bad the line is",
      is_taken_back_beyond_the_limit)

/// How a stop ends that found the drive so twice, and has told it anew just before its limit.
constexpr reason told_of_a_stop(std::uint16_t first, std::uint16_t last, bool is_seen_since)
{
    by_hand<stop> it{test::with_known_words(stop{other, stop_by::ramp, milliseconds(1'000)})};
    it.wait(0);
    bool ok = true;
    for (std::uint16_t const frequency : {first, last}) {
        bool const is_again = it.conversation.intent() != effect::stopping;
        ok = ok and (not is_again or it.reads_and_hears(8401, 1));
        ok = ok and it.writes(cmd, 0x0007);
        it.confirm();
        ok = ok and it.reads(eta);
        it.hear(enabled, frequency);
        it.wait(50);
    }
    if (not is_seen_since) {
        ok = ok and it.reads_and_hears(8401, 1) and it.writes(cmd, 0x0007);
        it.confirm();
    }
    it.wait(1'000); // in a look, perhaps
    it.wait(0);
    if (not it.conversation.settled()) { // what was due then
        it.miss();
    }
    return ok ? it.conversation.reason() : reason{};
}
constexpr bool tells_what_is_true()
{
    constexpr auto back = static_cast<std::uint16_t>(-300), slower_back = static_cast<std::uint16_t>(-200);
    return told_of_a_stop(300, 300, true).kind == outcome_kind::state_timeout and
           told_of_a_stop(300, 310, true).kind == outcome_kind::state_timeout and
           told_of_a_stop(back, back, true).kind == outcome_kind::state_timeout and
           told_of_a_stop(300, 200, true).kind == outcome_kind::unconfirmed and
           told_of_a_stop(back, slower_back, true).kind == outcome_kind::unconfirmed and
           told_of_a_stop(300, 300, false).kind == outcome_kind::unconfirmed;
}
PROOF("a stop ends as not obeyed where the drive was seen as fast as before behind the last word, "
      "else as unconfirmed",
      tells_what_is_true)

/// How a stop ends that has looked once and found the motor running, or whose look had no answer.
constexpr outcome_kind told_of_one_look(bool is_answered)
{
    by_hand<stop> it{test::with_known_words(stop{other, stop_by::ramp, milliseconds(1'000)})};
    it.wait(0);
    bool ok = it.writes(cmd, 0x0007);
    it.confirm();
    ok = ok and it.reads(eta);
    is_answered ? it.hear(enabled, 300) : it.miss();
    it.wait(1'000);
    return ok and it.conversation.settled() ? it.conversation.reason().kind : outcome_kind::pending;
}
constexpr bool compares_two_frequencies()
{
    return told_of_one_look(true) == outcome_kind::unconfirmed and told_of_one_look(false) == outcome_kind::unconfirmed;
}
PROOF("a motor whose frequency was not read twice is not said to be as fast as before", compares_two_frequencies)

constexpr bool ends_a_halt_that_was_told_at_its_limit()
{
    by_hand<stop> it{test::with_known_words(stop{other, stop_by::halt, milliseconds(1'000)})};
    it.wait(0);
    bool ok = it.reads(eta);
    it.hear(ready); // nothing to halt, if that is no late answer
    ok = ok and it.writes(cmd, 0x0007);
    it.confirm();
    it.wait(1'000); // and its next look had no turn
    return ok and it.conversation.settled() and it.conversation.reason().kind == outcome_kind::unconfirmed and
           not it.conversation.reason().is_other_stop;
}
PROOF("a halt that has told the drive something says no other word at its limit",
      ends_a_halt_that_was_told_at_its_limit)

constexpr bool has_no_loss_but_its_own()
{
    by_hand<change_reference> it{change_reference{drive, 0_Hz}};
    it.conversation.note_loss(); // of an order before this one
    it.wait(0);
    bool ok = it.reads(eta);
    it.hear(enabled);
    ok = ok and it.reads(cmd);
    it.hear(0x000F);
    ok = ok and it.writes(8502, 0);
    it.confirm();
    for (unsigned i = 0; i < 2; ++i) {
        it.wait(50);
        ok = ok and it.reads(eta);
        it.hear(0x0637);
    }
    ok = ok and it.reads(8502);
    it.hear(0);
    ok = ok and it.reads(eta);
    it.hear(0x0637);
    ok = ok and it.conversation.succeeded();
    it.conversation.note_loss();
    return ok and it.conversation.succeeded();
}
PROOF("a loss before a conversation began, or behind its end, is none of it", has_no_loss_but_its_own)

constexpr bool is_ended_by_its_loss()
{
    by_hand<change_reference> waiting{change_reference{drive, 50_Hz}};
    waiting.wait(0);
    waiting.conversation.note_loss(); // somebody else's request found it
    bool ok = waiting.conversation.reason().kind == outcome_kind::silent and
              waiting.conversation.reason().error == errc::unit_lost;
    by_hand<change_reference> asking{change_reference{drive, 50_Hz}};
    asking.wait(0);
    ok = ok and asking.reads(eta);
    asking.conversation.note_loss();
    ok = ok and not asking.conversation.settled();
    asking.hear(enabled); // its response is heard yet, but nothing follows
    return ok and asking.conversation.reason().kind == outcome_kind::silent and not asking.conversation.next();
}
PROOF("a loss ends a conversation, at once or behind the response that it waits for", is_ended_by_its_loss)

constexpr bool knows_how_long_the_drive_goes_on()
{
    return start{drive, 50_Hz, run_direction::forward, milliseconds(3'000), test::commissioned()}.drive_timeout() ==
               milliseconds(10'000) and
           start{drive, 50_Hz}.drive_timeout() == milliseconds(30'000);
}
PROOF("a drive goes on without a request as long as its time-out was read, else as long as it can "
      "be set",
      knows_how_long_the_drive_goes_on)

} // namespace
