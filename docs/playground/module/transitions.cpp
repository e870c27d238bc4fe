// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
#include "transitions.hpp"

#include "json.hpp"

namespace playground {

namespace {

using rtuwire::cia402::command;
using rtuwire::cia402::state;
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

/// Two commands may cause the same transition: 7 and 10 are "disable voltage or quick stop".
void add(std::vector<drawn_transition>& to, rtuwire::cia402::transition_rule const& rule)
{
    for (drawn_transition& each : to) {
        if (each.number == rule.number and each.from == rule.from) {
            each.cause += " or " + std::string{text(name_of(rule.cause))};
            return;
        }
    }
    to.push_back({rule.number, rule.from, rule.to, std::string{text(name_of(rule.cause))}, true});
}

} // namespace

std::vector<drawn_transition> transitions_of(rtuwire::cia402::state_machine_options const& options)
{
    std::vector<drawn_transition> all{
        {transition::t0, state::unknown, state::not_ready_to_switch_on, "power on", false},
        {transition::t1, state::not_ready_to_switch_on, state::switch_on_disabled, "initialised", false},
        {transition::t13, state::unknown, state::fault_reaction_active, "a fault", false},
        {transition::t14, state::fault_reaction_active, state::fault, "the motor stands", false},
    };
    if (not options.quick_stop_waits) {
        all.push_back(
            {transition::t12, state::quick_stop_active, state::switch_on_disabled, "the motor stands", false});
    }
    for (state const from : states) {
        for (command const what : commands) {
            auto const rule = rtuwire::cia402::step(from, what, options);
            if (rule.number != transition::none) {
                add(all, rule);
            }
        }
    }
    return all;
}

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
    for (drawn_transition const& each : transitions_of(options)) {
        out.open_object();
        out.put("number", text(name_of(each.number)));
        out.put("from", each.from == state::unknown ? std::string_view{} : text(name_of(each.from)));
        out.put("to", text(name_of(each.to)));
        out.put("cause", each.cause);
        out.put("command", each.is_command);
        out.close_object();
    }
    out.close_list();
    out.close_object();
    return out.text();
}

} // namespace playground
