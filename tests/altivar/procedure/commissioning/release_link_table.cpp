// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// The tables of a release of the link and of its opposite: each stage and each answer, as they stand beside the code.
#include <rtuwire/altivar/procedure/commissioning/release_link.hpp>

#include "altivar/procedure/status_words.hpp"
#include "altivar/procedure/step_table.hpp"
#include "support/catch.hpp"

using namespace rtuwire;
using namespace rtuwire::altivar;
using namespace rtuwire::test;
using kind = outcome_kind;

namespace {

constexpr std::uint16_t command = 400;
constexpr cell eta = reads(458), eti = reads(459), lft = reads(457), wiring = reads(6), inputs = reads(478);
constexpr cell look = reads(457); // and ETA behind it
constexpr cell told_release = writes(command, 0x8100), told_activate = writes(command, 0x8000);
/// The word that takes the motor's power away, whatever comes of it; and where the motor was read to run.
[[nodiscard]] constexpr cell cut_as(kind how) { return then(told_activate, how); }
constexpr cell cut = cut_as(kind::started_by_terminals);
/// After the word of the release was sent no end without another look.
[[nodiscard]] constexpr cell look_as(kind how) { return then(look, how); }
constexpr cell look_silent = look_as(kind::silent), look_refused = look_as(kind::refused);
constexpr cell look_aborted = look_as(kind::aborted);
constexpr cell x = never;
constexpr cell done = ends(kind::succeeded), silent = ends(kind::silent), refused = ends(kind::refused);
constexpr cell aborted = ends(kind::aborted), fault = ends(kind::in_fault), closed = ends(kind::run_input_closed);
constexpr cell running = ends(kind::refused_while_running), lacking = ends(kind::unknown_register);
constexpr cell not_taken = ends(kind::not_taken), started = ends(kind::started_by_terminals);

constexpr event disabled = word(disabled_word), missing = failed(errc::illegal_data_address);
constexpr event by_terminals = word(0x0000), by_link = word(0x4000);

// clang-format off
constexpr std::array<stage_row<12>, 4> release_looks{{
    // 1, 2, 3, 4, 5, 6, 7, 8
    // no state, no response, refused, limit over
    {"a look", {begun},
     {aborted, wiring, wiring, wiring, running, running, lft, lft,
      aborted, silent, refused, aborted}},
    {"confirming", {begun, disabled, word(1), confirmed, pause_over},
     {aborted, eti, eti, eti, cut, cut, lft, lft,
      cut_as(kind::aborted), cut_as(kind::silent), cut_as(kind::refused), look_aborted}},
    {"closing after no response to the word", {begun, disabled, word(1), failed(errc::timed_out)},
     {silent, silent, silent, silent, cut, cut, lft, lft,
      cut_as(kind::silent), cut_as(kind::silent), cut_as(kind::silent), cut_as(kind::silent)}},
    {"closing after the limit", {begun, disabled, word(1), confirmed, late},
     {aborted, aborted, aborted, aborted, cut, cut, lft, lft,
      cut_as(kind::aborted), cut_as(kind::aborted), cut_as(kind::aborted), cut_as(kind::aborted)}},
}};
constexpr std::array<stage_row<12>, 4> activate_looks{{
    {"a look", {begun},
     {aborted, told_activate, told_activate, told_activate, running, running, lft, lft,
      aborted, silent, refused, aborted}},
    {"confirming", {begun, disabled, confirmed, pause_over},
     {aborted, eti, eti, eti, cut, cut, lft, lft,
      cut_as(kind::aborted), cut_as(kind::silent), cut_as(kind::refused), look_aborted}},
    {"closing after no response to the word", {begun, disabled, failed(errc::timed_out)},
     {silent, silent, silent, silent, cut, cut, lft, lft,
      cut_as(kind::silent), cut_as(kind::silent), cut_as(kind::silent), cut_as(kind::silent)}},
    {"closing after the limit", {begun, disabled, confirmed, late},
     {aborted, aborted, aborted, aborted, cut, cut, lft, lft,
      cut_as(kind::aborted), cut_as(kind::aborted), cut_as(kind::aborted), cut_as(kind::aborted)}},
}};

constexpr std::array<answer, 9> others{{
    {"0", by_terminals},
    {"1", word(1)},
    {"by the link", by_link},
    {"confirmed", confirmed},
    {"pause over", pause_over},
    {"no response", failed(errc::timed_out)},
    {"no such register", missing},
    {"refused otherwise", failed(errc::server_device_failure)},
    {"limit over", late},
}};
constexpr std::array<stage_row<9>, 12> release_rows{{
    // stage, and the way there
    //   0, 1, by the link
    //   confirmed, pause over, no response, no such register, refused otherwise, limit over
    {"looking: the fault", {begun, word(fault_word)},
     {fault, fault, fault,
      x, x, silent, refused, refused, fault}},
    {"looking: TCC", {begun, disabled},
     {inputs, told_release, inputs,
      x, x, silent, inputs, refused, aborted}},
    {"looking: the inputs", {begun, disabled, word(0)},
     {told_release, closed, told_release,
      x, x, silent, lacking, refused, aborted}},
    {"telling", {begun, disabled, word(1)},
     {x, x, x,
      pauses, x, look_silent, look_refused, look_refused, look_aborted}},
    {"a wait after it was told", {begun, disabled, word(1), confirmed},
     {x, x, x,
      x, look, look_silent, x, x, look_aborted}},
    {"asking for the source", {begun, disabled, word(1), confirmed, pause_over, disabled},
     {done, done, not_taken,
      x, x, look_silent, look_refused, look_refused, look_aborted}},
    {"cutting", {begun, disabled, word(1), confirmed, pause_over, word(enabled_word)},
     {x, x, x,
      started, x, started, started, started, cut}},
    {"cutting at the end of the closing look", {begun, disabled, word(1), failed(errc::timed_out), word(enabled_word)},
     {x, x, x,
      started, x, started, started, started, cut}},
    {"confirming: the fault", {begun, disabled, word(1), confirmed, pause_over, word(fault_word)},
     {fault, fault, fault,
      x, x, fault, fault, fault, look_aborted}},
    {"confirming: the fault of a fault reaction", {begun, disabled, word(1), confirmed, pause_over, word(reaction_word)},
     {cut_as(kind::in_fault), cut_as(kind::in_fault), cut_as(kind::in_fault),
      x, x, cut_as(kind::in_fault), cut_as(kind::in_fault), cut_as(kind::in_fault), look_aborted}},
    {"closing: the fault", {begun, disabled, word(1), failed(errc::timed_out), word(fault_word)},
     {fault, fault, fault,
      x, x, fault, fault, fault, fault}},
    {"closing: the fault of a fault reaction", {begun, disabled, word(1), failed(errc::timed_out), word(reaction_word)},
     {cut_as(kind::in_fault), cut_as(kind::in_fault), cut_as(kind::in_fault),
      x, x, cut_as(kind::in_fault), cut_as(kind::in_fault), cut_as(kind::in_fault), cut_as(kind::in_fault)}},
}};
constexpr std::array<stage_row<9>, 10> activate_rows{{
    {"looking: the fault", {begun, word(fault_word)},
     {fault, fault, fault,
      x, x, silent, refused, refused, fault}},
    {"telling", {begun, disabled},
     {x, x, x,
      pauses, x, look_silent, look_refused, look_refused, look_aborted}},
    {"a wait after it was told", {begun, disabled, confirmed},
     {x, x, x,
      x, look, look_silent, x, x, look_aborted}},
    {"asking for the source", {begun, disabled, confirmed, pause_over, disabled},
     {not_taken, not_taken, done,
      x, x, look_silent, look_refused, look_refused, look_aborted}},
    {"cutting", {begun, disabled, confirmed, pause_over, word(enabled_word)},
     {x, x, x,
      started, x, started, started, started, cut}},
    {"cutting at the end of the closing look", {begun, disabled, failed(errc::timed_out), word(enabled_word)},
     {x, x, x,
      started, x, started, started, started, cut}},
    {"confirming: the fault", {begun, disabled, confirmed, pause_over, word(fault_word)},
     {fault, fault, fault,
      x, x, fault, fault, fault, look_aborted}},
    {"confirming: the fault of a fault reaction", {begun, disabled, confirmed, pause_over, word(reaction_word)},
     {cut_as(kind::in_fault), cut_as(kind::in_fault), cut_as(kind::in_fault),
      x, x, cut_as(kind::in_fault), cut_as(kind::in_fault), cut_as(kind::in_fault), look_aborted}},
    {"closing: the fault", {begun, disabled, failed(errc::timed_out), word(fault_word)},
     {fault, fault, fault,
      x, x, fault, fault, fault, fault}},
    {"closing: the fault of a fault reaction", {begun, disabled, failed(errc::timed_out), word(reaction_word)},
     {cut_as(kind::in_fault), cut_as(kind::in_fault), cut_as(kind::in_fault),
      x, x, cut_as(kind::in_fault), cut_as(kind::in_fault), cut_as(kind::in_fault), cut_as(kind::in_fault)}},
}};
// clang-format on

constexpr atv28::link_procedure release{true, {}}, activate{false, {.run_inputs = 0}};

} // namespace

TEST_CASE("a release of the link does at each look what its table says")
{
    check_table(release, looks, release_looks);
    check_table(activate, looks, activate_looks);
    CHECK(does(release, begun, eta));
    CHECK(does(activate, begun, eta));
}

TEST_CASE("a release of the link does in each stage, at each answer, what its table says")
{
    check_table(release, others, release_rows);
    check_table(activate, others, activate_rows);
}

TEST_CASE("a release whose drive is lost takes the power away without a look, which would have to wait")
{
    CHECK(does(led(release, {begun, disabled, word(1), confirmed}), failed(errc::unit_lost), cut_as(kind::silent)));
}

TEST_CASE("a release that closes with a look has the time for it")
{
    CHECK_FALSE(led(release, {begun, disabled, word(1), confirmed, pause_over}).takes_back());
    CHECK(led(release, {begun, disabled, word(1), confirmed, late}).takes_back());
    CHECK(release.grace == milliseconds(3'000));
}
