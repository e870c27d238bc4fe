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
constexpr cell clear = writes(cmi, kept);

constexpr std::array<stage_row<12>, 1> look_rows{{
    {"a look",
     {begun},
     {aborted, inputs, inputs, inputs, running, running, lft, lft, aborted, silent, refused, silent}},
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
constexpr std::array<stage_row<9>, 7> rows{{
    // stage, and the way there
    //   0, 1, 4, 8207
    //   confirmed, pause over, no response, refused, limit over
    {"looking: the fault", {begun, word(fault_word)},
     {fault, fault, fault, fault,
      x, x, silent, refused, silent}},
    {"looking: the inputs", {begun, disabled},
     {control, closed, control, closed,
      x, x, silent, refused, silent}},
    {"reading the control word", {begun, disabled, word(0)},
     {writes(cmi, 4), writes(cmi, 4), writes(cmi, 4), writes(cmi, kept | 4),
      x, x, silent, refused, silent}},
    {"ordering", {begun, disabled, word(0), control_read},
     {x, x, x, x,
      pauses, x, maybe, refused, maybe}},
    {"a wait while it recalls", {begun, disabled, word(0), control_read, confirmed},
     {x, x, x, x,
      x, control, maybe, x, maybe}},
    {"confirming", {begun, disabled, word(0), control_read, confirmed, pause_over},
     {done, done, clear, clear,
      x, x, maybe, refused, maybe}},
    {"taking back", {begun, disabled, word(0), control_read, confirmed, pause_over, word(4)},
     {x, x, x, x,
      not_taken, x, silent, refused, silent}},
}};
// clang-format on

constexpr recall_procedure recall{atv28::device::layout, {}};

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
