// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// The table of the step that is due in a cycle: each situation and each step, as it stands beside the code.
#include <rtuwire/altivar/cyclic/cycle_agenda.hpp>

#include <array>
#include <cstddef>

#include "support/catch.hpp"

using namespace rtuwire;
using namespace rtuwire::altivar;
using step = cycle_step;

namespace {

constexpr std::uint16_t ready = 0x0231, on = 0x0233, running = 0x0237;

/// All that a step depends on.
struct situation {
    char const* name;
    cyclic_control control{};
    stop_duty duty{};
    bool is_prepared{true};
    bool was_rearranged{false};
    bool was_taken{false};
    std::uint16_t last_command{0};
    unsigned exchanges{0};
};

constexpr cyclic_control found(std::uint16_t status, bool is_ordered)
{
    cyclic_control control;
    control.note_status(status, false);
    if (is_ordered) {
        static_cast<void>(control.run(100));
    }
    return control;
}
/// A drive in "switched on" whose next command is the one that enables it.
constexpr cyclic_control about_to_enable()
{
    cyclic_control control = found(on, true);
    static_cast<void>(control.next_command());
    control.note_status(on, false);
    return control;
}
/// Another conversation's order counts.
constexpr cyclic_control giving_way(std::uint16_t status)
{
    cyclic_control control = found(status, false);
    control.give_way(true);
    return control;
}
constexpr cyclic_control halting()
{
    cyclic_control control = found(running, true);
    control.stop(stop_by::halt);
    return control;
}
constexpr stop_duty to_stop(bool is_halt)
{
    stop_duty duty;
    duty.take_stop(is_halt);
    return duty;
}

constexpr std::array all_steps{
    step::look,          step::look_for_fault,  step::prepare,         step::exchange,
    step::read,          step::write,           step::say_stop,        step::observe,
    step::check_control, step::compare_meaning, step::compare_control, step::compare_reference};

struct row {
    situation at;
    std::array<step, all_steps.size()> due; ///< in the order above
};

constexpr step look = step::look, code = step::look_for_fault, prepare = step::prepare, transfer = step::exchange,
               read = step::read, write = step::write, stop = step::say_stop, observe = step::observe,
               check = step::check_control, meaning = step::compare_meaning, control = step::compare_control,
               set_point = step::compare_reference;

// clang-format off
constexpr std::array<row, 13> rows{{
    // where the cycle is:
    //  look, look_for_fault, prepare, exchange, read, write, say_stop, observe, check, compare meaning, control, reference
    {{.name = "a stop was ordered", .duty = to_stop(false)},
     {stop, stop, stop, stop, stop, stop, stop, stop, stop, stop, stop, stop}},
    {{.name = "a halt was ordered", .control = halting(), .duty = to_stop(true)},
     {observe, observe, observe, observe, observe, observe, observe, observe, observe, observe, observe, observe}},
    {{.name = "not prepared", .control = found(ready, false), .is_prepared = false},
     {look, code, prepare, look, look, look, stop, observe, check, meaning, control, set_point}},
    {{.name = "rearranged", .control = found(ready, true), .was_rearranged = true},
     {look, code, prepare, look, look, look, look, observe, check, meaning, control, set_point}},
    {{.name = "power without an order", .control = found(running, false)},
     {look, code, prepare, stop, stop, stop, stop, observe, check, meaning, control, set_point}},
    {{.name = "a halt under way", .control = halting()},
     {look, code, prepare, observe, observe, observe, stop, observe, check, meaning, control, set_point}},
    {{.name = "another's order", .control = giving_way(ready)},
     {look, code, prepare, observe, observe, observe, stop, observe, check, meaning, control, set_point}},
    {{.name = "power by another's order", .control = giving_way(running)},
     {look, code, prepare, stop, stop, stop, stop, observe, check, meaning, control, set_point}},
    {{.name = "the same word again", .control = found(ready, true), .was_taken = true, .last_command = 7},
     {look, code, prepare, observe, observe, observe, look, observe, check, meaning, control, set_point}},
    {{.name = "the same word, not accepted", .control = found(ready, true), .last_command = 7},
     {look, code, prepare, transfer, read, write, look, observe, check, meaning, control, set_point}},
    {{.name = "before the command to run", .control = about_to_enable()},
     {look, code, prepare, check, read, check, look, observe, check, meaning, control, set_point}},
    {{.name = "ten exchanges of a running drive", .control = found(running, true), .exchanges = 10},
     {look, code, prepare, meaning, meaning, write, look, observe, check, meaning, control, set_point}},
    {{.name = "any other", .control = found(running, true), .exchanges = 9},
     {look, code, prepare, transfer, read, write, look, observe, check, meaning, control, set_point}},
}};
// clang-format on

/// The position at a step in a situation.
constexpr cycle_position at(situation const& where, step now)
{
    cycle_position position{transfer};
    for (unsigned i = 0; i < where.exchanges; ++i) {
        position.note_taken();
    }
    if (where.was_taken) {
        position.note_taken();
    } else {
        position.note_write();
    }
    position.go_to(now);
    return position;
}

} // namespace

TEST_CASE("the step that is due in a cycle is the one that its table holds")
{
    for (row const& each : rows) {
        for (std::size_t i = 0; i < all_steps.size(); ++i) {
            INFO(each.at.name << ", at step " << i);
            CHECK(at(each.at, all_steps[i])
                      .due(each.at.control, each.at.duty, each.at.is_prepared, each.at.was_rearranged,
                           each.at.last_command) == each.due[i]);
        }
    }
}

TEST_CASE(
    "CHCF, the control word and the reference are compared in turn, the control word before the command to run once")
{
    situation const running_drive{.name = "", .control = found(running, true), .exchanges = 10};
    auto const due = [](cycle_position const& position, cyclic_control const& law) {
        return position.due(law, stop_duty{}, true, false, 0);
    };
    cycle_position position = at(running_drive, transfer);
    for (step const next : {meaning, control, set_point, meaning, control}) {
        CHECK(due(position, running_drive.control) == next);
        position.go_to(next);
        position.note_comparison();
        CHECK(due(position, running_drive.control) == transfer);
        for (unsigned i = 0; i < 10; ++i) {
            position.note_taken();
        }
    }
    position.go_to(control);
    position.note_comparison();
    position.note_standstill();
    CHECK(due(position, running_drive.control) == meaning); // at once

    cycle_position checked = at(situation{.name = ""}, check);
    checked.note_comparison();
    CHECK(checked.now() == transfer);
    CHECK(due(checked, about_to_enable()) == transfer);
    checked.keep_comparison_if(false);
    CHECK(due(checked, about_to_enable()) == check);
}
