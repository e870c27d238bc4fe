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
/// The order is cleared, whatever comes of it.
constexpr cell undo = then(writes(cmi, kept), kind::executed_unconfirmed);

constexpr std::array<stage_row<12>, 1> look_rows{{
    {"a look",
     {begun},
     {aborted, inputs, inputs, inputs, running, running, lft, inputs, aborted, silent, refused, aborted}},
}};
constexpr std::array<stage_row<12>, 1> unseen_rows{{
    {"a look",
     {begun},
     {aborted, lacking, lacking, lacking, running, running, lft, lacking, aborted, silent, refused, aborted}},
}};
constexpr std::array<stage_row<12>, 1> trusting_rows{{
    {"a look",
     {begun},
     {aborted, control, control, control, running, running, lft, control, aborted, silent, refused, aborted}},
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
constexpr std::array<stage_row<8>, 7> rows{{
    // stage, and the way there
    //   0, 1, 8203
    //   confirmed, pause over, no response, refused, limit over
    {"looking: the fault", {begun, word(reaction_word)},
     {fault, fault, fault,
      x, x, silent, refused, fault}},
    {"looking: the inputs", {begun, word(fault_word)},
     {control, closed, closed,
      x, x, silent, refused, aborted}},
    {"reading the control word", {begun, disabled, word(0)},
     {writes(cmi, 1), writes(cmi, 1), writes(cmi, kept | 1),
      x, x, silent, refused, aborted}},
    {"ordering", {begun, disabled, word(0), control_read},
     {x, x, x,
      pauses, x, pauses, refused, aborted}},
    {"a wait while it restores", {begun, disabled, word(0), control_read, confirmed},
     {x, x, x,
      x, undo, x, x, undo}},
    {"a wait after no response to the order", {begun, disabled, word(0), control_read, failed(errc::timed_out)},
     {x, x, x,
      x, undo, x, x, undo}},
    {"taking back", {begun, disabled, word(0), control_read, confirmed, pause_over},
     {x, x, x,
      maybe, x, maybe, maybe, undo}},
}};
// clang-format on

constexpr cmi_order_procedure restore{atv320::device::layout, {}, factory_order};
constexpr cmi_order_procedure unseen{atv310::device::layout, {}, factory_order};
constexpr cmi_order_procedure trusting{atv310::device::layout, {.accept_unseen_inputs = true}, factory_order};
constexpr cmi_order_procedure old{atv28::device::layout, {}, factory_order};

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

TEST_CASE("a restore is sent once, and silent only before that")
{
    way const ordering{begun, disabled, word(0)};
    cmi_order_procedure it = led(restore, ordering);
    CHECK(repetition_of(it.step(control_read)) == repetition::never);
    // A unit that is lost before the order is sent, and after it.
    CHECK(does(it, failed(errc::unit_lost), silent));
    CHECK(does(led(it, {confirmed}), failed(errc::unit_lost), maybe));
    CHECK(does(led(it, {failed(errc::timed_out)}), failed(errc::unit_lost), maybe));
}
