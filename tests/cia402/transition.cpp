// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Control words, and every pair of a state and a command.
#include <rtuwire/cia402/transition.hpp>

#include <array>

#include "support/proof.hpp"

#include <rtuwire/cia402/next_command.hpp>

using namespace rtuwire;
using namespace rtuwire::cia402;
using namespace rtuwire::detail;

namespace {

constexpr state_machine_options profile{false, false, true};
constexpr state_machine_options altivar{true, false, false};

constexpr std::array all_states{
    state::unknown,     state::not_ready_to_switch_on, state::switch_on_disabled, state::ready_to_switch_on,
    state::switched_on, state::operation_enabled,      state::quick_stop_active,  state::fault_reaction_active,
    state::fault};
constexpr std::array all_commands{
    command::none,       command::shutdown,   command::switch_on, command::enable_operation, command::disable_voltage,
    command::quick_stop, command::fault_reset};

/// The numbers of the transitions, a row for each state in the order above, a column for each command.
/// -1: not accepted; 30: 3B, which only some drives have; 16: which only others have.
constexpr int state_machine[9][7] = {
    //  none shutdown switch_on enable disable quick reset
    {-1, -1, -1, -1, -1, -1, -1}, // unknown
    {-1, -1, -1, -1, -1, -1, -1}, // not ready to switch on
    {-1, 2, -1, -1, -1, -1, -1},  // switch on disabled
    {-1, -1, 3, 30, 7, 7, -1},    // ready to switch on
    {-1, 6, -1, 4, 10, 10, -1},   // switched on
    {-1, 8, 5, -1, 9, 11, -1},    // operation enabled
    {-1, -1, -1, 16, 12, -1, -1}, // quick stop active
    {-1, -1, -1, -1, -1, -1, -1}, // fault reaction active
    {-1, -1, -1, -1, -1, -1, 15}, // fault
};

constexpr transition expected(int number, state_machine_options const& options)
{
    switch (number) {
    case -1: return transition::none;
    case 30: return options.enables_from_ready ? transition::t3b : transition::none;
    case 16: return options.resumes_from_quick_stop ? transition::t16 : transition::none;
    default: return static_cast<transition>(number);
    }
}

constexpr bool follows_the_chart()
{
    for (auto const& options : {profile, altivar}) {
        for (std::size_t row = 0; row < all_states.size(); ++row) {
            for (std::size_t column = 0; column < all_commands.size(); ++column) {
                transition_rule const taken = step(all_states[row], all_commands[column], options);
                bool const stays = taken.to == all_states[row];
                if (taken.number != expected(state_machine[row][column], options) or
                    stays != (taken.number == transition::none)) {
                    return false;
                }
            }
        }
    }
    return true;
}
PROOF("every pair of a state and a command takes the profile's arrow or none", follows_the_chart)

constexpr bool recognises_its_words()
{
    for (command const each : all_commands) {
        bool const has_bits = each != command::none and each != command::fault_reset;
        if (has_bits and command_in(word_of(each)) != each) {
            return false;
        }
    }
    return command_in(0x080F) == command::enable_operation and command_in(0x010F) == command::enable_operation and
           command_in(0x000B) == command::quick_stop and command_in(0x000E) == command::shutdown and
           command_in(0x000D) == command::disable_voltage;
}
PROOF("control words are recognised by their bits", recognises_its_words)

constexpr bool resets_by_the_edge_only()
{
    // A word asks for the same with and without bit 7.
    for (std::uint16_t low = 0; low < 0x10; ++low) {
        if (command_in(static_cast<std::uint16_t>(low | 0x80U)) != command_in(low)) {
            return false;
        }
    }
    return is_reset_edge(0, 0x80) and is_reset_edge(0, 0x8F) and not is_reset_edge(0x80, 0x80) and
           not is_reset_edge(0x80, 0x06);
}
PROOF("bit 7 counts by its edge, and is no part of a command", resets_by_the_edge_only)

/// Follows the commands toward a goal until none is left; whether that ends in the goal.
template <typename Toward, typename Goal> constexpr bool arrives(state from, Toward toward, Goal is_goal)
{
    for (unsigned steps = 0; steps < 8; ++steps) {
        command const next = toward(from);
        if (next == command::none) {
            return is_goal(from);
        }
        from = step(from, next, altivar).to;
    }
    return false;
}

constexpr bool leads_to_the_goals()
{
    for (state const from : all_states) {
        bool const can_enable = enable_rank(from) > 0;
        bool const runs =
            arrives(from, next_command_to_enable, [](state at) { return at == state::operation_enabled; });
        if (runs != can_enable) {
            return false;
        }
    }
    return true;
}
PROOF("the ways end where they lead, from every state", leads_to_the_goals)

/// The height of each state, in the order above.
constexpr std::array ranks{-1, 0, 1, 2, 3, 4, -1, -1, -1};
constexpr bool rises_step_by_step()
{
    for (std::size_t i = 0; i < all_states.size(); ++i) {
        if (enable_rank(all_states[i]) != ranks[i]) {
            return false;
        }
    }
    return true;
}
PROOF("the way up has heights of 0 to 4, and off it there is none", rises_step_by_step)

// A drive of which nothing is told has the profile's chart without what drives may lack.
STATIC_CHECK(step(state::ready_to_switch_on, command::enable_operation, {}).number == transition::none);
STATIC_CHECK(step(state::quick_stop_active, command::enable_operation, {}).number == transition::none);
STATIC_CHECK(not state_machine_options{}.quick_stop_waits);

STATIC_CHECK(name_of(transition::t3b) == literal{"3B"} and name_of(transition::t0) == literal{"0"});
STATIC_CHECK(name_of(transition::none) == literal{"none"});
// Behind the last name, too.
STATIC_CHECK(name_of(static_cast<transition>(18)) == literal{"none"});
STATIC_CHECK(name_of(command::quick_stop) == literal{"quick stop"});
STATIC_CHECK(word_of(command::fault_reset) == 0x0080 and word_of(command::none) == 0);

} // namespace
