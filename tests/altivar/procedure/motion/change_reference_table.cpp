// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// The tables of a change of the reference: each stage and each answer, as they stand beside the code.
#include <rtuwire/altivar/procedure/motion/change_reference.hpp>

#include "altivar/procedure/status_words.hpp"
#include "altivar/procedure/step_table.hpp"
#include "support/catch.hpp"

#include <rtuwire/altivar/atv12.hpp>
#include <rtuwire/altivar/atv28.hpp>

using namespace rtuwire;
using namespace rtuwire::altivar;
using namespace rtuwire::test;
using kind = outcome_kind;

namespace {

constexpr auto const& layout = atv12::device::layout;
constexpr std::uint16_t speed = 8602;
/// In operation, with the reference reached: forward, in reverse, and where it is outside LSP..HSP.
constexpr std::uint16_t reached = 0x0637, reached_back = 0x8637, limited = 0x0A37, limited_reached = 0x0E37;

constexpr cell eta = reads(layout.eta), lft = reads(layout.lft), rfr = reads(layout.rfr), cmd = reads(layout.cmd);
constexpr cell x = never, again = reads(speed), other = ends(kind::overwritten);
constexpr cell highest = reads(3104), lowest = reads(3105);
constexpr cell done = ends(kind::succeeded), silent = ends(kind::silent), refused = ends(kind::refused);
constexpr cell aborted = ends(kind::aborted), too_late = ends(kind::state_timeout), fault = ends(kind::in_fault);
constexpr cell local = ends(kind::local_control), key = ends(kind::stop_key), fell = ends(kind::fell_back);
constexpr cell at_limit = ends(kind::reference_limited), halted = ends(kind::halted);

constexpr std::array<answer, 20> statuses{{
    {"not ready to switch on", word(not_ready_word)},
    {"switch on disabled", word(disabled_word)},
    {"ready to switch on", word(ready_word)},
    {"switched on", word(on_word)},
    {"operation enabled", word(enabled_word)},
    {"quick stop active", word(quick_stop_word)},
    {"fault reaction active", word(reaction_word)},
    {"fault", word(fault_word)},
    {"no state", word(no_state_word)},
    {"switch on disabled by the STOP key", word(0x4250)},
    {"operation enabled, STOP key", word(0x4237)},
    {"operation enabled in local control", word(0x0037)},
    {"fault in local control", word(0x0038)},
    {"reached", word(reached)},
    {"reached in reverse", word(reached_back)},
    {"limited", word(limited)},
    {"limited and reached", word(limited_reached)},
    {"no response", failed(errc::timed_out)},
    {"refused", failed(errc::server_device_failure)},
    {"limit over", late},
}};

constexpr way written{begun, word(enabled_word), word(0x000F), confirmed, pause_over};
constexpr way reached_once{begun,      word(enabled_word), word(0x000F), confirmed,
                           pause_over, word(reached),      word(300),    pause_over};
/// The drive may still show what it does with the reference before.
constexpr way limited_once{begun, word(enabled_word), word(0x000F), confirmed, pause_over, word(limited), pause_over};
constexpr way last_of_reached{begun,     word(enabled_word), word(0x000F),  confirmed, pause_over, word(reached),
                              word(300), pause_over,         word(reached), word(300), word(1'500)};
constexpr way last_of_limited{begun,      word(enabled_word), word(0x000F), confirmed, pause_over, word(limited),
                              pause_over, word(limited),      word(500),    word(0),   word(1'500)};
constexpr way limited_twice{begun,      word(enabled_word), word(0x000F), confirmed,
                            pause_over, word(limited),      pause_over,   word(limited)};
constexpr way with_highest{begun,         word(enabled_word), word(0x000F),  confirmed, pause_over,
                           word(limited), pause_over,         word(limited), word(500)};
constexpr way with_lowest{begun,         word(enabled_word), word(0x000F),  confirmed, pause_over,
                          word(limited), pause_over,         word(limited), word(500), word(0)};
constexpr way limited_before{begun,         word(enabled_word), word(0x000F),       confirmed, pause_over,
                             word(limited), pause_over,         word(enabled_word), pause_over};

// clang-format off
constexpr std::array<stage_row<20>, 7> forward_looks{{
    // stage, and the way there
    //   1, 2, 3, 4, 5, 6, 7, 8, no state
    //   2 by the key, 5 and key, 5 in local, 8 in local, reached, in reverse, limited, both
    //   no response, refused, limit over
    {"the first look", {begun},
     {aborted, aborted, aborted, aborted, cmd, aborted, lft, lft, aborted,
      key, cmd, local, lft, cmd, cmd, cmd, cmd,
      silent, refused, aborted}},
    {"a look after the write", written,
     {fell, fell, fell, fell, pauses, fell, lft, lft, fell,
      key, pauses, local, lft, rfr, pauses, pauses, pauses,
      silent, refused, too_late}},
    {"a look after it was reached once", reached_once,
     {fell, fell, fell, fell, pauses, fell, lft, lft, fell,
      key, pauses, local, lft, rfr, pauses, pauses, pauses,
      silent, refused, too_late}},
    {"a look after it was limited once", limited_once,
     {fell, fell, fell, fell, pauses, fell, lft, lft, fell,
      key, pauses, local, lft, rfr, pauses, highest, highest,
      silent, refused, too_late}},
    {"the last look, of one that was reached", last_of_reached,
     {fell, fell, fell, fell, pauses, fell, lft, lft, fell,
      key, pauses, local, lft, done, pauses, pauses, pauses,
      silent, refused, too_late}},
    {"the last look, of one that was limited", last_of_limited,
     {fell, fell, fell, fell, pauses, fell, lft, lft, fell,
      key, pauses, local, lft, pauses, pauses, at_limit, at_limit,
      silent, refused, too_late}},
    {"a look after it was limited, and then not", limited_before,
     {fell, fell, fell, fell, pauses, fell, lft, lft, fell,
      key, pauses, local, lft, rfr, pauses, pauses, pauses,
      silent, refused, too_late}},
}};
constexpr std::array<stage_row<20>, 1> reverse_looks{{
    {"a look after the write", written,
     {fell, fell, fell, fell, pauses, fell, lft, lft, fell,
      key, pauses, local, lft, pauses, rfr, pauses, pauses,
      silent, refused, too_late}},
}};
constexpr std::array<stage_row<20>, 4> zero_looks{{
    {"a look after the write", written,
     {fell, fell, fell, fell, pauses, fell, lft, lft, fell,
      key, pauses, local, lft, pauses, pauses, pauses, pauses,
      silent, refused, too_late}},
    {"a look after it was reached once", {begun, word(enabled_word), word(0x000F), confirmed, pause_over, word(reached), pause_over},
     {fell, fell, fell, fell, pauses, fell, lft, lft, fell,
      key, pauses, local, lft, again, again, pauses, pauses,
      silent, refused, too_late}},
    {"a look after it was limited once", limited_once,
     {fell, fell, fell, fell, pauses, fell, lft, lft, fell,
      key, pauses, local, lft, pauses, pauses, highest, highest,
      silent, refused, too_late}},
    {"a look after it was reached, and then not",
     {begun, word(enabled_word), word(0x000F), confirmed, pause_over, word(reached), pause_over, word(enabled_word), pause_over},
     {fell, fell, fell, fell, pauses, fell, lft, lft, fell,
      key, pauses, local, lft, pauses, pauses, pauses, pauses,
      silent, refused, too_late}},
}};
// clang-format on

constexpr std::array<answer, 8> others{{
    {"0", word(0)},
    {"a frequency, or a word that runs", word(0x000F)},
    {"a word that runs with bit 11", word(0x080F)},
    {"confirmed", confirmed},
    {"pause over", pause_over},
    {"no response", failed(errc::timed_out)},
    {"refused", failed(errc::server_device_failure)},
    {"limit over", late},
}};
constexpr cell write = writes(speed, 1'500), write_turned = writes(speed, 0xFA24); // -1500
constexpr std::array<stage_row<8>, 10> other_rows{{
    {"the control word", {begun, word(enabled_word)}, {write, write, write_turned, x, x, silent, refused, aborted}},
    {"the write", {begun, word(enabled_word), word(0x000F)}, {x, x, x, pauses, x, silent, refused, aborted}},
    {"a wait after the write",
     {begun, word(enabled_word), word(0x000F), confirmed},
     {x, x, x, x, eta, silent, x, too_late}},
    {"the frequency",
     {begun, word(enabled_word), word(0x000F), confirmed, pause_over, word(reached)},
     {pauses, pauses, pauses, x, x, silent, refused, too_late}},
    {"the frequency for the second time",
     {begun, word(enabled_word), word(0x000F), confirmed, pause_over, word(reached), word(300), pause_over,
      word(reached)},
     {pauses, again, again, x, x, silent, refused, too_late}},
    {"the reference when it is reached",
     {begun, word(enabled_word), word(0x000F), confirmed, pause_over, word(reached), word(300), pause_over,
      word(reached), word(300)},
     {other, other, other, x, x, silent, refused, too_late}},
    {"HSP of one that is limited", limited_twice, {lowest, lowest, lowest, x, x, silent, again, too_late}},
    {"LSP of the same", with_highest, {again, again, again, x, x, silent, again, too_late}},
    {"the fault of a drive that was not written to",
     {begun, word(fault_word)},
     {fault, fault, fault, x, x, silent, refused, fault}},
    {"the fault of one that was",
     {begun, word(enabled_word), word(0x000F), confirmed, pause_over, word(fault_word)},
     {fault, fault, fault, x, x, silent, refused, fault}},
}};

constexpr reference_procedure forward{layout, {speed, 1'500}, beyond_limits::limit};
constexpr reference_procedure reverse{layout, {speed, 0xFA24}, beyond_limits::limit};
constexpr reference_procedure zero{layout, {speed, 0}, beyond_limits::refuse};

// A reference of 0 keeps the direction of the motor: LSP is read where the word for it has a sign.
constexpr cell lsp = reads(3105);
constexpr cell write_0 = writes(speed, 0), write_back = writes(speed, 0xFFFF), write_1 = writes(speed, 1);
constexpr std::array<answer, 5> lows{{
    {"0", word(0)},
    {"10 Hz", word(100)},
    {"no response", failed(errc::timed_out)},
    {"refused", failed(errc::illegal_data_address)},
    {"limit over", late},
}};

// Slowing down is never refused: its reference is read first, and HSP only where it would turn faster, or the other way.
constexpr reference_procedure held{layout, {speed, 1'500, true}, beyond_limits::refuse};
constexpr reference_procedure held_hertz{atv28::device::layout, {401, 0xFF38}, beyond_limits::refuse}; // -20.0 Hz
constexpr cell hsp = reads(3104), frs = reads(9602), nsp = reads(9604), write_hertz = writes(401, 0xFF38);
constexpr cell above = ends(kind::above_hsp), unknown = ends(kind::unknown_register);
constexpr std::array<answer, 12> standings{{
    {"0", word(0)},
    {"1499", word(1'499)},
    {"1500", word(1'500)},
    {"1501", word(1'501)},
    {"-1501", word(0xFA23)},
    {"200", word(200)},
    {"-199", word(0xFF39)},
    {"-200", word(0xFF38)},
    {"confirmed", confirmed},
    {"no response", failed(errc::timed_out)},
    {"refused", failed(errc::illegal_data_address)},
    {"limit over", late},
}};
constexpr cell hsp_28 = reads(250);
// clang-format off
constexpr std::array<stage_row<12>, 4> held_rows{{
    // 0, 1499, 1500, 1501, -1501, 200, -199, -200, confirmed, no response, refused, limit over
    {"the reference that stands", {begun, word(enabled_word), word(0x000F)},
     {hsp, hsp, write, write, hsp, hsp, hsp, hsp, x, silent, hsp, aborted}},
    {"HSP of one in rpm", {begun, word(enabled_word), word(0x000F), word(0)},
     {frs, frs, frs, frs, frs, frs, frs, frs, x, silent, unknown, aborted}},
    {"FRS", {begun, word(enabled_word), word(0x000F), word(0), word(500)},
     {nsp, nsp, nsp, nsp, nsp, nsp, nsp, nsp, x, silent, unknown, aborted}},
    // 50 Hz: at 1440 rpm two pairs of poles, so 1500 rpm; at 200 rpm fifteen
    {"NSP", {begun, word(enabled_word), word(0x000F), word(0), word(500), word(500)},
     {unknown, write, write, write, write, above, write, write, x, silent, unknown, aborted}},
}};
constexpr std::array<stage_row<12>, 2> held_hertz_rows{{
    {"the reference in Hz that stands", {begun, word(enabled_word), word(0x000F)},
     {hsp_28, hsp_28, hsp_28, hsp_28, write_hertz, hsp_28, hsp_28, write_hertz, x, silent, hsp_28, aborted}},
    {"HSP of one in Hz", {begun, word(enabled_word), word(0x000F), word(0)},
     {above, write_hertz, write_hertz, write_hertz, write_hertz, write_hertz, write_hertz, write_hertz, x, silent, unknown, aborted}},
}};
// clang-format on

constexpr std::uint16_t back = 0x8237, by_sign = 0x000F, by_bit = 0x080F;
constexpr std::array<stage_row<5>, 3> low_rows{{
    {"LSP, in reverse by the sign",
     {begun, word(back), word(by_sign)},
     {write_0, write_back, silent, write_back, aborted}},
    {"LSP, in reverse by bit 11", {begun, word(back), word(by_bit)}, {write_0, write_1, silent, write_1, aborted}},
    {"LSP, forward under bit 11",
     {begun, word(enabled_word), word(by_bit)},
     {write_0, write_back, silent, write_back, aborted}},
}};

} // namespace

TEST_CASE("a change of the reference does at each look what its table says")
{
    check_table(forward, statuses, forward_looks);
    check_table(reverse, statuses, reverse_looks);
    check_table(zero, statuses, zero_looks);
}

TEST_CASE("a change of the reference does in each stage, at each answer, what its table says")
{
    check_table(forward, others, other_rows);
    way const reached_twice{begun,        word(enabled_word), word(0x000F), confirmed,    pause_over,
                            word(0x0637), word(300),          pause_over,   word(0x0637), word(300)};
    CHECK(does(led(forward, reached_twice), word(1'500), eta));
    CHECK(does(led(forward, with_lowest), word(1'500), eta));
}

TEST_CASE("a change of the reference that may be refused reads no limit where it slows down")
{
    check_table(held, standings, held_rows);
    check_table(held_hertz, standings, held_hertz_rows);
    CHECK(does(led(held, {begun, word(enabled_word)}), word(0x000F), reads(speed)));
    CHECK(does(led(held_hertz, {begun, word(enabled_word)}), word(0x000F), reads(401)));
}

TEST_CASE("a change to 0 reads LSP where it would turn the motor round, and keeps its direction unless that is 0")
{
    check_table(zero, lows, low_rows);
    CHECK(does(led(zero, {begun, word(back)}), word(by_sign), lsp));
    CHECK(does(led(zero, {begun, word(back)}), word(by_bit), lsp));
    CHECK(does(led(zero, {begun, word(enabled_word)}), word(by_bit), lsp));
    CHECK(does(led(zero, {begun, word(enabled_word)}), word(by_sign), write_0));
    static constexpr drive_layout unlimited{
        .cmd = layout.cmd, .eta = layout.eta, .lft = 1, .cmi = 2, .eti = 3, .rfr = 4};
    constexpr reference_procedure elsewhere{unlimited, {speed, 0}, beyond_limits::refuse};
    CHECK(does(led(elsewhere, {begun, word(back)}), word(by_sign), write_back));
}

TEST_CASE("a change to a small speed in reverse reads what a hertz is, and writes at least a tenth of that")
{
    constexpr reference_procedure zero_rpm{layout, {speed, 0, true}, beyond_limits::refuse};
    constexpr reference_procedure small{layout, {speed, 0xFFED, true}, beyond_limits::limit}; // -19
    constexpr reference_procedure more{layout, {speed, 0xFFEC, true}, beyond_limits::limit};  // -20
    constexpr cell as_of_one_pair = writes(speed, 0xFFFA), as_of_two = writes(speed, 0xFFFD);
    way const asks{begun, word(back), word(by_sign), word(100)};
    CHECK(does(led(zero_rpm, {begun, word(back), word(by_sign)}), word(100), frs));
    CHECK(does(led(zero_rpm, {begun, word(back), word(by_sign)}), word(0), write_0));
    CHECK(does(led(zero_rpm, {begun, word(back), word(by_sign)}), failed(errc::illegal_data_address), frs));
    CHECK(does(led(zero_rpm, asks), word(500), nsp));
    CHECK(does(led(zero_rpm, asks), failed(errc::illegal_data_address), as_of_one_pair));
    CHECK(does(led(zero_rpm, {begun, word(back), word(by_sign), word(100), word(500)}), word(1'440), as_of_two));
    CHECK(does(led(zero_rpm, {begun, word(back), word(by_sign), word(100), word(500)}), word(0), as_of_one_pair));
    CHECK(does(led(zero_rpm, {begun, word(back), word(by_bit)}), word(100), writes(speed, 1)));
    CHECK(does(led(small, {begun, word(back)}), word(by_sign), frs));
    CHECK(does(led(small, {begun, word(back), word(by_sign), word(500)}), word(1'440), writes(speed, 0xFFED)));
    CHECK(does(led(more, {begun, word(back)}), word(by_sign), writes(speed, 0xFFEC)));
}

TEST_CASE("a change to a small speed in reverse of a drive that does not tell what a hertz is ends as another speed")
{
    constexpr reference_procedure small{layout, {speed, 0xFFFF, true}, beyond_limits::limit}; // -1
    constexpr std::uint16_t told = 0xFFFA;
    way const at_last{begun,      word(back),         word(by_sign),      failed(errc::illegal_data_address),
                      confirmed,  pause_over,         word(reached_back), word(300),
                      pause_over, word(reached_back), word(300),          word(told)};
    reference_procedure it = led(small, at_last);
    CHECK(does(it, word(reached_back), at_limit));
    static_cast<void>(it.step(word(reached_back)));
    CHECK(it.reason().limit == 0);
}

TEST_CASE("a change of the reference asks once for its limits, whether they are told or not")
{
    constexpr reference_procedure in_rpm{layout, {speed, 1'500, true}, beyond_limits::limit};
    constexpr event missing = failed(errc::illegal_data_address);
    struct {
        char const* name;
        reference_procedure of;
        way said;
    } const answers[]{{"told", forward, {word(500), word(0)}},
                      {"HSP is refused", forward, {missing}},
                      {"NSP is 0", in_rpm, {word(500), word(500), word(0)}},
                      {"NSP is refused", in_rpm, {word(500), word(500), missing}}};
    for (auto const& each : answers) {
        INFO(each.name);
        reference_procedure it = led(each.of, limited_twice);
        action last{};
        for (std::size_t i = 0; i < each.said.size; ++i) {
            last = it.step(each.said.events[i]);
        }
        CHECK((what_of(last) == action_kind::read and address_of(last) == speed));
        // Its reference stands, the last look shows that it is not limited any more, and then it is again.
        for (event const what : {word(1'500), word(enabled_word), pause_over, word(limited), pause_over}) {
            static_cast<void>(it.step(what));
        }
        CHECK(does(it, word(limited), again));
    }
    static constexpr drive_layout without = [] {
        drive_layout some = layout;
        some.hsp = 0;
        return some;
    }();
    constexpr reference_procedure elsewhere{without, {speed, 1'500}, beyond_limits::limit};
    CHECK(does(led(elsewhere, limited_once), word(limited), again));
}

TEST_CASE("a change of the reference names the limit that the drive keeps to, and none where it is reached")
{
    reference_procedure it = led(forward, last_of_reached);
    static_cast<void>(it.step(word(0x0637)));
    CHECK((it.reason().kind == kind::succeeded and it.reason().limit == 0));
    it = led(forward, last_of_limited);
    static_cast<void>(it.step(word(limited)));
    CHECK((it.reason().kind == kind::reference_limited and it.reason().limit == 500));
}

TEST_CASE("a change of the reference begins with a look, and leaves a halt")
{
    CHECK(does(forward, begun, eta));
    CHECK(does(led(forward, {begun, word(enabled_word)}), word(0x010F), halted));
    constexpr reference_procedure old{atv28::device::layout, {401, 300}, beyond_limits::limit}; // has no halt
    CHECK(does(led(old, {begun, word(enabled_word)}), word(0x010F), writes(401, 300)));
}

TEST_CASE("a change of the reference ends at its write where the client has no place for one more drive")
{
    way const to_write{begun, word(enabled_word), word(0x000F)};
    CHECK(does(led(forward, to_write), failed(errc::too_many_ordered), ends(kind::no_place)));
}
