// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// What stop asks and tells a drive, word by word, as the drive's status has it.
#include <rtuwire/altivar/procedure/motion/stop.hpp>

#include <utility>

#include "altivar/procedure/by_hand.hpp"
#include "support/known_words.hpp"
#include "support/proof.hpp"

#include <rtuwire/altivar/atv12.hpp>
#include <rtuwire/altivar/atv28.hpp>
#include <rtuwire/altivar/atv310.hpp>
#include <rtuwire/altivar/atv320.hpp>

using namespace rtuwire;
using namespace rtuwire::detail;
using namespace rtuwire::altivar;
using kind = event::kind;

namespace {

constexpr std::uint16_t cmd = 8501, eta = 3201, lft = 7121, rfr = 3202;
constexpr drive_layout some_drive{.cmd = cmd, .eta = eta, .lft = lft, .cmi = 8504, .eti = 3206, .rfr = rfr};

// Status words under remote control.
constexpr std::uint16_t switched_on = 0x0233, enabled = 0x0237, quick_stop_active = 0x0217;

constexpr bool reads(action what, std::uint16_t address)
{
    return what_of(what) == action_kind::read and address_of(what) == address;
}
constexpr bool writes(action what, std::uint16_t address, std::uint16_t word)
{
    return what_of(what) == action_kind::write and address_of(what) == address and word_of(what) == word;
}
constexpr bool ends(action what) { return what_of(what) == action_kind::end; }
constexpr event word(std::uint16_t read) { return {kind::word_read, read}; }
constexpr event words(std::uint16_t read, std::uint16_t behind) { return {kind::word_read, read, errc::none, behind}; }

constexpr bool says_its_word_first()
{
    bool ok = true;
    for (auto const& [mode, first] : {std::pair{stop_by::ramp, 0x0007}, std::pair{stop_by::quick_stop, 0x0002},
                                      std::pair{stop_by::freewheel, 0x0000}}) {
        stop_procedure it{some_drive, mode};
        auto const expected = static_cast<std::uint16_t>(first);
        ok = ok and writes(it.step({kind::begun}), cmd, expected);
        ok = ok and what_of(it.step({kind::failed, 0, errc::timed_out})) == action_kind::pause;
        ok = ok and writes(it.step({kind::pause_over}), cmd, expected);
        ok = ok and what_of(it.step({kind::failed, 0, errc::server_device_busy})) == action_kind::pause;
        ok = ok and writes(it.step({kind::pause_over}), cmd, expected);
        ok = ok and reads(it.step({kind::written}), eta);
        ok = ok and what_of(it.step(words(enabled, 300))) == action_kind::pause;
        ok = ok and writes(it.step({kind::pause_over}), cmd, expected); // again at each look
    }
    return ok;
}
PROOF("a stop says its word first, and again, whatever fails", says_its_word_first)

constexpr bool takes_power_from_a_quick_stop()
{
    for (stop_by const mode : {stop_by::ramp, stop_by::quick_stop}) {
        stop_procedure it{some_drive, mode};
        static_cast<void>(it.step({kind::begun}));
        bool ok = reads(it.step({kind::written}), eta);
        ok = ok and what_of(it.step(words(quick_stop_active, 120))) == action_kind::pause;
        ok = ok and writes(it.step({kind::pause_over}), cmd, 0x0002); // the quick stop is not made a ramp
        ok = ok and reads(it.step({kind::written}), eta);
        ok = ok and what_of(it.step(words(quick_stop_active, 0))) == action_kind::pause; // once is not enough
        ok = ok and writes(it.step({kind::pause_over}), cmd, 0x0002);
        ok = ok and reads(it.step({kind::written}), eta);
        if (not ok or not writes(it.step(words(quick_stop_active, 0)), cmd, 0)) {
            return false;
        }
    }
    return true;
}
PROOF("a motor that a quick stop brought to rest loses its power once it was seen to stand twice",
      takes_power_from_a_quick_stop)

constexpr bool halts_under_power()
{
    stop_procedure it{some_drive, stop_by::halt};
    bool ok = reads(it.step({kind::begun}), eta) and reads(it.step(words(enabled, 300)), cmd);
    ok = ok and writes(it.step(words(0x080F, 300)), cmd, 0x090F) and reads(it.step({kind::written}), eta);
    ok = ok and writes(it.step(words(enabled, 300)), cmd, 0x090F); // not slower yet: once more, behind this look
    ok = ok and reads(it.step({kind::written}), eta);
    ok = ok and what_of(it.step(words(enabled, 0))) == action_kind::pause;
    ok = ok and reads(it.step({kind::pause_over}), eta);
    return ok and ends(it.step(words(enabled, 0))) and it.reason().kind == outcome_kind::succeeded and
           it.reason().state == cia402::state::operation_enabled and not it.reason().is_other_stop;
}
PROOF("halt keeps the power, and ends when the motor was seen to stand twice", halts_under_power)

constexpr bool halts_no_drive_that_is_ready()
{
    stop_procedure it{some_drive, stop_by::halt};
    static_cast<void>(it.step({kind::begun}));
    static_cast<void>(it.step(words(enabled, 300)));
    bool ok = writes(it.step(word(0x000F)), cmd, 0x010F);
    ok = ok and what_of(it.step({kind::failed, 0, errc::server_device_busy})) == action_kind::pause;
    // Meanwhile somebody shut the drive down: the word with bit 3 would enable it.
    ok = ok and reads(it.step({kind::pause_over}), eta);
    return ok and writes(it.step(word(0x0231)), cmd, 0x0000);
}
PROOF("a halt is not given again to a drive that has become ready", halts_no_drive_that_is_ready)

constexpr bool halts_no_drive_that_is_silent()
{
    stop_procedure it{some_drive, stop_by::halt};
    static_cast<void>(it.step({kind::begun}));
    static_cast<void>(it.step(words(enabled, 300)));
    bool const is_told = writes(it.step(word(0x000F)), cmd, 0x010F);
    return is_told and writes(it.step({kind::failed, 0, errc::timed_out}), cmd, 0x0007);
}
PROOF("a halt that is not answered becomes the ramp, which needs no look", halts_no_drive_that_is_silent)

constexpr bool goes_below_switched_on()
{
    bool ok = true;
    for (stop_by const mode : {stop_by::ramp, stop_by::halt}) {
        stop_procedure it{some_drive, mode};
        static_cast<void>(it.step({kind::begun}));
        if (mode == stop_by::halt) { // what it reads before a word of its own may be older
            ok = ok and writes(it.step(word(switched_on)), cmd, 0x0007);
        }
        static_cast<void>(it.step({kind::written}));
        ok = ok and writes(it.step(word(switched_on)), cmd, 0x0000);
        ok = ok and reads(it.step({kind::written}), eta);
        ok = ok and ends(it.step(word(0x0250))) and it.reason().kind == outcome_kind::succeeded;
    }
    return ok;
}
PROOF("every stop leaves \"switched on\", from where one word could start the motor", goes_below_switched_on)

// From here on a conversation, which its client tells what it has read.
constexpr unit_id unit{7};
constexpr std::uint16_t chcf = 8401, atv28_cmd = 400;

template <typename Device> constexpr bool is_blind_in_doubt_of(stop_by mode, std::uint16_t confirmed_word)
{
    station<Device> const drive{unit};
    test::by_hand<stop> doubtful{stop{drive, mode}};
    doubtful.wait(0);
    bool ok = doubtful.writes_and_confirms(cmd, 0x0000) and doubtful.reads_and_hears(eta, 0x0250);
    ok = ok and doubtful.ended_as(outcome_kind::succeeded) and doubtful.conversation.reason().is_other_stop;
    test::by_hand<stop> certain{test::with_known_words(stop{drive, mode})};
    certain.wait(0);
    ok = ok and (mode == stop_by::halt ? certain.reads(eta) : certain.writes(cmd, confirmed_word));
    return ok and not certain.conversation.reason().is_other_stop;
}
constexpr bool is_blind_in_doubt()
{
    bool ok = true;
    for (auto const& [mode, word] :
         {std::pair{stop_by::ramp, 0x0007}, std::pair{stop_by::quick_stop, 0x0002}, std::pair{stop_by::halt, 0}}) {
        auto const expected = static_cast<std::uint16_t>(word);
        ok = ok and is_blind_in_doubt_of<atv320::device>(mode, expected) and
             is_blind_in_doubt_of<atv12::device>(mode, expected) and
             is_blind_in_doubt_of<atv310::device>(mode, expected);
    }
    return ok;
}
PROOF("whatever type was declared, a drive at 8501 is told 0000 until its words were read, and the reason says so",
      is_blind_in_doubt)

constexpr bool is_blind_in_doubt_for_a_halt()
{
    test::by_hand<stop> it{stop{station<atv12::device>{unit}, stop_by::halt}};
    it.wait(0);
    bool ok = it.writes_and_confirms(cmd, 0x0000);
    ok = ok and it.reads_and_hears(eta, enabled, 300);
    it.wait(50);
    return ok and it.writes(cmd, 0x0000); // never with a bit that may be RUN
}
PROOF("a halt of such a drive is 0000 at each look, too", is_blind_in_doubt_for_a_halt)

/// Of a stop that looks first: whether it reads CHCF, and which word it sends then.
constexpr bool says_after_a_look(stop_by mode, std::uint16_t read, std::uint16_t word)
{
    test::by_hand<stop> it{stop{station<atv12::device>{unit}, mode, milliseconds(1'000), stop_begin::look_first}};
    it.wait(0);
    bool const looks = it.conversation.intent() == effect::none and it.reads_and_hears(chcf, read);
    it.conversation = is_drive_profile(read) ? test::with_known_words(it.conversation) : it.conversation;
    return looks and it.conversation.intent() == effect::stopping and it.writes(cmd, word);
}
constexpr bool looks_first()
{
    bool ok = true;
    for (std::uint16_t const profile : {std::uint16_t{1}, std::uint16_t{2}}) {
        ok = ok and says_after_a_look(stop_by::ramp, profile, 0x0007);
        ok = ok and says_after_a_look(stop_by::quick_stop, profile, 0x0002);
    }
    for (std::uint16_t const other : {std::uint16_t{0}, std::uint16_t{3}, std::uint16_t{4}}) {
        ok = ok and says_after_a_look(stop_by::ramp, other, 0x0000);
        ok = ok and says_after_a_look(stop_by::quick_stop, other, 0x0000);
        ok = ok and says_after_a_look(stop_by::halt, other, 0x0000);
    }
    return ok;
}
PROOF("a stop that looks first says its word where CHCF is the drive profile, and 0000 elsewhere", looks_first)

/// What ends the look of a stop without a value.
enum class ending { missed, refused, no_turn, limit };
constexpr bool looks_in_vain(ending how)
{
    duration const limit = milliseconds(how == ending::limit ? 50 : 1'000);
    test::by_hand<stop> it{stop{station<atv12::device>{unit}, stop_by::ramp, limit, stop_begin::look_first}};
    it.wait(0);
    bool ok = true;
    switch (how) {
    case ending::missed:
        ok = it.reads(chcf);
        it.miss();
        break;
    case ending::refused:
        ok = it.reads(chcf);
        it.conversation.accept(errc::illegal_data_address);
        break;
    case ending::no_turn:
        it.wait(99);
        ok = it.conversation.intent() == effect::none;
        it.wait(1);
        break;
    case ending::limit: it.wait(50); break;
    }
    return ok and it.conversation.intent() == effect::stopping and it.writes(cmd, 0x0000);
}
constexpr bool looks_once()
{
    return looks_in_vain(ending::missed) and looks_in_vain(ending::refused) and looks_in_vain(ending::no_turn) and
           looks_in_vain(ending::limit);
}
PROOF("a look that brings nothing, or has no turn for 100 ms, ends with 0000", looks_once)

constexpr bool limits_its_look()
{
    test::by_hand<stop> it{
        stop{station<atv12::device>{unit}, stop_by::ramp, milliseconds(1'000), stop_begin::look_first}};
    it.wait(0);
    it.wait(30);
    auto const look = it.conversation.next();
    return look and not look->may_be_repeated() and it.conversation.limited(milliseconds(1'000)) == milliseconds(70) and
           it.conversation.limited(milliseconds(20)) == milliseconds(20);
}
PROOF("such a look is sent once, and its response may take what is left of the 100 ms", limits_its_look)

template <typename Device> constexpr bool tells_the_other_family(errc answer, errc expected)
{
    constexpr bool is_old = Device::layout.cmd == atv28_cmd;
    test::by_hand<stop> it{test::with_known_words(stop{station<Device>{unit}})};
    it.wait(0);
    bool ok = it.writes(Device::layout.cmd, 0x0007);
    it.conversation.accept(errc::illegal_data_address);
    ok = ok and it.conversation.intent() == effect::stopping;
    ok = ok and it.writes(is_old ? cmd : atv28_cmd, 0x0000);
    if (answer == errc::none) {
        it.confirm();
    } else {
        it.conversation.accept(answer);
    }
    auto const& why = it.conversation.reason();
    return ok and it.ended_as(outcome_kind::other_family) and why.error == expected and why.is_other_stop;
}
constexpr bool tells_each_family()
{
    bool ok = true;
    for (errc const answer : {errc::none, errc::illegal_data_address, errc::timed_out}) {
        ok = ok and tells_the_other_family<atv12::device>(answer, answer) and
             tells_the_other_family<atv28::device>(answer, answer);
    }
    return ok;
}
PROOF("a drive without the control word is told 0000 once where the other family has it, and nothing more",
      tells_each_family)

} // namespace
