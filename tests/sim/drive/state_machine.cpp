// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// The simulated drive's state machine: what every event does in every state, with every kind of drive.
#include <rtuwire/sim/drive/state_machine.hpp>

#include <array>

#include "support/catch.hpp"

using namespace rtuwire;
using namespace rtuwire::cia402;

namespace {

enum class place { starting, disabled, ready, on, operation, leaving, quick_stop, reacting, fault };
constexpr std::array places{place::starting, place::disabled,   place::ready,    place::on,   place::operation,
                            place::leaving,  place::quick_stop, place::reacting, place::fault};

enum class event {
    power_up,
    initialised,
    shutdown,
    switch_on,
    enable,
    disable,
    quick_stop,
    reset,
    reset_with_cause,
    rest,
    trip,
    directly,
};
constexpr std::array events{event::power_up,         event::initialised, event::shutdown,   event::switch_on,
                            event::enable,           event::disable,     event::quick_stop, event::reset,
                            event::reset_with_cause, event::rest,        event::trip,       event::directly};

/// Which drives a row is for.
enum class only { all, with_3b, without_3b, not_waiting, resuming };

struct row {
    place from;
    event what;
    place to;
    transition number; ///< `none` where the profile has none for it
    only drives{only::all};
};

/// All that changes a state. What stands in no row changes nothing.
constexpr row rows[] = {
    {place::starting, event::initialised, place::disabled, transition::t1},
    {place::starting, event::trip, place::reacting, transition::t13},

    {place::disabled, event::shutdown, place::ready, transition::t2},
    {place::disabled, event::trip, place::reacting, transition::t13},
    {place::disabled, event::directly, place::operation, transition::none},

    {place::ready, event::switch_on, place::on, transition::t3},
    {place::ready, event::enable, place::operation, transition::t3b, only::with_3b},
    {place::ready, event::enable, place::operation, transition::t4, only::without_3b},
    {place::ready, event::disable, place::disabled, transition::t7},
    {place::ready, event::quick_stop, place::disabled, transition::t7},
    {place::ready, event::trip, place::reacting, transition::t13},
    {place::ready, event::directly, place::operation, transition::none},

    {place::on, event::shutdown, place::ready, transition::t6},
    {place::on, event::enable, place::operation, transition::t4},
    {place::on, event::disable, place::disabled, transition::t10},
    {place::on, event::quick_stop, place::disabled, transition::t10},
    {place::on, event::trip, place::reacting, transition::t13},
    {place::on, event::directly, place::operation, transition::none},

    {place::operation, event::shutdown, place::ready, transition::t8},
    {place::operation, event::switch_on, place::leaving, transition::none},
    {place::operation, event::disable, place::disabled, transition::t9},
    {place::operation, event::quick_stop, place::quick_stop, transition::t11},
    {place::operation, event::trip, place::reacting, transition::t13},

    {place::leaving, event::shutdown, place::ready, transition::t8},
    {place::leaving, event::enable, place::operation, transition::none},
    {place::leaving, event::reset, place::operation, transition::none},
    {place::leaving, event::disable, place::disabled, transition::t9},
    {place::leaving, event::quick_stop, place::quick_stop, transition::t11},
    {place::leaving, event::rest, place::on, transition::t5},
    {place::leaving, event::trip, place::reacting, transition::t13},
    {place::leaving, event::directly, place::operation, transition::none},

    {place::quick_stop, event::disable, place::disabled, transition::t12},
    {place::quick_stop, event::enable, place::operation, transition::t16, only::resuming},
    {place::quick_stop, event::rest, place::disabled, transition::t12, only::not_waiting},
    {place::quick_stop, event::trip, place::reacting, transition::t13},
    {place::quick_stop, event::directly, place::operation, transition::none},

    {place::reacting, event::rest, place::fault, transition::t14},

    {place::fault, event::reset, place::disabled, transition::t15},
};

bool is_for(only drives, state_machine_options const& options)
{
    switch (drives) {
    case only::with_3b: return options.enables_from_ready;
    case only::without_3b: return not options.enables_from_ready;
    case only::not_waiting: return not options.quick_stop_waits;
    case only::resuming: return options.resumes_from_quick_stop;
    case only::all: break;
    }
    return true;
}

void happen(detail::state_machine& machine, event what)
{
    switch (what) {
    case event::power_up: return machine.power_up();
    case event::initialised: return machine.initialised();
    case event::shutdown: return machine.apply(command::shutdown, true);
    case event::switch_on: return machine.apply(command::switch_on, true);
    case event::enable: return machine.apply(command::enable_operation, true);
    case event::disable: return machine.apply(command::disable_voltage, true);
    case event::quick_stop: return machine.apply(command::quick_stop, true);
    case event::reset: return machine.apply(command::fault_reset, true);
    case event::reset_with_cause: return machine.apply(command::fault_reset, false);
    case event::rest: return machine.at_rest();
    case event::trip: return machine.trip();
    case event::directly: return machine.enable_directly();
    }
}

place place_of(detail::state_machine const& machine)
{
    switch (machine.state()) {
    case state::switch_on_disabled: return place::disabled;
    case state::ready_to_switch_on: return place::ready;
    case state::switched_on: return place::on;
    case state::operation_enabled: return machine.is_leaving() ? place::leaving : place::operation;
    case state::quick_stop_active: return place::quick_stop;
    case state::fault_reaction_active: return place::reacting;
    case state::fault: return place::fault;
    case state::not_ready_to_switch_on:
    case state::unknown: break;
    }
    return place::starting;
}

/// A machine in a state, by the shortest way from power-up.
detail::state_machine machine_in(place wanted, state_machine_options const& options)
{
    detail::state_machine machine{options};
    auto const walk = [&](auto... steps) { (happen(machine, steps), ...); };
    machine.power_up();
    switch (wanted) {
    case place::starting: break;
    case place::disabled: walk(event::initialised); break;
    case place::ready: walk(event::initialised, event::shutdown); break;
    case place::on: walk(event::initialised, event::shutdown, event::switch_on); break;
    case place::operation: walk(event::initialised, event::directly); break;
    case place::leaving: walk(event::initialised, event::directly, event::switch_on); break;
    case place::quick_stop: walk(event::initialised, event::directly, event::quick_stop); break;
    case place::reacting: walk(event::trip); break;
    case place::fault: walk(event::trip, event::rest); break;
    }
    return machine;
}

row row_for(place from, event what, state_machine_options const& options)
{
    if (what == event::power_up) {
        return {from, what, place::starting, transition::t0};
    }
    for (row const& each : rows) {
        if (each.from == from and each.what == what and is_for(each.drives, options)) {
            return each;
        }
    }
    return {from, what, from, transition::none};
}

} // namespace

TEST_CASE("every event in every state of the simulated drive does what its table says")
{
    for (unsigned kind = 0; kind < 8; ++kind) {
        state_machine_options const options{(kind & 1U) != 0, (kind & 2U) != 0, (kind & 4U) != 0};
        for (place const from : places) {
            for (event const what : events) {
                INFO("kind " << kind << ", state " << int(from) << ", event " << int(what));
                row const expected = row_for(from, what, options);
                detail::state_machine machine = machine_in(from, options);
                REQUIRE(place_of(machine) == from);
                transition const before = machine.last();
                happen(machine, what);
                CHECK(place_of(machine) == expected.to);
                CHECK(machine.last() == (expected.number == transition::none ? before : expected.number));
            }
        }
    }
}

TEST_CASE("a drive without 3B takes 3 and 4, and a trip remembers a quick stop")
{
    detail::state_machine machine = machine_in(place::ready, {});
    happen(machine, event::enable);
    CHECK((machine.taken() & 1U << unsigned(transition::t3)) != 0);
    for (place const from : {place::operation, place::quick_stop}) {
        detail::state_machine tripped = machine_in(from, {});
        tripped.trip();
        CHECK(tripped.tripped_in_quick_stop() == (from == place::quick_stop));
    }
}
