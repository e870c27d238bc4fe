// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// The table of what a response makes of a cycle: each step and each answer, as it stands beside the code.
#include <rtuwire/altivar/cyclic/cycle_agenda.hpp>

#include <array>
#include <cstddef>

#include "support/catch.hpp"

using namespace rtuwire;
using namespace rtuwire::altivar;
using step = cycle_step;

namespace {

constexpr std::uint16_t ready = 0x0231, running = 0x0237, in_fault = 0x0208;

constexpr std::array all_steps{
    step::look,          step::look_for_fault,  step::prepare,         step::exchange,
    step::read,          step::write,           step::say_stop,        step::observe,
    step::check_control, step::compare_meaning, step::compare_control, step::compare_reference};

/// A cycle that was prepared, of a drive that was found so, at a step.
constexpr cycle_agenda at(step now, step first, std::uint16_t status, bool is_ordered)
{
    cycle_agenda agenda{first};
    agenda.end_preparation(status);
    if (is_ordered) {
        static_cast<void>(agenda.run(100));
    }
    agenda.begin(now);
    return agenda;
}

/// The step after a response, that shows this status where it shows one.
constexpr step answered(cycle_agenda agenda, std::uint16_t status, bool is_prepared = true)
{
    agenda.note_response();
    switch (agenda.now()) {
    case step::look: agenda.take_look(status); break;
    case step::look_for_fault: agenda.take_fault_code(9, is_prepared); break;
    case step::prepare: agenda.end_preparation(status); break;
    case step::exchange:
    case step::read:
    case step::observe: agenda.take_status(status, false); break;
    case step::write: agenda.end_exchange(); break;
    case step::say_stop: agenda.end_stop_word(is_prepared); break;
    case step::check_control:
    case step::compare_meaning:
    case step::compare_control:
    case step::compare_reference: agenda.compare(7, 7); break;
    }
    return agenda.now();
}
/// The step after a failure; one miss is tolerated.
constexpr step failed(cycle_agenda agenda, errc error, unsigned times = 1)
{
    for (unsigned i = 0; i < times; ++i) {
        static_cast<void>(agenda.miss(error, 1));
    }
    return agenda.now();
}

struct row {
    step now;
    step answered;      ///< the drive runs as ordered
    step in_two_halves; ///< the same, by functions 03 and 16
    step unprepared;
    step into_fault;
    step unordered; ///< the drive runs without an order
    step missed;    ///< once, with an order
    step lost;
    step cancelled;
    step overruled;
};

constexpr step look = step::look, code = step::look_for_fault, prepare = step::prepare, transfer = step::exchange,
               half = step::read, write = step::write, stop = step::say_stop, observe = step::observe,
               check = step::check_control, meaning = step::compare_meaning, control = step::compare_control,
               set_point = step::compare_reference;

// clang-format off
constexpr std::array<row, all_steps.size()> rows{{
    // step     answered  halves    unprepared into fault unordered missed lost  cancelled  overruled
    {look,      code,     code,     code,      code,      code,     look, look, look,      look},
    {code,      transfer, half,     prepare,   transfer,  transfer, look, look, code,      look},
    {prepare,   transfer, half,     transfer,  code,      transfer, look, look, prepare,   look},
    {transfer,  transfer, transfer, transfer,  code,      transfer, look, look, transfer,  look},
    {half,      write,    write,    write,     code,      write,    look, look, half,      look},
    {write,     transfer, half,     transfer,  transfer,  transfer, look, look, write,     look},
    {stop,      observe,  observe,  look,      observe,   observe,  stop, stop, stop,      look},
    {observe,   transfer, half,     transfer,  code,      stop,     look, look, observe,   look},
    {check,     transfer, write,    transfer,  transfer,  transfer, look, look, check,     look},
    {meaning,   transfer, half,     transfer,  transfer,  transfer, look, look, meaning,   look},
    {control,   transfer, half,     transfer,  transfer,  transfer, look, look, control,   look},
    {set_point, transfer, half,     transfer,  transfer,  transfer, look, look, set_point, look},
}};
// clang-format on

} // namespace

TEST_CASE("what a response makes of a cycle is what its table holds")
{
    for (std::size_t i = 0; i < rows.size(); ++i) {
        row const& each = rows[i];
        INFO("step " << i);
        REQUIRE(each.now == all_steps[i]);
        cycle_agenda const ordered = at(each.now, transfer, running, true);
        CHECK(answered(ordered, running) == each.answered);
        CHECK(answered(ordered, running, false) == each.unprepared);
        CHECK(answered(ordered, in_fault) == each.into_fault);
        CHECK(answered(at(each.now, transfer, running, false), running) == each.unordered);
        if (each.now != transfer) {
            CHECK(answered(at(each.now, half, running, true), running) == each.in_two_halves);
        }
    }
}

TEST_CASE("what a failure makes of a cycle is what its table holds")
{
    for (row const& each : rows) {
        INFO("step " << static_cast<unsigned>(each.now));
        cycle_agenda const climbing = at(each.now, transfer, ready, true);
        cycle_agenda const ordered = at(each.now, transfer, running, true);
        CHECK(failed(climbing, errc::timed_out) == each.missed);
        CHECK(failed(ordered, errc::timed_out) == each.missed);
        CHECK(failed(ordered, errc::timed_out, 2) == each.lost);
        CHECK(failed(ordered, errc::unit_lost) == each.lost);
        CHECK(failed(ordered, errc::server_device_failure) == each.lost);
        CHECK(failed(ordered, errc::cancelled) == each.cancelled);
        CHECK(failed(ordered, errc::overruled) == each.overruled);
    }
}

TEST_CASE("a cycle whose preparation fails begins anew, and stops a motor that it ordered to run")
{
    cycle_agenda agenda = at(prepare, transfer, running, true);
    agenda.fail_preparation(outcome_kind::misconfigured);
    CHECK(agenda.now() == look);
    CHECK(agenda.is_lost());
    CHECK_FALSE(agenda.control().is_ordered());
    CHECK(agenda.due(false, false, 0) == step::say_stop);
    cycle_agenda again = at(transfer, transfer, running, true);
    again.look_again();
    CHECK(again.now() == look);
    CHECK_FALSE(again.is_lost());
}
