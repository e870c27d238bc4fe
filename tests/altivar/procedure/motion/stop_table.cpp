// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// The tables of a stop: each stage and each answer, as they stand beside the code.
#include <rtuwire/altivar/procedure/motion/stop.hpp>

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
constexpr std::uint16_t ready = 0x0231, enabled = 0x0237;

constexpr cell eta = reads(layout.eta), lft = reads(layout.lft), cmd = reads(layout.cmd);
constexpr cell leave = writes(layout.cmd, 0x0000), ramp = writes(layout.cmd, 0x0007);
constexpr cell fast = writes(layout.cmd, 0x0002);
constexpr cell x = never;

constexpr std::array<answer, 12> statuses{{
    {"not ready to switch on", word(0x0200)},
    {"switch on disabled", word(0x0250)},
    {"ready to switch on", word(ready)},
    {"switched on", word(0x0233)},
    {"operation enabled", word(enabled)},
    {"quick stop active", word(0x0217)},
    {"fault", word(0x0238)},
    {"no state", word(0x0201)},
    {"operation enabled in local control", word(0x0037)},
    {"no response", failed(errc::timed_out)},
    {"refused", failed(errc::server_device_failure)},
    {"limit over", late},
}};
constexpr cell done = ends(kind::succeeded), local = ends(kind::local_control), fault = ends(kind::in_fault);
constexpr cell unconfirmed = ends(kind::unconfirmed), too_late = ends(kind::state_timeout);
constexpr cell silent = ends(kind::silent);

/// Up to a look, and up to the look behind "ready to switch on".
constexpr way at_look{begun, confirmed}, at_look_below{begun, confirmed, word(ready), confirmed};

constexpr std::array<stage_row<12>, 2> looks{{
    {"a look", at_look, {done, done, leave, leave, pauses, pauses, lft, pauses, local, pauses, pauses, unconfirmed}},
    {"a look below power",
     at_look_below,
     {done, done, pauses, pauses, pauses, pauses, lft, pauses, local, pauses, pauses, unconfirmed}},
}};
/// A halt reads before it writes, and becomes the ramp where it cannot: what it reads then ends nothing.
constexpr std::array<stage_row<12>, 1> first_looks{{
    {"a first look", {begun}, {ramp, ramp, ramp, ramp, cmd, pauses, ramp, ramp, ramp, ramp, ramp, ramp}},
}};

constexpr std::array<answer, 8> others{{
    {"0", words(enabled, 0)},
    {"30 Hz", words(enabled, 300)},
    {"20 Hz", words(enabled, 200)},
    {"confirmed", confirmed},
    {"pause over", pause_over},
    {"no response", failed(errc::timed_out)},
    {"refused", failed(errc::server_device_failure)},
    {"limit over", late},
}};
constexpr std::array<stage_row<8>, 9> ramp_rows{{
    {"the word, to be confirmed", {begun}, {x, x, x, eta, x, pauses, pauses, silent}},
    {"after a word that was lost", {begun, failed(errc::timed_out)}, {x, x, x, x, ramp, x, x, silent}},
    {"a look", {begun, confirmed}, {pauses, pauses, pauses, x, x, pauses, pauses, unconfirmed}},
    {"after 20 Hz", {begun, confirmed, words(enabled, 200)}, {x, x, x, x, ramp, x, x, unconfirmed}},
    {"a look after 0",
     {begun, confirmed, words(enabled, 0), pause_over, confirmed},
     {leave, pauses, pauses, x, x, pauses, pauses, unconfirmed}},
    {"as fast as before",
     {begun, confirmed, words(enabled, 200), pause_over, confirmed, words(enabled, 200)},
     {x, x, x, x, ramp, x, x, too_late}},
    {"slower than before",
     {begun, confirmed, words(enabled, 300), pause_over, confirmed, words(enabled, 200)},
     {x, x, x, x, ramp, x, x, unconfirmed}},
    {"leaving a state below power", {begun, confirmed, word(ready)}, {x, x, x, eta, x, pauses, pauses, unconfirmed}},
    {"the fault", {begun, confirmed, word(0x0238)}, {fault, fault, fault, x, x, pauses, pauses, unconfirmed}},
}};

constexpr cell halt = writes(layout.cmd, 0x010F);
constexpr std::array<stage_row<8>, 4> halt_rows{{
    {"a first look", {begun}, {cmd, cmd, cmd, x, x, ramp, ramp, ramp}},
    {"the control word, which is none that runs",
     {begun, words(enabled, 300)},
     {ramp, ramp, ramp, x, x, ramp, ramp, ramp}},
    {"the halt, to be confirmed",
     {begun, words(enabled, 300), words(0x000F, 300)},
     {x, x, x, eta, x, ramp, pauses, silent}},
    {"a look at a motor that halts",
     {begun, words(enabled, 300), words(0x000F, 300), confirmed},
     {pauses, halt, pauses, x, x, ramp, pauses, unconfirmed}},
}};

constexpr auto const& old = atv28::device::layout;
constexpr stop_procedure ramp_stop{layout, stop_by::ramp};
constexpr stop_procedure quick{layout, stop_by::quick_stop};
constexpr stop_procedure halt_stop{layout, stop_by::halt};
constexpr stop_procedure injection{old, stop_by::dc_injection};

} // namespace

TEST_CASE("a stop does at each look what its table says")
{
    check_table(ramp_stop, statuses, looks);
    check_table(quick, statuses, looks);
    check_table(halt_stop, statuses, first_looks);
}

TEST_CASE("a stop does in each stage, at each answer, what its table says")
{
    check_table(ramp_stop, others, ramp_rows);
    check_table(halt_stop, others, halt_rows);
}

TEST_CASE("a stop begins with its word, or with a look")
{
    CHECK(does(ramp_stop, begun, ramp));
    CHECK(does(quick, begun, fast));
    CHECK(does(halt_stop, begun, eta));
    CHECK(does(injection, begun, reads(old.lft)));                           // and ETA behind it
    CHECK(does(stop_procedure{layout, stop_by::dc_injection}, begun, ramp)); // it has no such stop
}
