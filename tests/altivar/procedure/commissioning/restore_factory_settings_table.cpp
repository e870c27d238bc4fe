// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// The table of a restore of the factory settings: each stage and each answer, as it stands beside the code.
#include <rtuwire/altivar/procedure/commissioning/restore_factory_settings.hpp>

#include "altivar/procedure/status_words.hpp"
#include "altivar/procedure/step_table.hpp"
#include "support/catch.hpp"

#include <rtuwire/altivar/atv28.hpp>
#include <rtuwire/altivar/atv310.hpp>
#include <rtuwire/altivar/atv320.hpp>

using namespace rtuwire;
using namespace rtuwire::altivar;
using namespace rtuwire::test;
using kind = outcome_kind;

namespace {

constexpr std::uint16_t cmi = 8504;
constexpr cell eta = reads(3201), lft = reads(7121), inputs = reads(5202), control = reads(cmi);
constexpr cell x = never;
constexpr cell silent = ends(kind::silent), refused = ends(kind::refused), aborted = ends(kind::aborted);
constexpr cell fault = ends(kind::in_fault), closed = ends(kind::run_input_closed);
constexpr cell running = ends(kind::refused_while_running), lacking = ends(kind::unknown_register);
constexpr cell maybe = ends(kind::executed_unconfirmed);

/// CMI had this word beside its orders.
constexpr std::uint16_t kept = 0x8200;
constexpr cell clear = writes(cmi, kept);

constexpr std::array<stage_row<12>, 1> look_rows{{
    {"a look",
     {begun},
     {aborted, inputs, inputs, inputs, running, running, lft, inputs, aborted, silent, refused, silent}},
}};
constexpr std::array<stage_row<12>, 1> unseen_rows{{
    {"a look",
     {begun},
     {aborted, lacking, lacking, lacking, running, running, lft, lacking, aborted, silent, refused, silent}},
}};
constexpr std::array<stage_row<12>, 1> trusting_rows{{
    {"a look",
     {begun},
     {aborted, control, control, control, running, running, lft, control, aborted, silent, refused, silent}},
}};

constexpr std::array<answer, 8> others{{
    {"0", word(0)},
    {"1", word(1)},
    {"8203", word(kept | 3)},
    {"confirmed", confirmed},
    {"pause over", pause_over},
    {"no response", failed(errc::timed_out)},
    {"refused", failed(errc::server_device_failure)},
    {"limit over", late},
}};

constexpr event disabled = word(disabled_word), control_read = word(kept | 3);

// clang-format off
constexpr std::array<stage_row<8>, 6> rows{{
    // stage, and the way there
    //   0, 1, 8203
    //   confirmed, pause over, no response, refused, limit over
    {"looking: the fault", {begun, word(reaction_word)},
     {fault, fault, fault,
      x, x, silent, refused, silent}},
    {"looking: the inputs", {begun, word(fault_word)},
     {control, closed, closed,
      x, x, silent, refused, silent}},
    {"reading the control word", {begun, disabled, word(0)},
     {writes(cmi, 1), writes(cmi, 1), writes(cmi, kept | 1),
      x, x, silent, refused, silent}},
    {"ordering", {begun, disabled, word(0), control_read},
     {x, x, x,
      pauses, x, silent, refused, silent}},
    {"a wait while it restores", {begun, disabled, word(0), control_read, confirmed},
     {x, x, x,
      x, clear, silent, x, silent}},
    {"taking back", {begun, disabled, word(0), control_read, confirmed, pause_over},
     {x, x, x,
      maybe, x, maybe, maybe, maybe}},
}};
// clang-format on

constexpr factory_procedure restore{atv320::device::layout, {}}, unseen{atv310::device::layout, {}};
constexpr factory_procedure trusting{atv310::device::layout, {.accept_unseen_inputs = true}};
constexpr factory_procedure old{atv28::device::layout, {}};

} // namespace

TEST_CASE("a restore of the factory settings does at its look what its table says")
{
    check_table(restore, looks, look_rows);
    check_table(unseen, looks, unseen_rows);
    check_table(trusting, looks, trusting_rows);
    CHECK(does(restore, begun, eta));
}

TEST_CASE("a restore of the factory settings does in each stage, at each answer, what its table says")
{
    check_table(restore, others, rows);
    CHECK(does(led(restore, {begun, disabled}), failed(errc::illegal_data_address), lacking));
}

TEST_CASE("a restore of the factory settings repeats no order of CMI, not even a recall")
{
    CHECK(does(led(old, {begun, disabled, word(0)}), word(kept | 7), writes(402, kept | 1)));
}
