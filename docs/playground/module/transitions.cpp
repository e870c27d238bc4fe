// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
#include "transitions.hpp"

#include <array>
#include <cstddef>
#include <string_view>

#include "json.hpp"

namespace playground {

namespace {

using rtuwire::cia402::command;
using rtuwire::cia402::state;
using rtuwire::cia402::step;
using rtuwire::cia402::transition;

constexpr std::array states{
    state::not_ready_to_switch_on, state::switch_on_disabled, state::ready_to_switch_on,    state::switched_on,
    state::operation_enabled,      state::quick_stop_active,  state::fault_reaction_active, state::fault,
};

constexpr std::array commands{
    command::shutdown,        command::switch_on,  command::enable_operation,
    command::disable_voltage, command::quick_stop, command::fault_reset,
};

std::string_view text(rtuwire::literal from) { return from; }

/// From `unknown`: from any state.
void put(json_text& out, transition number, state from, state to, std::string_view cause, bool is_command)
{
    out.open_object();
    out.put("number", text(name_of(number)));
    out.put("from", from == state::unknown ? std::string_view{} : text(name_of(from)));
    out.put("to", text(name_of(to)));
    out.put("cause", cause);
    out.put("command", is_command);
    out.close_object();
}

/// The transition that a command causes, where no command before it does: 7 and 10 are "disable voltage or quick stop".
void put_of_command(json_text& out, state from, std::size_t at, rtuwire::cia402::state_machine_options const& options)
{
    auto const rule = step(from, commands[at], options);
    std::string cause;
    for (std::size_t other = 0; other < commands.size(); ++other) {
        auto const same = step(from, commands[other], options);
        if (same.number != rule.number) {
            continue;
        }
        if (other < at or rule.number == transition::none) {
            return;
        }
        cause += cause.empty() ? "" : " or ";
        cause += text(name_of(same.cause));
    }
    put(out, rule.number, from, rule.to, cause, true);
}

} // namespace

std::string describe_machine(rtuwire::cia402::state_machine_options const& options)
{
    json_text out;
    out.open_object();
    out.open_list("states");
    for (state const each : states) {
        out.put("", text(name_of(each)));
    }
    out.close_list();
    out.open_list("transitions");
    put(out, transition::t0, state::unknown, state::not_ready_to_switch_on, "power on", false);
    put(out, transition::t1, state::not_ready_to_switch_on, state::switch_on_disabled, "initialised", false);
    put(out, transition::t13, state::unknown, state::fault_reaction_active, "a fault", false);
    put(out, transition::t14, state::fault_reaction_active, state::fault, "the motor stands", false);
    if (not options.quick_stop_waits) {
        put(out, transition::t12, state::quick_stop_active, state::switch_on_disabled, "the motor stands", false);
    }
    for (state const from : states) {
        for (std::size_t at = 0; at < commands.size(); ++at) {
            put_of_command(out, from, at, options);
        }
    }
    out.close_list();
    out.close_object();
    return out.text();
}

} // namespace playground
