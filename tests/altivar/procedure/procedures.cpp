// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// What the conversations with a drive share: when they end, and that they wait for the response under way. And
// what single words of a start and of a reset are.
#include <rtuwire/altivar/procedure/procedure_runner.hpp>

#include <array>

#include "support/commissioned.hpp"
#include "support/proof.hpp"

#include <rtuwire/altivar/atv12.hpp>
#include <rtuwire/altivar/atv320.hpp>
#include <rtuwire/altivar/procedure/commissioning/channel.hpp>
#include <rtuwire/altivar/procedure/commissioning/configure_scanner.hpp>
#include <rtuwire/altivar/procedure/commissioning/save_to_eeprom.hpp>
#include <rtuwire/altivar/procedure/motion/change_reference.hpp>
#include <rtuwire/altivar/procedure/motion/reset_fault.hpp>
#include <rtuwire/altivar/procedure/motion/start.hpp>
#include <rtuwire/altivar/procedure/motion/stop.hpp>
#include <rtuwire/client/client.hpp>

using namespace rtuwire;
using namespace rtuwire::detail;
using namespace rtuwire::altivar;
using kind = event::kind;

namespace {

constexpr station<atv320::device> drive{unit_id{7}};
constexpr std::uint16_t cmd = 8501, eta = 3201, lft = 7121, lfrd = 8602;
constexpr instant start_time{0xFFFF'FF00U};

/// How long a conversation takes at most, told before its first request.
template <typename Conversation> constexpr duration limit_of(Conversation conversation)
{
    conversation.advance(start_time);
    return *conversation.poll_deadline() - start_time;
}
constexpr bool ends_in_time()
{
    using scanned = configure_scanner<scanner_inputs<atv320::eta>, scanner_outputs<atv320::cmd>>;
    return limit_of(start{drive, 1'500_rpm}) == milliseconds(3'000) and
           limit_of(stop{drive}) == milliseconds(30'000) and
           limit_of(change_reference{drive, 1'500_rpm}) == milliseconds(30'000) and
           limit_of(reset_fault{drive}) == milliseconds(2'000) and
           limit_of(save_to_eeprom{drive}) == milliseconds(5'000) and limit_of(scanned{drive}) == milliseconds(5'000);
}
PROOF("who names no limit has one, from the first pass on", ends_in_time)

STATIC_CHECK(start_procedure::grace == milliseconds(30'000)); // as the reference says

constexpr bool waits_for_the_response()
{
    change_reference conversation{drive, 50_Hz, milliseconds(100)};
    bool ok = not conversation.poll_deadline();
    conversation.advance(start_time);
    ok = ok and conversation.next() and not conversation.poll_deadline();
    conversation.advance(start_time + milliseconds(200));
    ok = ok and not conversation.settled() and not conversation.poll_deadline();
    conversation.accept(errc::timed_out);
    ok = ok and conversation.settled() and conversation.reason().kind == outcome_kind::silent and
         not conversation.poll_deadline();
    conversation.advance(start_time + milliseconds(400));
    return ok and conversation.reason().kind == outcome_kind::silent and
           conversation.reason().error == errc::timed_out and conversation.reason().fault == 0 and
           not conversation.next();
}
PROOF("a limit that passes while a request is under way waits for its response", waits_for_the_response)

constexpr event word(std::uint16_t read) { return {kind::word_read, read}; }
constexpr bool reads(action what, std::uint16_t address)
{
    return what_of(what) == action_kind::read and address_of(what) == address;
}
constexpr bool writes(action what, std::uint16_t address, std::uint16_t value)
{
    return what_of(what) == action_kind::write and address_of(what) == address and word_of(what) == value;
}

/// A start of a drive that was checked before.
constexpr start_procedure started(std::int16_t rpm, run_direction way)
{
    auto const& layout = atv320::device::layout;
    supervision_procedure const check{layout, test::commissioned()};
    return start_procedure{layout, {lfrd, static_cast<std::uint16_t>(rpm)}, way, check};
}

constexpr bool gives_up_where_the_drive_falls_back()
{
    start_procedure it = started(1'500, run_direction::forward);
    bool ok = reads(it.step({kind::begun}), eta);
    ok = ok and writes(it.step(word(0x0231)), cmd, 0x0007); // ready to switch on
    ok = ok and reads(it.step({kind::written}), eta);
    ok = ok and writes(it.step(word(0x0250)), cmd, 0x0000); // switch on disabled: what was given is taken back
    ok = ok and reads(it.step({kind::written}), eta);
    ok = ok and what_of(it.step(word(0x0250))) == action_kind::end;
    return ok and it.reason().kind == outcome_kind::fell_back;
}
PROOF("a start ends where the drive goes down after a command", gives_up_where_the_drive_falls_back)

constexpr bool starts_from_below()
{
    start_procedure it = started(1'500, run_direction::reverse);
    bool ok = reads(it.step({kind::begun}), eta);
    ok = ok and what_of(it.step(word(0x0200))) == action_kind::pause; // not ready to switch on
    ok = ok and reads(it.step({kind::pause_over}), eta);
    ok = ok and writes(it.step(word(0x0250)), cmd, 0x0006);
    ok = ok and reads(it.step({kind::written}), eta) and writes(it.step(word(0x0231)), cmd, 0x0007);
    ok = ok and reads(it.step({kind::written}), eta) and writes(it.step(word(0x0233)), lfrd, 0xFA24);
    ok = ok and reads(it.step({kind::written}), lfrd) and reads(it.step(word(0xFA24)), cmd);
    ok = ok and writes(it.step(word(0x0007)), cmd, 0x000F);
    ok = ok and reads(it.step({kind::written}), 8401) and reads(it.step(word(1)), eta);
    ok = ok and reads(it.step(word(0x8237)), lfrd) and reads(it.step(word(0xFA24)), cmd);
    ok = ok and what_of(it.step(word(0x000F))) == action_kind::end;
    return ok and it.reason().kind == outcome_kind::succeeded;
}
PROOF("a start waits for a drive that is not ready, commands it up, and reads back before it enables",
      starts_from_below)

constexpr bool enables_no_drive_that_forgot()
{
    start_procedure it = started(1'500, run_direction::forward);
    static_cast<void>(it.step({kind::begun}));
    static_cast<void>(it.step(word(0x0231)));
    static_cast<void>(it.step({kind::written}));
    bool ok = writes(it.step(word(0x0233)), lfrd, 1'500) and reads(it.step({kind::written}), lfrd);
    ok = ok and reads(it.step(word(1'500)), cmd);
    ok = ok and writes(it.step(word(0x0000)), cmd, 0x0000); // another word than the one written last
    return ok;
}
PROOF("a drive whose control word is not ours any more is not enabled", enables_no_drive_that_forgot)

constexpr event goes_on{kind::pause_over};

/// A change to 1500 rpm, written already.
constexpr reference_procedure changed()
{
    reference_procedure it{atv320::device::layout, {lfrd, 1'500}, beyond_limits::limit};
    static_cast<void>(it.step({kind::begun}));
    static_cast<void>(it.step(word(0x0237)));
    static_cast<void>(it.step(word(0x000F)));
    static_cast<void>(it.step({kind::written}));
    return it;
}
constexpr bool is_reached_by_the_second_look()
{
    reference_procedure it = changed();
    bool ok = true;
    for (action_kind const next : {action_kind::pause, action_kind::read}) {
        ok = ok and reads(it.step(goes_on), eta);
        ok = ok and what_of(it.step(word(0x0637))) == action_kind::read; // RFR tells whether it turns
        ok = ok and what_of(it.step(word(1))) == next;
    }
    ok = ok and reads(it.step(word(1'500)), eta); // the reference is still the one written
    ok = ok and what_of(it.step(word(0x0637))) == action_kind::end;
    return ok and it.reason().kind == outcome_kind::succeeded;
}
constexpr bool is_not_reached_by_one_look()
{
    reference_procedure it = changed();
    // Turns, is not there yet, turns, stands, turns: never twice in a row.
    bool ok = reads(it.step(goes_on), eta) and what_of(it.step(word(0x0637))) == action_kind::read;
    ok = ok and what_of(it.step(word(1))) == action_kind::pause;
    ok = ok and reads(it.step(goes_on), eta) and what_of(it.step(word(0x0237))) == action_kind::pause;
    for (bool const turns : {true, false, true}) {
        ok = ok and reads(it.step(goes_on), eta) and what_of(it.step(word(0x0637))) == action_kind::read;
        ok = ok and what_of(it.step(word(turns ? 1 : 0))) == action_kind::pause;
    }
    return ok;
}
PROOF("a change of the reference is done at the second look in a row that shows it reached",
      is_reached_by_the_second_look)
PROOF("a change of the reference is not done by one look", is_not_reached_by_one_look)

constexpr bool resets_by_an_edge()
{
    reset_procedure it{atv320::device::layout};
    bool ok = reads(it.step({kind::begun}), eta) and writes(it.step(word(0x0208)), cmd, 0x0000);
    ok = ok and writes(it.step({kind::written}), cmd, 0x0080);
    ok = ok and writes(it.step({kind::written}), cmd, 0x0000);
    ok = ok and reads(it.step({kind::written}), eta);
    ok = ok and what_of(it.step(word(0x0208))) == action_kind::pause;
    ok = ok and reads(it.step({kind::late}), lft);
    return ok and what_of(it.step(word(9))) == action_kind::end and it.reason().fault == 9 and
           it.reason().kind == outcome_kind::in_fault;
}
PROOF("a reset writes a word without the bit, one with it and one without", resets_by_an_edge)

constexpr bool names_every_slot()
{
    constexpr std::array<std::uint16_t, 1> inputs{3201};
    constexpr std::array<std::uint16_t, 2> outputs{8501, 8602};
    scanner_procedure it{atv320::device::layout, atv320::device::scanner, inputs, outputs};
    bool ok = reads(it.step({kind::begun}), eta);
    action next = it.step(word(0x0250));
    for (std::uint16_t slot = 0; slot < 8; ++slot) {
        ok = ok and writes(next, static_cast<std::uint16_t>(12'701 + slot), slot == 0 ? 3201 : 0);
        next = it.step({kind::written});
    }
    for (std::uint16_t slot = 0; slot < 8; ++slot) {
        auto const expected = slot == 0 ? cmd : slot == 1 ? lfrd : std::uint16_t{0};
        ok = ok and writes(next, static_cast<std::uint16_t>(12'721 + slot), expected);
        next = it.step({kind::written});
    }
    return ok and what_of(next) == action_kind::end and it.reason().kind == outcome_kind::succeeded;
}
PROOF("every slot of the scanner is written, those that are not named with 0", names_every_slot)

constexpr bool fills_every_slot()
{
    using namespace altivar::atv12;
    using inputs = scanner_inputs<altivar::atv12::eta, rfrd, altivar::atv12::lft, lcr>;
    using outputs = scanner_outputs<altivar::atv12::cmd, altivar::atv12::lfrd, acc, dec>;
    configure_scanner<inputs, outputs> conversation{station<device>{unit_id{7}}};
    conversation.advance(start_time);
    return conversation.next().has_value();
}
PROOF("a scanner of four words takes four", fills_every_slot)

constexpr bool names_no_register_before_it_asks()
{
    at_rest_procedure const look{atv320::device::layout, {}};
    channel_procedure const channels{atv320::device::layout, {}, {}};
    return look.address() == 0 and look.word() == 0 and channels.address() == 0 and channels.word() == 0;
}
PROOF("what has asked nothing names no register", names_no_register_before_it_asks)
STATIC_CHECK(channel_settings<atv320::device>{}.words()[0].word == 0);

STATIC_CHECK(reason{}.fault == 0 and reason{}.error == errc::none);

// Clients have one code for all procedures, and visit a class that hides a function of theirs as itself.
STATIC_CHECK(visited_as_base<start>and visited_as_base<stop>and visited_as_base<procedure_runner<reset_procedure>>);
STATIC_CHECK(not visited_as_base<procedure_conversation>);
struct with_own_properties : stop {
    static constexpr conversation_properties properties = stop::properties;
};
STATIC_CHECK(not visited_as_base<with_own_properties>);
struct counting_stop : stop {
    using stop::stop;
    unsigned outcomes{0};

    constexpr void accept(result<response> const& outcome) noexcept
    {
        ++outcomes;
        stop::accept(outcome);
    }
};
constexpr bool hears_of_its_outcome()
{
    counting_stop conversation{drive};
    drive_client<> link{line_timing{19'200, character_format::even_8_1}};
    instant now = start_time;
    for (unsigned i = 0; i < 40 and conversation.outcomes == 0; ++i) {
        link.advance(now);
        link.converse(conversation, now);
        if (not link.poll_transmit().empty()) {
            link.sent(now);
        }
        now = now + milliseconds(500);
    }
    return conversation.outcomes == 1;
}
PROOF("a class that hides a function of its procedure gets its calls", hears_of_its_outcome)

} // namespace
