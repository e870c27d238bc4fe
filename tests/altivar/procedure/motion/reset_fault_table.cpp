// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// The tables of a reset: each stage and each answer, as they stand beside the code.
#include <rtuwire/altivar/procedure/motion/reset_fault.hpp>

#include "altivar/procedure/status_words.hpp"
#include "altivar/procedure/step_table.hpp"
#include "support/catch.hpp"

#include <rtuwire/altivar/atv12.hpp>

using namespace rtuwire;
using namespace rtuwire::detail;
using namespace rtuwire::altivar;
using namespace rtuwire::test;
using kind = outcome_kind;

namespace {

constexpr auto const& layout = atv12::device::layout;

constexpr cell eta = reads(layout.eta), low = writes(layout.cmd, 0x0000), high = writes(layout.cmd, 0x0080);
constexpr cell x = never;
constexpr cell done = ends(kind::succeeded), silent = ends(kind::silent), refused = ends(kind::refused);
constexpr cell aborted = ends(kind::aborted), too_late = ends(kind::state_timeout), fault = ends(kind::in_fault);
/// The limit is over, and the drive was last read in fault: LFT is read for the outcome.
constexpr cell code = then(reads(layout.lft), kind::in_fault);

/// Bit 7 is written low, whatever comes of it.
[[nodiscard]] constexpr cell undo(kind how) { return then(low, how); }

constexpr event in_fault = word(fault_word), in_reaction = word(reaction_word), in_no_state = word(no_state_word);

// clang-format off
constexpr std::array<stage_row<12>, 7> look_rows{{
    // stage, and the way there
    //   1, 2, 3, 4, 5, 6, 7, 8, no state, no response, refused, limit over
    {"the first look", {begun},
     {eta, eta, eta, eta, eta, eta, pauses, low, pauses, silent, refused, aborted}},
    {"the second look", {begun, word(0x0250)},
     {pauses, done, pauses, pauses, pauses, pauses, pauses, low, pauses, silent, refused, aborted}},
    {"a look after a fault reaction", {begun, in_reaction, pause_over},
     {eta, eta, eta, eta, eta, eta, pauses, low, pauses, silent, refused, code}},
    {"a look after no state", {begun, in_no_state, pause_over},
     {eta, eta, eta, eta, eta, eta, pauses, low, pauses, silent, refused, aborted}},
    {"the first look after the reset", {begun, in_fault, confirmed, confirmed, confirmed},
     {done, done, done, done, done, done, pauses, pauses, pauses, silent, refused, too_late}},
    {"a look that finds the fault again", {begun, in_fault, confirmed, confirmed, confirmed, in_fault, pause_over},
     {done, done, done, done, done, done, pauses, pauses, pauses, silent, refused, code}},
    {"a look after the reset and no state",
     {begun, in_fault, confirmed, confirmed, confirmed, in_no_state, pause_over},
     {done, done, done, done, done, done, pauses, pauses, pauses, silent, refused, too_late}},
}};
// clang-format on

constexpr std::array<answer, 7> others{{
    {"no fault", word(0)},
    {"a fault", word(18)},
    {"confirmed", confirmed},
    {"pause over", pause_over},
    {"no response", failed(errc::timed_out)},
    {"refused", failed(errc::server_device_failure)},
    {"limit over", late},
}};
constexpr std::array<stage_row<7>, 10> other_rows{{
    {"bit 7 low", {begun, in_fault}, {x, x, high, x, silent, refused, code}},
    {"bit 7 high", {begun, in_fault, confirmed}, {x, x, low, x, undo(kind::silent), undo(kind::refused), code}},
    {"bit 7 low again",
     {begun, in_fault, confirmed, confirmed},
     {x, x, eta, x, undo(kind::silent), undo(kind::refused), undo(kind::state_timeout)}},
    {"bit 7 low after no response to it high",
     {begun, in_fault, confirmed, failed(errc::timed_out)},
     {x, x, silent, x, silent, silent, undo(kind::silent)}},
    {"bit 7 low after a refusal of it low",
     {begun, in_fault, confirmed, confirmed, failed(errc::server_device_failure)},
     {x, x, refused, x, refused, refused, undo(kind::refused)}},
    {"a wait in a fault reaction", {begun, in_reaction}, {x, x, x, eta, silent, x, code}},
    {"a wait in no state", {begun, in_no_state}, {x, x, x, eta, silent, x, aborted}},
    {"a wait in fault after the reset",
     {begun, in_fault, confirmed, confirmed, confirmed, in_fault},
     {x, x, x, eta, silent, x, code}},
    {"a wait in no state after the reset",
     {begun, in_fault, confirmed, confirmed, confirmed, in_no_state},
     {x, x, x, eta, silent, x, too_late}},
    {"reading the fault", {begun, in_fault, late}, {fault, fault, x, x, silent, refused, x}},
}};

constexpr reset_procedure reset{layout};

} // namespace

TEST_CASE("a reset of a fault does at each look what its table says") { check_table(reset, looks, look_rows); }

TEST_CASE("a reset of a fault does in each stage, at each answer, what its table says")
{
    check_table(reset, others, other_rows);
}

TEST_CASE("a reset of a fault begins with a look") { CHECK(does(reset, begun, eta)); }

TEST_CASE("a reset of a fault ends at any of its writes where the client has no place for one more drive")
{
    for (way const& to_write : {way{begun, in_fault}, way{begun, in_fault, confirmed}}) {
        CHECK(does(led(reset, to_write), failed(errc::too_many_ordered), ends(kind::no_place)));
        CHECK(does(led(reset, to_write), failed(errc::unit_lost), silent));
    }
    // Bit 7 is high then; the word that takes it away needs no place, because it also stops.
    reset_procedure it = led(reset, {begun, in_fault, confirmed, confirmed});
    CHECK(does(it, failed(errc::too_many_ordered), undo(kind::no_place)));
    CHECK(does(it, failed(errc::unit_lost), undo(kind::silent)));
    CHECK(effect_of(it.step(failed(errc::too_many_ordered))) == effect::stopping);
}
