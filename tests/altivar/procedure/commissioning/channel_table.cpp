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
/// The motor runs: its command is withdrawn, whatever comes of it.
constexpr cell cut = then(clear, kind::started_by_terminals);
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
constexpr way to_cut{begun,     read_164, read_10,  read_1,  read_1, disabled, read_1,     confirmed,
                     confirmed, read_0,   read_164, read_10, read_1, read_0,   pause_over, word(enabled_word)};

// clang-format off
constexpr std::array<stage_row<12>, 3> look_rows{{
    // stage, and the way there
    //   1, 2, 3, 4, 5, 6, 7, 8
    //   no state, no response, refused, limit over
    {"looking before the first write", to_look,
     {aborted, wiring, wiring, wiring, running, running, lft, lft,
      aborted, silent, refused, aborted}},
    {"looking before the second write", to_second_look,
     {aborted, wiring, wiring, wiring, running, running, lft, lft,
      aborted, silent, refused, aborted}},
    {"confirming", to_confirm,
     {done, done, done, done, cut, cut, lft, lft,
      done, silent, refused, aborted}},
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
constexpr std::array<stage_row<10>, 20> rows{{
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
      x, x, silent, refused, refused, aborted}},
    {"clearing", to_clear,
     {x, x, x, x,
      set_cd1, x, silent, refused, refused, aborted}},
    {"setting", to_write,
     {x, x, x, x,
      see_cd1, x, silent, refused, refused, aborted}},
    {"reading back", to_read_back,
     {not_taken, not_taken, eta, not_taken,
      x, x, silent, refused, refused, aborted}},
    {"looking for the second time: TCC",
     {begun, read_164, read_1, read_1, read_1, disabled, read_1, confirmed, confirmed, read_10, disabled},
     {inputs, set_flo, inputs, inputs,
      x, x, silent, inputs, refused, aborted}},
    {"setting the second", to_second_write,
     {x, x, x, x,
      see_flo, x, silent, refused, refused, aborted}},
    {"reading the last back", to_last_read_back,
     {see_fr1, not_taken, not_taken, not_taken,
      x, x, silent, refused, refused, aborted}},
    {"comparing FR1 again", again,
     {not_taken, not_taken, not_taken, see_cd1,
      x, x, silent, lacking, refused, aborted}},
    {"comparing CD1 again", again_cd1,
     {not_taken, not_taken, see_chcf, not_taken,
      x, x, silent, lacking, refused, aborted}},
    {"comparing CHCF again", again_chcf,
     {not_taken, see_flo, not_taken, not_taken,
      x, x, silent, lacking, refused, aborted}},
    {"comparing FLO again", again_flo,
     {pauses, not_taken, not_taken, not_taken,
      x, x, silent, lacking, refused, aborted}},
    {"a wait before the last look", to_wait,
     {x, x, x, x,
      x, eta, silent, x, x, aborted}},
    {"reading the fault", to_fault,
     {fault, fault, fault, fault,
      x, x, silent, refused, refused, aborted}},
}};
constexpr std::array<stage_row<10>, 1> cut_rows{{
    {"taking back", to_cut,
     {x, x, x, x,
      started, x, started, started, started, aborted}},
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
    auto const after = [](way const& there, event const& what) {
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
    CHECK(after(to_last_read_back, read_0).written() == 2);
    CHECK(after({begun, read_164, read_10, read_1}, read_0).written() == 0);
}
