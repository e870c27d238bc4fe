// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// The tables of a set-up of the channels: each stage and each answer, as they stand beside the code.
#include <rtuwire/altivar/procedure/commissioning/channel.hpp>

#include "altivar/procedure/status_words.hpp"
#include "altivar/procedure/step_table.hpp"
#include "support/catch.hpp"

#include <rtuwire/altivar/atv310.hpp>
#include <rtuwire/altivar/atv320.hpp>

using namespace rtuwire;
using namespace rtuwire::altivar;
using namespace rtuwire::test;
using kind = outcome_kind;

namespace {

using settings = channel_settings<atv320::device>;

constexpr std::uint16_t fr1 = 8413, cd1 = 8423, chcf = 8401, flo = 8431, command = 8501;
constexpr cell eta = reads(3201), lft = reads(7121), wiring = reads(11101), inputs = reads(5202);
constexpr cell see_fr1 = reads(fr1), see_cd1 = reads(cd1), see_chcf = reads(chcf), see_flo = reads(flo);
constexpr cell set_cd1 = writes(cd1, 10), set_flo = writes(flo, 0), clear = writes(command, 0);
/// The command is withdrawn, whatever comes of it; and where the motor was read to run.
[[nodiscard]] constexpr cell cut_as(kind how) { return then(clear, how); }
constexpr cell cut = cut_as(kind::started_by_terminals);
/// After a setting was sent no end without another look.
[[nodiscard]] constexpr cell look_as(kind how) { return then(eta, how); }
constexpr cell look_silent = look_as(kind::silent), look_refused = look_as(kind::refused);
constexpr cell look_aborted = look_as(kind::aborted), look_lacking = look_as(kind::unknown_register);
constexpr cell look_wrong = look_as(kind::not_taken), look_closed = look_as(kind::run_input_closed);
constexpr cell x = never;
constexpr cell done = ends(kind::succeeded), silent = ends(kind::silent), refused = ends(kind::refused);
constexpr cell aborted = ends(kind::aborted), fault = ends(kind::in_fault), closed = ends(kind::run_input_closed);
constexpr cell running = ends(kind::refused_while_running), lacking = ends(kind::unknown_register);
constexpr cell not_taken = ends(kind::not_taken), started = ends(kind::started_by_terminals);

constexpr event disabled = word(disabled_word), read_0 = word(0), read_1 = word(1), read_10 = word(10);
constexpr event read_164 = word(164), missing = failed(errc::illegal_data_address);

/// CD1 and FLO are wrong: to the look before the first of them, to its write, and behind both.
constexpr way to_look{begun, read_164, read_1, read_1, read_1};
constexpr way to_clear{begun, read_164, read_1, read_1, read_1, disabled, read_1};
constexpr way to_write{begun, read_164, read_1, read_1, read_1, disabled, read_1, confirmed};
constexpr way to_read_back{begun, read_164, read_1, read_1, read_1, disabled, read_1, confirmed, confirmed};
constexpr way no_write{begun, read_164, read_1, read_1, read_1, disabled, read_1, confirmed, failed(errc::timed_out)};
constexpr way wrong_word{begun, read_164, read_1, read_1, read_1, disabled, read_1, confirmed, confirmed, word(7)};
constexpr way too_late{begun, read_164, read_1, read_1, read_1, disabled, read_1, confirmed, confirmed, late};
constexpr way to_second_look{begun, read_164, read_1, read_1, read_1, disabled, read_1, confirmed, confirmed, read_10};
constexpr way to_second_write{begun,  read_164,  read_1,    read_1,  read_1,   disabled,
                              read_1, confirmed, confirmed, read_10, disabled, read_1};
constexpr way to_last_read_back{begun,     read_164,  read_1,  read_1,   read_1, disabled, read_1,
                                confirmed, confirmed, read_10, disabled, read_1, confirmed};
/// FLO alone was wrong, and was set: to the last comparison.
constexpr way again{begun, read_164, read_10, read_1, read_1, disabled, read_1, confirmed, confirmed, read_0};
constexpr way again_cd1{begun,  read_164,  read_10,   read_1, read_1,  disabled,
                        read_1, confirmed, confirmed, read_0, read_164};
constexpr way again_chcf{begun,  read_164,  read_10,   read_1, read_1,   disabled,
                         read_1, confirmed, confirmed, read_0, read_164, read_10};
constexpr way again_flo{begun,     read_164,  read_10, read_1,   read_1,  disabled, read_1,
                        confirmed, confirmed, read_0,  read_164, read_10, read_1};
constexpr way to_wait{begun,     read_164,  read_10, read_1,   read_1,  disabled, read_1,
                      confirmed, confirmed, read_0,  read_164, read_10, read_1,   read_0};
constexpr way to_confirm{begun,     read_164, read_10,  read_1,  read_1, disabled, read_1,    confirmed,
                         confirmed, read_0,   read_164, read_10, read_1, read_0,   pause_over};
constexpr way to_fault{begun,     read_164, read_10,  read_1,  read_1, disabled, read_1,     confirmed,
                       confirmed, read_0,   read_164, read_10, read_1, read_0,   pause_over, word(fault_word)};
constexpr way to_reaction{begun,     read_164, read_10,  read_1,  read_1, disabled, read_1,     confirmed,
                          confirmed, read_0,   read_164, read_10, read_1, read_0,   pause_over, word(reaction_word)};
constexpr way to_cut{begun,     read_164, read_10,  read_1,  read_1, disabled, read_1,     confirmed,
                     confirmed, read_0,   read_164, read_10, read_1, read_0,   pause_over, word(enabled_word)};

// clang-format off
constexpr std::array<stage_row<12>, 6> look_rows{{
    // stage, and the way there
    //   1, 2, 3, 4, 5, 6, 7, 8
    //   no state, no response, refused, limit over
    {"looking before the first write", to_look,
     {aborted, wiring, wiring, wiring, running, running, lft, lft,
      aborted, silent, refused, aborted}},
    {"looking before the second write", to_second_look,
     {look_aborted, wiring, wiring, wiring, cut, cut, lft, lft,
      look_aborted, look_silent, look_refused, look_aborted}},
    {"confirming", to_confirm,
     {aborted, done, done, done, cut, cut, lft, lft,
      cut_as(kind::aborted), cut_as(kind::silent), cut_as(kind::refused), cut_as(kind::aborted)}},
    {"closing after no response to the first write", no_write,
     {silent, silent, silent, silent, cut, cut, lft, lft,
      cut_as(kind::silent), cut_as(kind::silent), cut_as(kind::silent), cut_as(kind::silent)}},
    {"closing after another value was read back", wrong_word,
     {not_taken, not_taken, not_taken, not_taken, cut, cut, lft, lft,
      cut_as(kind::not_taken), cut_as(kind::not_taken), cut_as(kind::not_taken), cut_as(kind::not_taken)}},
    {"closing after the limit", too_late,
     {aborted, aborted, aborted, aborted, cut, cut, lft, lft,
      cut_as(kind::aborted), cut_as(kind::aborted), cut_as(kind::aborted), cut_as(kind::aborted)}},
}};

constexpr std::array<answer, 10> others{{
    {"0", read_0},
    {"1", read_1},
    {"10", read_10},
    {"164", read_164},
    {"confirmed", confirmed},
    {"pause over", pause_over},
    {"no response", failed(errc::timed_out)},
    {"no such register", missing},
    {"refused otherwise", failed(errc::server_device_failure)},
    {"limit over", late},
}};
constexpr std::array<stage_row<10>, 23> rows{{
    // stage, and the way there
    //   0, 1, 10, 164
    //   confirmed, pause over, no response, no such register, refused otherwise, limit over
    {"comparing FR1", {begun},
     {see_cd1, see_cd1, see_cd1, see_cd1,
      x, x, silent, lacking, refused, aborted}},
    {"comparing CD1", {begun, read_164},
     {see_chcf, see_chcf, see_chcf, see_chcf,
      x, x, silent, lacking, refused, aborted}},
    {"comparing CHCF", {begun, read_164, read_10},
     {see_flo, see_flo, see_flo, see_flo,
      x, x, silent, lacking, refused, aborted}},
    {"comparing FLO, all right until now", {begun, read_164, read_10, read_1},
     {done, eta, eta, eta,
      x, x, silent, lacking, refused, aborted}},
    {"comparing FLO, another is wrong", {begun, read_164, read_1, read_1},
     {eta, eta, eta, eta,
      x, x, silent, lacking, refused, aborted}},
    {"looking: TCC", {begun, read_164, read_1, read_1, read_1, disabled},
     {inputs, clear, inputs, inputs,
      x, x, silent, inputs, refused, aborted}},
    {"looking: the inputs", {begun, read_164, read_1, read_1, read_1, disabled, read_0},
     {clear, closed, closed, clear,
      x, x, silent, lacking, refused, aborted}},
    {"looking: the fault", {begun, read_164, read_1, read_1, read_1, word(fault_word)},
     {fault, fault, fault, fault,
      x, x, silent, refused, refused, fault}},
    {"clearing", to_clear,
     {x, x, x, x,
      set_cd1, x, silent, refused, refused, aborted}},
    {"setting", to_write,
     {x, x, x, x,
      see_cd1, x, look_silent, look_refused, look_refused, look_aborted}},
    {"reading back", to_read_back,
     {look_wrong, look_wrong, eta, look_wrong,
      x, x, look_silent, look_refused, look_refused, look_aborted}},
    {"looking for the second time: TCC",
     {begun, read_164, read_1, read_1, read_1, disabled, read_1, confirmed, confirmed, read_10, disabled},
     {inputs, set_flo, inputs, inputs,
      x, x, look_silent, inputs, look_refused, look_aborted}},
    {"setting the second", to_second_write,
     {x, x, x, x,
      see_flo, x, look_silent, look_refused, look_refused, look_aborted}},
    {"reading the last back", to_last_read_back,
     {see_fr1, look_wrong, look_wrong, look_wrong,
      x, x, look_silent, look_refused, look_refused, look_aborted}},
    {"comparing FR1 again", again,
     {look_wrong, look_wrong, look_wrong, see_cd1,
      x, x, look_silent, look_lacking, look_refused, look_aborted}},
    {"comparing CD1 again", again_cd1,
     {look_wrong, look_wrong, see_chcf, look_wrong,
      x, x, look_silent, look_lacking, look_refused, look_aborted}},
    {"comparing CHCF again", again_chcf,
     {look_wrong, see_flo, look_wrong, look_wrong,
      x, x, look_silent, look_lacking, look_refused, look_aborted}},
    {"comparing FLO again", again_flo,
     {pauses, look_wrong, look_wrong, look_wrong,
      x, x, look_silent, look_lacking, look_refused, look_aborted}},
    {"a wait before the last look", to_wait,
     {x, x, x, x,
      x, eta, look_silent, x, x, look_aborted}},
    {"looking for the second time: the inputs",
     {begun, read_164, read_1, read_1, read_1, disabled, read_1, confirmed, confirmed, read_10, disabled, read_0},
     {set_flo, look_closed, look_closed, set_flo,
      x, x, look_silent, look_lacking, look_refused, look_aborted}},
    {"looking for the second time: the fault",
     {begun, read_164, read_1, read_1, read_1, disabled, read_1, confirmed, confirmed, read_10, word(fault_word)},
     {look_as(kind::in_fault), look_as(kind::in_fault), look_as(kind::in_fault), look_as(kind::in_fault),
      x, x, look_silent, look_refused, look_refused, look_as(kind::in_fault)}},
    {"reading the fault", to_fault,
     {fault, fault, fault, fault,
      x, x, fault, fault, fault, fault}},
    {"reading the fault of a fault reaction", to_reaction,
     {cut_as(kind::in_fault), cut_as(kind::in_fault), cut_as(kind::in_fault), cut_as(kind::in_fault),
      x, x, cut_as(kind::in_fault), cut_as(kind::in_fault), cut_as(kind::in_fault), cut_as(kind::in_fault)}},
}};
constexpr std::array<stage_row<10>, 3> cut_rows{{
    {"cutting", to_cut,
     {x, x, x, x,
      started, x, started, started, started, cut}},
    {"cutting behind the first setting",
     {begun, read_164, read_1, read_1, read_1, disabled, read_1, confirmed, confirmed, read_10, word(enabled_word)},
     {x, x, x, x,
      started, x, started, started, started, cut}},
    {"cutting after no response to the first write",
     {begun, read_164, read_1, read_1, read_1, disabled, read_1, confirmed, failed(errc::timed_out), word(enabled_word)},
     {x, x, x, x,
      started, x, started, started, started, cut}},
}};
// clang-format on

constexpr channel_procedure by_modbus{atv320::device::layout, settings::by_modbus().words(), {}};
constexpr channel_procedure nothing{atv320::device::layout, settings{}.words(), {}};
constexpr channel_procedure one{
    atv320::device::layout, settings{}.with<atv320::chcf>(atv320::channel_mode::sep).words(), {}};
constexpr channel_words words_310 = channel_settings<atv310::device>::by_modbus().words();
constexpr channel_procedure unseen{atv310::device::layout, words_310, {}};
constexpr channel_procedure trusting{atv310::device::layout, words_310, {.accept_unseen_inputs = true}};

} // namespace

TEST_CASE("a set-up of the channels does at each look what its table says")
{
    check_table(by_modbus, looks, look_rows);
}

TEST_CASE("a set-up of the channels does in each stage, at each answer, what its table says")
{
    check_table(by_modbus, others, rows);
    check_table(by_modbus, others, cut_rows);
}

TEST_CASE("a set-up of the channels reads what is named, and nothing else")
{
    CHECK(does(by_modbus, begun, see_fr1));
    CHECK(does(nothing, begun, done));
    CHECK(does(one, begun, see_chcf));
    CHECK(does(led(one, {begun}), word(2), done));
    CHECK(does(led(one, {begun, read_1, disabled, read_1}), confirmed, writes(chcf, 2)));
}

TEST_CASE("a set-up of the channels without a look at the inputs has to be accepted")
{
    CHECK(does(led(unseen, to_look), disabled, lacking));
    CHECK(does(led(trusting, to_look), disabled, clear));
}

TEST_CASE("a set-up of the channels names the register of its outcome, and counts its writes")
{
    auto const after = [](way const& there, event what) {
        channel_procedure it = led(by_modbus, there);
        static_cast<void>(it.step(what));
        return it;
    };
    CHECK(after(to_read_back, read_1).address() == cd1);
    CHECK(after(to_read_back, read_1).word() == 1);
    CHECK(after(to_read_back, read_1).written() == 1);
    CHECK(after(to_second_look, word(enabled_word)).address() == 3201);
    CHECK(after(to_second_look, word(enabled_word)).word() == enabled_word);
    CHECK(after(again_chcf, word(2)).address() == chcf);
    CHECK(after(again_chcf, word(2)).word() == 2);
    CHECK(after(to_confirm, disabled).address() == 0);
    CHECK(after(again_cd1, read_10).word() == 0); // CHCF is read next
    CHECK(after(to_fault, word(9)).address() == 0);
    CHECK(after(to_fault, word(9)).word() == 0);
    CHECK(after(to_fault, word(9)).reason().fault == 9);
    CHECK(after(to_cut, confirmed).address() == 3201);
    CHECK(after(to_cut, confirmed).word() == enabled_word);
    CHECK(led(after(to_second_look, word(enabled_word)), {confirmed}).reason().state ==
          cia402::state::operation_enabled);
    CHECK(after(to_last_read_back, read_0).written() == 2);
    CHECK(after({begun, read_164, read_10, read_1}, read_0).written() == 0);
}

TEST_CASE("a set-up of the channels withdraws a lost drive's command without a look, which would have to wait")
{
    CHECK(does(led(by_modbus, to_read_back), failed(errc::unit_lost), cut_as(kind::silent)));
}

TEST_CASE("a set-up of the channels that closes with a look has the time for it")
{
    CHECK_FALSE(led(by_modbus, to_read_back).takes_back());
    CHECK(led(by_modbus, too_late).takes_back());
    CHECK(led(by_modbus, to_confirm).takes_back());
    CHECK(by_modbus.grace == milliseconds(3'000));
}
