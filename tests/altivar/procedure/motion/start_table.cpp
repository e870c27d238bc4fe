// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// The table of a start: each stage and each answer, as it stands beside the code.
#include <rtuwire/altivar/procedure/motion/start.hpp>

#include "altivar/procedure/step_table.hpp"
#include "support/catch.hpp"
#include "support/commissioned.hpp"

#include <rtuwire/altivar/atv320.hpp>

using namespace rtuwire;
using namespace rtuwire::altivar;
using namespace rtuwire::test;
using kind = outcome_kind;

namespace {

constexpr auto const& layout = atv320::device::layout;
constexpr std::uint16_t disabled = 0x0250, ready = 0x0231, on = 0x0233, enabled = 0x0237;

constexpr cell eta = reads(layout.eta), lft = reads(layout.lft), cmd = reads(layout.cmd), chcf = reads(8401);
constexpr cell reference = writes(8602, 1'500), read_reference = reads(8602), shut_down = writes(layout.cmd, 0x0006);
constexpr cell switch_on = writes(layout.cmd, 0x0007), enable = writes(layout.cmd, 0x000F);

/// The commands are withdrawn: of a motor that cannot turn yet, and of one that may.
constexpr cell undo(kind how) { return then(writes(layout.cmd, 0x0000), how); }
constexpr cell ramp(kind how) { return then(writes(layout.cmd, 0x0007), how); }

constexpr errc missing = errc::illegal_data_address;

constexpr std::array<answer, 13> answers{{
    {"switch on disabled", word(disabled)},
    {"ready to switch on", word(ready)},
    {"switched on", word(on)},
    {"operation enabled", word(enabled)},
    {"quick stop active", word(0x0217)},
    {"fault", word(0x0238)},
    {"local control", word(0x0031)},
    {"STOP key", word(0x4231)},
    {"no state", word(0x0201)},
    {"confirmed", confirmed},
    {"no response", failed(errc::timed_out)},
    {"refused", failed(missing)},
    {"limit over", late},
}};

constexpr start_procedure checked_before{
    layout, {8602, 1'500}, run_direction::forward, supervision_procedure{layout, commissioned()}};
constexpr start_procedure unchecked{
    layout, {8602, 1'500}, run_direction::forward, supervision_procedure{layout, unlimited}};

constexpr cell x = never;
constexpr cell local = ends(kind::local_control), silent = ends(kind::silent), refused = ends(kind::refused);
constexpr cell overwritten = ends(kind::overwritten);
constexpr cell lowest = reads(3105);
constexpr cell timeout = ends(kind::state_timeout), aborted = ends(kind::aborted), fault = ends(kind::in_fault);

// clang-format off
constexpr std::array<stage_row<13>, 19> rows{{
    // stage, and the way there
    //   disabled, ready, switched on, enabled, quick stop, fault, local, STOP key,
    //   no state or another word, confirmed, no response, refused, limit over
    {"meeting", {begun},
     {shut_down, switch_on, switch_on, cmd, pauses, lft, local, switch_on,
      pauses, x, silent, refused, aborted}},
    {"enabling, to be confirmed", {begun, word(ready)},
     {x, x, x, x, x, x, x, x,
      x, eta, eta, undo(kind::refused), undo(kind::state_timeout)}},
    {"enabling, at a look", {begun, word(ready), confirmed},
     {undo(kind::fell_back), pauses, reference, ramp(kind::overwritten), undo(kind::fell_back), lft, undo(kind::local_control), undo(kind::stop_key),
      undo(kind::fell_back), x, eta, undo(kind::refused), undo(kind::state_timeout)}},
    {"writing the reference", {begun, word(on), confirmed, word(on)},
     {x, x, x, x, x, x, x, x,
      x, read_reference, eta, undo(kind::refused), undo(kind::state_timeout)}},
    {"reading the reference", {begun, word(on), confirmed, word(on), confirmed},
     {x, x, x, x, x, x, x, x,
      undo(kind::overwritten), x, eta, undo(kind::refused), undo(kind::state_timeout)}},
    {"checking", {begun, word(on), confirmed, word(on), confirmed, word(1'500)},
     {x, x, x, x, x, x, x, x,
      undo(kind::overwritten), x, eta, undo(kind::refused), undo(kind::state_timeout)}},
    {"enabled, to be confirmed", {begun, word(on), confirmed, word(on), confirmed, word(1'500), word(7)},
     {x, x, x, x, x, x, x, x,
      x, chcf, eta, ramp(kind::refused), ramp(kind::state_timeout)}},
    {"examining the profile", {begun, word(on), confirmed, word(on), confirmed, word(1'500), word(7), confirmed},
     {x, x, x, x, x, x, x, x,
      ramp(kind::not_drive_profile), x, eta, ramp(kind::refused), ramp(kind::state_timeout)}},
    {"enabled, at a look", {begun, word(on), confirmed, word(on), confirmed, word(1'500), word(7), confirmed, word(2)},
     {ramp(kind::fell_back), ramp(kind::fell_back), pauses, read_reference, ramp(kind::fell_back), lft, ramp(kind::local_control), ramp(kind::stop_key),
      ramp(kind::fell_back), x, eta, ramp(kind::refused), ramp(kind::state_timeout)}},
    {"reading the reference in operation", {begun, word(on), confirmed, word(on), confirmed, word(1'500), word(7), confirmed, word(2), word(enabled)},
     {x, x, x, x, x, x, x, x,
      ramp(kind::overwritten), x, eta, ramp(kind::refused), ramp(kind::state_timeout)}},
    {"checking in operation", {begun, word(on), confirmed, word(on), confirmed, word(1'500), word(7), confirmed, word(2), word(enabled), word(1'500)},
     {x, x, x, x, x, x, x, x,
      ramp(kind::overwritten), x, eta, ramp(kind::refused), ramp(kind::state_timeout)}},
    {"reading HSP of one that limits its reference", {begun, word(on), confirmed, word(on), confirmed, word(1'500), word(7), confirmed, word(2), word(0x0A37)},
     {lowest, lowest, lowest, lowest, lowest, lowest, lowest, lowest,
      lowest, x, eta, read_reference, ramp(kind::state_timeout)}},
    {"reading LSP of the same", {begun, word(on), confirmed, word(on), confirmed, word(1'500), word(7), confirmed, word(2), word(0x0A37), word(500)},
     {read_reference, read_reference, read_reference, read_reference, read_reference, read_reference, read_reference, read_reference,
      read_reference, x, eta, read_reference, ramp(kind::state_timeout)}},
    {"reading the direction", {begun, word(enabled)},
     {x, x, x, x, x, x, x, x,
      overwritten, x, silent, refused, timeout}},
    {"redirecting", {begun, word(enabled), word(0x000F)},
     {x, x, x, x, x, x, x, x,
      x, read_reference, eta, refused, timeout}},
    {"reading the reference of one that ran already", {begun, word(enabled), word(0x000F), confirmed},
     {x, x, x, x, x, x, x, x,
      ramp(kind::overwritten), x, eta, ramp(kind::refused), ramp(kind::state_timeout)}},
    {"checking one that ran already", {begun, word(enabled), word(0x000F), confirmed, word(1'500)},
     {x, x, x, x, x, x, x, x,
      ramp(kind::overwritten), x, eta, ramp(kind::refused), ramp(kind::state_timeout)}},
    {"reading the fault of a drive that was not commanded", {begun, word(0x0238)},
     {x, x, x, x, x, x, x, x,
      fault, x, silent, refused, fault}},
    {"reading the fault of one that was", {begun, word(ready), confirmed, word(0x0238)},
     {x, x, x, x, x, x, x, x,
      undo(kind::in_fault), x, eta, undo(kind::refused), undo(kind::in_fault)}},
}};
// clang-format on

} // namespace

TEST_CASE("a start does in each stage, at each answer, what its table says")
{
    check_table(checked_before, answers, rows);
}

TEST_CASE("a start at 0 in reverse, or of a motor that turns in reverse, is sent with the sign for it")
{
    supervision_procedure const check{layout, commissioned()};
    start_procedure const ahead{layout, {8602, 0}, run_direction::forward, check};
    start_procedure const back{layout, {8602, 0}, run_direction::reverse, check};
    constexpr std::uint16_t runs_back = 0x8237, disabled_back = 0x8250;
    constexpr cell least_back = writes(8602, 0xFFFF), zero = writes(8602, 0), least = writes(8602, 1);
    CHECK(does(led(back, {begun, word(on), confirmed}), word(on), least_back));
    CHECK(does(led(ahead, {begun, word(on), confirmed}), word(on), zero));
    CHECK(does(led(ahead, {begun, word(disabled_back), confirmed, word(ready), confirmed}), word(on), zero));
    CHECK(does(led(ahead, {begun, word(runs_back)}), word(0x000F), least_back));
    CHECK(does(led(ahead, {begun, word(runs_back)}), word(0x080F), least));
    CHECK(does(led(ahead, {begun, word(enabled)}), word(0x000F), zero));
    CHECK(does(led(ahead, {begun, word(enabled)}), word(0x080F), least_back));
    CHECK(does(led(back, {begun, word(enabled)}), word(0x080F), least));
}

TEST_CASE("a start that checks its drive first ends with the check")
{
    way const examining{begun, word(disabled)};
    CHECK(does(led(unchecked, examining), failed(errc::timed_out), silent));
    CHECK(does(led(unchecked, examining), failed(missing), ends(kind::unknown_register)));
    CHECK(does(led(unchecked, examining), late, aborted));
}

TEST_CASE("a start enables a drive whose control word and reference are the ones that it wrote")
{
    way const wrote{begun, word(on), confirmed, word(on), confirmed};
    CHECK(does(led(checked_before, wrote), word(1'500), cmd));
    CHECK(does(led(checked_before, {begun, word(on), confirmed, word(on), confirmed, word(1'500)}), word(0x0007),
               enable));
    way const runs{begun, word(enabled)};
    CHECK(does(led(checked_before, runs), word(0x000F), writes(8602, 1'500)));
    CHECK(
        does(led(checked_before, {begun, word(enabled), word(0x000F), confirmed, word(1'500)}), word(0x000F), enable));
    constexpr cell enable_back = writes(layout.cmd, 0x080F);
    constexpr std::uint16_t back = 0xFA24; // -1500
    CHECK(does(led(checked_before, {begun, word(enabled), word(0x090F), confirmed, word(back)}), word(0x090F),
               enable_back));
    CHECK(does(led(checked_before, {begun, word(enabled), word(0x090F), confirmed, word(back)}), word(0x080F),
               ramp(kind::overwritten)));
    CHECK(does(led(checked_before, {begun, word(enabled), word(0x090F), confirmed}), word(1'500),
               ramp(kind::overwritten)));
}

TEST_CASE("a start that finds its drive above the state that its words explain ends as overwritten")
{
    way const shut_down_from_here{begun, word(disabled), confirmed};
    CHECK(does(led(checked_before, shut_down_from_here), word(ready), switch_on));
    CHECK(does(led(checked_before, shut_down_from_here), word(on), undo(kind::overwritten)));
    CHECK(does(led(checked_before, shut_down_from_here), word(enabled), ramp(kind::overwritten)));
    // Before the first word, where the drive itself can have come to "switch on disabled" only.
    way const waits{begun, word(0x0200), pause_over};
    CHECK(does(led(checked_before, waits), word(disabled), shut_down));
    CHECK(does(led(checked_before, waits), word(ready), overwritten));
    CHECK(does(led(checked_before, {begun, word(0x0217), pause_over}), word(enabled), overwritten));
    CHECK(does(led(checked_before, {begun, word(0x0201), pause_over}), word(enabled), cmd)); // it may have run before
    // One that was not answered may have arrived.
    CHECK(does(led(checked_before, {begun, word(ready), failed(errc::timed_out)}), word(on), switch_on));
}

TEST_CASE("a start reads a reference that is the neighbour of the control word together with that")
{
    constexpr std::uint16_t thirty_hertz = 300, other = 0xFE0C;
    constexpr start_procedure go{
        layout, {8502, thirty_hertz}, run_direction::forward, supervision_procedure{layout, commissioned()}};
    way const wrote{begun, word(on), confirmed, word(on)};
    start_procedure it = led(go, wrote);
    action const both = it.step(confirmed);
    CHECK((what_of(both) == action_kind::read and address_of(both) == layout.cmd and count_of(both) == 2));
    CHECK(does(it, words(0x0007, thirty_hertz), enable));
    CHECK(does(it, words(0x0007, other), undo(kind::overwritten)));
    CHECK(does(it, words(0x0006, thirty_hertz), undo(kind::overwritten)));
    for (event each : {words(0x0007, thirty_hertz), confirmed, word(1)}) {
        static_cast<void>(it.step(each));
    }
    CHECK(count_of(it.step(word(enabled))) == 2);
    CHECK(does(it, words(0x000F, thirty_hertz), ends(kind::succeeded)));
    CHECK(does(it, words(0x000F, other), ramp(kind::overwritten)));
    CHECK(does(it, words(0x080F, thirty_hertz), ramp(kind::overwritten)));
}

TEST_CASE("a start of a drive that limits the reference reads no limit that it knows, or that the drive does not have")
{
    static constexpr drive_layout without = [] {
        drive_layout some = layout;
        some.hsp = 0;
        return some;
    }();
    constexpr supervision_report known = [] {
        supervision_report found = commissioned();
        found.limits.highest = 2'000;
        return found;
    }();
    constexpr run_direction forward = run_direction::forward;
    constexpr start_procedure knows{layout, {8602, 1'500}, forward, supervision_procedure{layout, known}};
    constexpr start_procedure elsewhere{
        without, {8602, 1'500}, forward, supervision_procedure{without, commissioned()}};
    constexpr std::uint16_t limited = 0x0A37;
    way const runs{begun, word(on), confirmed, word(on), confirmed, word(1'500), word(0x0007), confirmed, word(1)};
    CHECK(does(led(checked_before, runs), word(limited), reads(layout.hsp)));
    CHECK(does(led(knows, runs), word(limited), read_reference));
    CHECK(does(led(elsewhere, runs), word(limited), read_reference));
}
