// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// The tables of a direct start: each stage and each answer, as they stand beside the code.
#include <rtuwire/altivar/procedure/motion/direct_control.hpp>

#include "altivar/procedure/status_words.hpp"
#include "altivar/procedure/step_table.hpp"
#include "support/catch.hpp"
#include "support/commissioned.hpp"

#include <rtuwire/altivar/atv28.hpp>

using namespace rtuwire;
using namespace rtuwire::altivar;
using namespace rtuwire::test;
using kind = outcome_kind;

namespace {

constexpr auto const& layout = atv28::device::layout;
constexpr std::uint16_t speed = 603, shows_key = 0x4250;

constexpr cell eta = reads(layout.eta), lft = reads(layout.lft), cmd = reads(layout.cmd);
constexpr cell clear = writes(layout.cmd, 0x0000), run = writes(layout.cmd, 0x800A);
constexpr cell reference = writes(speed, 1'500), read_back = reads(speed);
constexpr cell x = never;
constexpr cell done = ends(kind::succeeded), silent = ends(kind::silent), refused = ends(kind::refused);
constexpr cell aborted = ends(kind::aborted), fault = ends(kind::in_fault);
constexpr cell local = ends(kind::local_control), limited = ends(kind::reference_limited);
constexpr cell running = ends(kind::refused_while_running);

/// The commands are withdrawn: of a motor that cannot turn yet, and of one that may.
constexpr cell undo(kind how) { return then(writes(layout.cmd, 0x0000), how); }
constexpr cell ramp(kind how) { return then(writes(layout.cmd, 0x0007), how); }

constexpr std::array<answer, 17> statuses{{
    {"not ready to switch on", word(not_ready_word)},
    {"switch on disabled", word(disabled_word)},
    {"ready to switch on", word(ready_word)},
    {"switched on", word(on_word)},
    {"operation enabled", word(enabled_word)},
    {"quick stop active", word(quick_stop_word)},
    {"fault reaction active", word(reaction_word)},
    {"fault", word(fault_word)},
    {"no state", word(no_state_word)},
    {"switch on disabled in local control", word(0x0050)},
    {"switch on disabled, STOP key", word(shows_key)},
    {"operation enabled, STOP key", word(0x4237)},
    {"operation enabled, limited", word(0x0A37)},
    {"fault in local control", word(0x0038)},
    {"no response", failed(errc::timed_out)},
    {"refused", failed(errc::server_device_failure)},
    {"limit over", late},
}};

constexpr event disabled = word(disabled_word), read_0 = word(0), read_1500 = word(1'500);

// clang-format off
constexpr std::array<stage_row<17>, 6> look_rows{{
    // stage, and the way there
    //   1, 2, 3, 4, 5, 6, 7, 8
    //   no state, local, STOP key in 2, in 5, limited, fault in local
    //   no response, refused, limit over
    {"meeting", {begun},
     {aborted, clear, clear, clear, running, running, lft, lft,
      aborted, local, clear, running, running, lft,
      silent, refused, aborted}},
    {"looking again", {begun, disabled, confirmed, confirmed, read_1500},
     {undo(kind::overwritten), cmd, undo(kind::overwritten), undo(kind::overwritten), undo(kind::overwritten), undo(kind::overwritten), lft, lft,
      undo(kind::overwritten), undo(kind::local_control), undo(kind::stop_key), undo(kind::stop_key), undo(kind::overwritten), lft,
      undo(kind::silent), undo(kind::refused), undo(kind::state_timeout)}},
    {"looking again at a drive that its key had stopped before",
     {begun, word(shows_key), confirmed, confirmed, read_1500},
     {undo(kind::overwritten), cmd, undo(kind::overwritten), undo(kind::overwritten), undo(kind::overwritten), undo(kind::overwritten), lft, lft,
      undo(kind::overwritten), undo(kind::local_control), cmd, undo(kind::overwritten), undo(kind::overwritten), lft,
      undo(kind::silent), undo(kind::refused), undo(kind::state_timeout)}},
    {"confirming", {begun, disabled, confirmed, confirmed, read_1500, disabled, read_0, confirmed, read_1500},
     {ramp(kind::fell_back), pauses, pauses, pauses, done, ramp(kind::fell_back), lft, lft,
      ramp(kind::fell_back), ramp(kind::local_control), ramp(kind::stop_key), ramp(kind::stop_key), limited, lft,
      ramp(kind::silent), ramp(kind::refused), ramp(kind::state_timeout)}},
    {"confirming, of a drive that its key had stopped before",
     {begun, word(shows_key), confirmed, confirmed, read_1500, word(shows_key), read_0, confirmed, read_1500},
     {ramp(kind::fell_back), pauses, pauses, pauses, done, ramp(kind::fell_back), lft, lft,
      ramp(kind::fell_back), ramp(kind::local_control), pauses, done, limited, lft,
      ramp(kind::silent), ramp(kind::refused), ramp(kind::state_timeout)}},
    {"confirming, of a drive that was switched on already",
     {begun, disabled, confirmed, confirmed, read_1500, disabled, read_0, confirmed, read_1500, word(on_word), pause_over},
     {ramp(kind::fell_back), ramp(kind::fell_back), ramp(kind::fell_back), pauses, done, ramp(kind::fell_back), lft, lft,
      ramp(kind::fell_back), ramp(kind::local_control), ramp(kind::stop_key), ramp(kind::stop_key), limited, lft,
      ramp(kind::silent), ramp(kind::refused), ramp(kind::state_timeout)}},
}};

constexpr std::array<answer, 8> others{{
    {"0", read_0},
    {"1500", read_1500},
    {"another word", word(0x800A)},
    {"confirmed", confirmed},
    {"pause over", pause_over},
    {"no response", failed(errc::timed_out)},
    {"refused", failed(errc::server_device_failure)},
    {"limit over", late},
}};
constexpr std::array<stage_row<8>, 10> other_rows{{
    // stage, and the way there
    //   0, 1500, another word, confirmed, pause over, no response, refused, limit over
    {"clearing", {begun, disabled},
     {x, x, x, reference, x, undo(kind::silent), undo(kind::refused), undo(kind::state_timeout)}},
    {"writing the reference", {begun, disabled, confirmed},
     {x, x, x, read_back, x, undo(kind::silent), undo(kind::refused), undo(kind::state_timeout)}},
    {"reading the reference", {begun, disabled, confirmed, confirmed},
     {undo(kind::not_taken), eta, undo(kind::not_taken), x, x, undo(kind::silent), undo(kind::refused), undo(kind::state_timeout)}},
    {"reading the command", {begun, disabled, confirmed, confirmed, read_1500, disabled},
     {run, undo(kind::overwritten), undo(kind::overwritten), x, x, undo(kind::silent), undo(kind::refused), undo(kind::state_timeout)}},
    {"running", {begun, disabled, confirmed, confirmed, read_1500, disabled, read_0},
     {x, x, x, read_back, x, ramp(kind::silent), ramp(kind::refused), ramp(kind::state_timeout)}},
    {"reading the reference of one that was told to run",
     {begun, disabled, confirmed, confirmed, read_1500, disabled, read_0, confirmed},
     {ramp(kind::not_taken), eta, ramp(kind::not_taken), x, x, ramp(kind::silent), ramp(kind::refused), ramp(kind::state_timeout)}},
    {"a wait for operation", {begun, disabled, confirmed, confirmed, read_1500, disabled, read_0, confirmed, read_1500, disabled},
     {x, x, x, x, eta, ramp(kind::silent), x, ramp(kind::state_timeout)}},
    {"the fault of a drive that was not commanded", {begun, word(fault_word)},
     {fault, fault, fault, x, x, silent, refused, fault}},
    {"the fault of one that holds 0000", {begun, disabled, confirmed, confirmed, read_1500, word(fault_word)},
     {fault, fault, fault, x, x, silent, refused, fault}},
    {"the fault of one that was told to run",
     {begun, disabled, confirmed, confirmed, read_1500, disabled, read_0, confirmed, read_1500, word(fault_word)},
     {ramp(kind::in_fault), ramp(kind::in_fault), ramp(kind::in_fault), x, x, ramp(kind::silent), ramp(kind::refused), ramp(kind::in_fault)}},
}};
// clang-format on

constexpr atv28::direct_start_procedure checked_before{{speed, 1'500}, supervision_procedure{layout, commissioned()}};
constexpr atv28::direct_start_procedure unchecked{{speed, 1'500}, supervision_procedure{layout, unlimited, false}};

} // namespace

TEST_CASE("a direct start does at each look what its table says") { check_table(checked_before, statuses, look_rows); }

TEST_CASE("a direct start does in each stage, at each answer, what its table says")
{
    check_table(checked_before, others, other_rows);
}

TEST_CASE("a direct start begins with a look, and ends with its check")
{
    CHECK(does(checked_before, begun, eta));
    way const examining{begun, disabled};
    CHECK(does(led(unchecked, {begun}), disabled, reads(layout.cmi)));
    CHECK(does(led(unchecked, examining), word(layout.safeguards.nto), ends(kind::unsupervised)));
    CHECK(does(led(unchecked, examining), failed(errc::timed_out), silent));
    CHECK(does(led(unchecked, examining), failed(errc::illegal_data_address), ends(kind::unknown_register)));
    CHECK(does(led(unchecked, examining), failed(errc::server_device_failure), refused));
    CHECK(does(led(unchecked, examining), late, aborted));
}

TEST_CASE("a direct start is withdrawn at any of its writes where the client has no place for one more drive")
{
    event const no_place = failed(errc::too_many_ordered);
    way const clearing{begun, disabled}, writing{begun, disabled, confirmed};
    way const telling{begun, disabled, confirmed, confirmed, read_1500, disabled, read_0};
    CHECK(does(led(checked_before, clearing), no_place, undo(kind::no_place)));
    CHECK(does(led(checked_before, writing), no_place, undo(kind::no_place)));
    CHECK(does(led(checked_before, telling), no_place, ramp(kind::no_place)));
}
