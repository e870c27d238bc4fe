// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// The table of a recall of the saved settings: each stage and each answer, as it stands beside the code.
#include <rtuwire/altivar/procedure/commissioning/recall_from_eeprom.hpp>

#include "altivar/procedure/status_words.hpp"
#include "altivar/procedure/step_table.hpp"
#include "support/catch.hpp"

#include <rtuwire/altivar/atv28.hpp>

using namespace rtuwire;
using namespace rtuwire::altivar;
using namespace rtuwire::test;
using kind = outcome_kind;

namespace {

constexpr std::uint16_t cmi = 402;
constexpr cell eta = reads(458), lft = reads(457), inputs = reads(478), control = reads(cmi);
constexpr cell x = never;
constexpr cell done = ends(kind::succeeded), silent = ends(kind::silent), refused = ends(kind::refused);
constexpr cell aborted = ends(kind::aborted), fault = ends(kind::in_fault), closed = ends(kind::run_input_closed);
constexpr cell running = ends(kind::refused_while_running), lacking = ends(kind::unknown_register);
constexpr cell maybe = ends(kind::executed_unconfirmed), not_taken = ends(kind::not_taken);

/// CMI had this word beside its orders.
constexpr std::uint16_t kept = 0x8200;
/// The order is cleared, whatever comes of it.
[[nodiscard]] constexpr cell undo(kind how) { return then(writes(cmi, kept), how); }

constexpr std::array<stage_row<12>, 1> look_rows{{
    {"a look",
     {begun},
     {aborted, inputs, inputs, inputs, running, running, lft, lft, aborted, silent, refused, aborted}},
}};

constexpr std::array<answer, 9> others{{
    {"0", word(0)},
    {"1", word(1)},
    {"4", word(4)},
    {"8207", word(kept | 7)},
    {"confirmed", confirmed},
    {"pause over", pause_over},
    {"no response", failed(errc::timed_out)},
    {"refused", failed(errc::server_device_failure)},
    {"limit over", late},
}};

constexpr event disabled = word(disabled_word), control_read = word(kept | 7);

// clang-format off
constexpr std::array<stage_row<9>, 10> rows{{
    // stage, and the way there
    //   0, 1, 4, 8207
    //   confirmed, pause over, no response, refused, limit over
    {"looking: the fault", {begun, word(fault_word)},
     {fault, fault, fault, fault,
      x, x, silent, refused, fault}},
    {"looking: the inputs", {begun, disabled},
     {control, closed, control, closed,
      x, x, silent, refused, aborted}},
    {"reading the control word", {begun, disabled, word(0)},
     {writes(cmi, 4), writes(cmi, 4), writes(cmi, 4), writes(cmi, kept | 4),
      x, x, silent, refused, aborted}},
    {"ordering", {begun, disabled, word(0), control_read},
     {x, x, x, x,
      pauses, x, pauses, refused, aborted}},
    {"a wait while it recalls", {begun, disabled, word(0), control_read, confirmed},
     {x, x, x, x,
      x, control, maybe, x, undo(kind::executed_unconfirmed)}},
    {"a wait after no response to the order", {begun, disabled, word(0), control_read, failed(errc::timed_out)},
     {x, x, x, x,
      x, control, maybe, x, undo(kind::executed_unconfirmed)}},
    {"confirming", {begun, disabled, word(0), control_read, confirmed, pause_over},
     {done, done, undo(kind::not_taken), undo(kind::not_taken),
      x, x, undo(kind::executed_unconfirmed), undo(kind::executed_unconfirmed), undo(kind::executed_unconfirmed)}},
    {"confirming after no response to the order", {begun, disabled, word(0), control_read, failed(errc::timed_out), pause_over},
     {maybe, maybe, undo(kind::not_taken), undo(kind::not_taken),
      x, x, undo(kind::executed_unconfirmed), undo(kind::executed_unconfirmed), undo(kind::executed_unconfirmed)}},
    {"taking back", {begun, disabled, word(0), control_read, confirmed, pause_over, word(4)},
     {x, x, x, x,
      not_taken, x, not_taken, not_taken, undo(kind::not_taken)}},
    {"taking back after the limit", {begun, disabled, word(0), control_read, confirmed, late},
     {x, x, x, x,
      maybe, x, maybe, maybe, x}},
}};
// clang-format on

constexpr cmi_order_procedure recall{atv28::device::layout, {}, recall_order};

} // namespace

TEST_CASE("a recall of the settings does at its look what its table says")
{
    check_table(recall, looks, look_rows);
    CHECK(does(recall, begun, eta));
}

TEST_CASE("a recall of the settings does in each stage, at each answer, what its table says")
{
    check_table(recall, others, rows);
    CHECK(does(led(recall, {begun, disabled}), failed(errc::illegal_data_address), lacking));
}

TEST_CASE("a recall is sent once, and silent only before that")
{
    cmi_order_procedure it = led(recall, {begun, disabled, word(0)});
    CHECK(repetition_of(it.step(control_read)) == repetition::never);
    // A unit that is lost before the order is sent, and after it.
    CHECK(does(it, failed(errc::unit_lost), silent));
    CHECK(does(led(it, {confirmed}), failed(errc::unit_lost), maybe));
    CHECK(does(led(it, {confirmed, pause_over}), failed(errc::unit_lost), maybe));
}
