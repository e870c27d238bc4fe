// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// The tables of the check before the first order: each register and each answer, as they stand beside the code.
#include <rtuwire/altivar/procedure/inspection/supervision.hpp>

#include "altivar/procedure/status_words.hpp"
#include "altivar/procedure/step_table.hpp"
#include "support/catch.hpp"
#include "support/commissioned.hpp"

#include <rtuwire/altivar/atv12.hpp>
#include <rtuwire/altivar/atv28.hpp>
#include <rtuwire/altivar/atv310.hpp>
#include <rtuwire/altivar/atv320.hpp>

using namespace rtuwire;
using namespace rtuwire::altivar;
using namespace rtuwire::test;
using kind = outcome_kind;

namespace {

constexpr auto const& layout = atv320::device::layout;
constexpr auto const& old = atv28::device::layout;

constexpr cell sll = reads(7010), tto = reads(6005), chcf = reads(8401), cd1 = reads(8423), fr1 = reads(8413);
constexpr cell flo = reads(8431), atr = reads(7122), dotd = reads(8652), eta = reads(3201);
constexpr cell cmi28 = reads(402), atr28 = reads(150), tcc28 = reads(6), inputs28 = reads(478), eta28 = reads(458);

constexpr cell x = never;
constexpr cell ready = ends(kind::succeeded), silent = ends(kind::silent), refused = ends(kind::refused);
constexpr cell aborted = ends(kind::aborted), alone = ends(kind::unsupervised),
               runs_on = ends(kind::runs_on_without_link);
constexpr cell other = ends(kind::other_channel), bits = ends(kind::not_drive_profile);
constexpr cell restarts = ends(kind::restarts_by_itself), lacking = ends(kind::unknown_register);
constexpr cell local = ends(kind::local_control), closed = ends(kind::run_input_closed);
constexpr cell too_short = ends(kind::timeout_too_short);

constexpr event missing = failed(errc::illegal_data_address), remote = word(disabled_word);

constexpr std::array<answer, 18> answers{{
    {"0", word(0)},
    {"1", word(1)},
    {"2", word(2)},
    {"3", word(3)},
    {"4", word(4)},
    {"5", word(5)},
    {"6", word(6)},
    {"7", word(7)},
    {"8", word(8)},
    {"10", word(10)},
    {"100", word(100)},
    {"164", word(164)},
    {"remote", remote},
    {"bit 14", word(0x4000)},
    {"no response", failed(errc::timed_out)},
    {"no such register", missing},
    {"refused otherwise", failed(errc::server_device_failure)},
    {"limit over", late},
}};

// clang-format off
constexpr std::array<stage_row<18>, 10> rows{{
    // register, and the way there
    //   0, 1, 2, 3, 4, 5, 6, 7, 8
    //   10, 100, 164, remote, bit 14
    //   no response, no such register, refused otherwise, limit over
    {"SLL", {begun},
     {alone, tto, tto, lacking, runs_on, runs_on, tto, tto, tto,
      lacking, lacking, lacking, lacking, lacking,
      silent, lacking, refused, aborted}},
    {"TTO", {begun, word(1)},
     {alone, chcf, chcf, chcf, chcf, chcf, chcf, chcf, chcf,
      chcf, chcf, chcf, chcf, chcf,
      sll, lacking, refused, aborted}},
    {"CHCF", {begun, word(1), word(100)},
     {lacking, fr1, cd1, bits, lacking, lacking, lacking, lacking, lacking,
      lacking, lacking, lacking, lacking, lacking,
      sll, lacking, refused, aborted}},
    {"CD1", {begun, word(1), word(100), word(2)},
     {other, other, other, other, other, other, other, other, other,
      fr1, other, other, other, other,
      sll, lacking, refused, aborted}},
    {"FR1, apart", {begun, word(1), word(100), word(2), word(10)},
     {other, other, other, other, other, other, other, other, other,
      other, other, flo, other, other,
      sll, lacking, refused, aborted}},
    {"FR1, together", {begun, word(1), word(100), word(1)},
     {other, other, other, other, other, other, other, other, other,
      other, other, flo, other, other,
      sll, lacking, refused, aborted}},
    {"FLO", {begun, word(1), word(100), word(1), word(164)},
     {atr, atr, atr, atr, atr, atr, atr, atr, atr,
      atr, atr, atr, atr, atr,
      sll, atr, refused, aborted}},
    {"ATR", {begun, word(1), word(100), word(1), word(164), word(0)},
     {dotd, restarts, restarts, restarts, restarts, restarts, restarts, restarts, restarts,
      restarts, restarts, restarts, restarts, restarts,
      sll, lacking, refused, aborted}},
    {"DOTD", {begun, word(1), word(100), word(1), word(164), word(0), word(0)},
     {eta, eta, eta, eta, eta, eta, eta, eta, eta,
      eta, eta, eta, eta, eta,
      sll, eta, refused, aborted}},
    {"ETA", {begun, word(1), word(100), word(1), word(164), word(0), word(0), word(1)},
     {local, local, local, local, local, local, local, local, local,
      local, local, local, ready, local,
      sll, refused, refused, aborted}},
}};
constexpr std::array<std::uint16_t, 10> registers{7010, 6005, 8401, 8423, 8413, 8413, 8431, 7122, 8652, 3201};

constexpr std::array<stage_row<18>, 6> old_rows{{
    {"CMI", {begun},
     {atr28, atr28, atr28, atr28, atr28, atr28, atr28, atr28, atr28,
      atr28, atr28, atr28, atr28, alone,
      silent, lacking, refused, aborted}},
    {"ATR", {begun, word(0)},
     {tcc28, restarts, restarts, restarts, restarts, restarts, restarts, restarts, restarts,
      restarts, restarts, restarts, restarts, restarts,
      cmi28, lacking, refused, aborted}},
    {"TCC", {begun, word(0), word(0)},
     {inputs28, inputs28, inputs28, inputs28, inputs28, inputs28, inputs28, inputs28, inputs28,
      inputs28, inputs28, inputs28, inputs28, inputs28,
      cmi28, inputs28, refused, aborted}},
    {"the inputs, two-wire", {begun, word(0), word(0), word(0)},
     {eta28, closed, closed, closed, eta28, closed, closed, closed, eta28,
      closed, eta28, eta28, eta28, eta28,
      cmi28, lacking, refused, aborted}},
    {"the inputs, three-wire", {begun, word(0), word(0), word(1)},
     {eta28, eta28, eta28, eta28, eta28, eta28, eta28, eta28, eta28,
      eta28, eta28, eta28, eta28, eta28,
      cmi28, lacking, refused, aborted}},
    {"the inputs, TCC not known", {begun, word(0), word(0), missing},
     {eta28, closed, closed, closed, eta28, closed, closed, closed, eta28,
      closed, eta28, eta28, eta28, eta28,
      cmi28, lacking, refused, aborted}},
}};
// clang-format on

/// A finding, the risk that it is, and what follows where this risk is accepted.
struct risky {
    char const* name;
    way there;
    event what;
    cell found;
    bool supervision_risks::*risk; ///< null: none
    cell accepted;
};
using risks = supervision_risks;
constexpr std::array<risky, 19> findings{{
    {"SLL 0", {begun}, word(0), alone, &risks::accept_unsupervised, tto},
    {"SLL 3", {begun}, word(3), lacking, &risks::accept_unknown_registers, tto},
    {"SLL 4", {begun}, word(4), runs_on, &risks::accept_running_on, tto},
    {"no SLL", {begun}, missing, lacking, &risks::accept_unknown_registers, tto},
    {"TTO 0", {begun, word(1)}, word(0), alone, &risks::accept_unsupervised, chcf},
    {"no TTO", {begun, word(1)}, missing, lacking, &risks::accept_unknown_registers, chcf},
    {"CHCF IO", {begun, word(1), word(50)}, word(3), bits, nullptr, x},
    {"CHCF 9", {begun, word(1), word(50)}, word(9), lacking, &risks::accept_unknown_registers, cd1},
    {"no CHCF", {begun, word(1), word(50)}, missing, lacking, &risks::accept_unknown_registers, cd1},
    {"CD1 1", {begun, word(1), word(50), word(2)}, word(1), other, &risks::accept_other_channel, fr1},
    {"no CD1", {begun, word(1), word(50), word(2)}, missing, lacking, &risks::accept_unknown_registers, fr1},
    {"FR1 1", {begun, word(1), word(50), word(1)}, word(1), other, &risks::accept_other_channel, flo},
    {"no FR1", {begun, word(1), word(50), word(1)}, missing, lacking, &risks::accept_unknown_registers, flo},
    {"ATR 1",
     {begun, word(1), word(50), word(1), word(164), word(0)},
     word(1),
     restarts,
     &risks::accept_automatic_restart,
     dotd},
    {"no ATR",
     {begun, word(1), word(50), word(1), word(164), word(0)},
     missing,
     lacking,
     &risks::accept_unknown_registers,
     dotd},
    {"local control",
     {begun, word(1), word(120), word(1), word(164), word(0), word(0), word(1)},
     word(0x0050),
     local,
     &risks::accept_other_channel,
     ready},
    {"no ETA",
     {begun, word(1), word(120), word(1), word(164), word(0), word(0), word(1)},
     missing,
     refused, // every drive has it: no risk accepts that
     nullptr,
     x},
    {"a time-out of three gaps",
     {begun, word(1), word(120), word(1), word(164), word(0), word(0), word(1)},
     remote,
     ready,
     nullptr,
     x},
    {"a time-out below three gaps",
     {begun, word(1), word(119), word(1), word(164), word(0), word(0), word(1)},
     remote,
     too_short,
     &risks::accept_short_timeout,
     ready},
}};
constexpr std::array all_risks{
    &risks::accept_unsupervised,      &risks::accept_running_on,       &risks::accept_other_channel,
    &risks::accept_automatic_restart, &risks::accept_closed_run_input, &risks::accept_unknown_registers,
    &risks::accept_short_timeout,
};

constexpr supervision_procedure with_risk(drive_layout const& of, bool supervision_risks::*risk)
{
    supervision_options options{.longest_gap = milliseconds(4'000), .beyond = beyond_limits::limit};
    if (risk != nullptr) {
        options.risks.*risk = true;
    }
    return supervision_procedure{of, options, false};
}

constexpr supervision_procedure check{layout, unlimited, false}, old_check{old, unlimited, false};

} // namespace

TEST_CASE("a check of a drive does at each register, at each answer, what its table says")
{
    check_table(check, answers, rows);
    check_table(old_check, answers, old_rows);
    CHECK(does(check, begun, sll));
    CHECK(does(old_check, begun, cmi28));
}

TEST_CASE("a check that finds a reason against an order names the register and its word")
{
    for (std::size_t row = 0; row < rows.size(); ++row) {
        for (std::size_t i = 0; i < answers.size(); ++i) {
            kind const end = rows[row].cells[i].ending;
            bool const is_finding = end != kind::pending and end != kind::succeeded and end != kind::silent and
                                    end != kind::refused and end != kind::aborted;
            if (is_finding) {
                INFO(rows[row].name << ", " << answers[i].name);
                supervision_procedure it = led(check, rows[row].there);
                static_cast<void>(it.step(answers[i].what));
                CHECK(it.report().finding == end);
                CHECK(it.report().address == registers[row]);
                CHECK(it.report().word == answers[i].what.word());
            }
        }
    }
}

TEST_CASE("a check accepts a finding by its own risk, and by no other")
{
    for (risky const& each : findings) {
        INFO(each.name);
        CHECK(does(led(with_risk(layout, nullptr), each.there), each.what, each.found));
        for (bool supervision_risks::*risk : all_risks) {
            supervision_procedure const it = led(with_risk(layout, risk), each.there);
            CHECK(does(it, each.what, risk == each.risk ? each.accepted : each.found));
        }
    }
    way const inputs{begun, word(0), word(0), word(0)};
    for (bool supervision_risks::*risk : all_risks) {
        bool const is_own = risk == &risks::accept_closed_run_input;
        CHECK(does(led(with_risk(old, risk), inputs), word(1), is_own ? eta28 : closed));
    }
}

TEST_CASE("a check knows what the control words mean from CHCF and DOTD")
{
    auto const meaning = [](supervision_procedure const& it, way const& there) {
        return led(it, there).report().words;
    };
    auto const of = [&](event mode, event disable) {
        way const together{begun, word(1), word(120), mode, word(164), word(0), word(0), disable, remote};
        way const apart{begun, word(1), word(120), mode, word(10), word(164), word(0), word(0), disable, remote};
        bool const is_together = mode.what() == event::kind::word_read and mode.word() == 1;
        return meaning(with_risk(layout, &risks::accept_unknown_registers), is_together ? together : apart);
    };
    CHECK(of(word(1), word(1)) == word_meaning::cia402);
    CHECK(of(word(2), word(1)) == word_meaning::cia402);
    CHECK(of(word(1), word(0)) == word_meaning::unknown);
    CHECK(of(word(2), word(2)) == word_meaning::unknown);
    CHECK(of(word(1), missing) == word_meaning::unknown);
    CHECK(of(word(9), word(1)) == word_meaning::unknown);
    CHECK(of(missing, word(1)) == word_meaning::unknown);

    way const without_dotd{begun, word(1), word(120), word(1), word(164), word(0), remote};
    CHECK(meaning(supervision_procedure{atv12::device::layout, unlimited, false}, without_dotd) ==
          word_meaning::cia402);
    CHECK(meaning(supervision_procedure{atv310::device::layout, unlimited, false}, without_dotd) ==
          word_meaning::cia402);
    CHECK(meaning(old_check, {begun, word(0), word(0), word(0), word(0), remote}) == word_meaning::cia402);
}

TEST_CASE("a check whose report is known reads nothing")
{
    CHECK(does(supervision_procedure{layout, commissioned()}, begun, ready));
    CHECK(does(supervision_procedure{layout, supervision_report{}}, begun, ends(kind::unchecked)));
    supervision_report found;
    found.finding = kind::restarts_by_itself;
    CHECK(does(supervision_procedure{layout, found}, begun, restarts));
}
