// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// In which order a restore writes: a list of steps, each over the parameters of one role. Knows no words and no drive.
// Internal: may change with any version.
#pragma once

#include <array>
#include <cstdint>

#include <rtuwire/altivar/maintenance/restore_options.hpp>
#include <rtuwire/core/literal.hpp>
#include <rtuwire/core/version.hpp>

namespace rtuwire {
inline namespace RTUWIRE_BUILD {
namespace altivar {

/// What a step does with its parameters.
enum class agenda_act : std::uint8_t {
    announce, ///< reads what is left out for want of an option, what others depend on, and what may start the drive
    write,    ///< writes what differs
    raise,    ///< writes what has to become larger
    lower,    ///< writes what has to become smaller
    verify,   ///< reads all of it once more
    save,
};

/// A step over the parameters of a role, or over one of them.
struct agenda_step {
    static constexpr std::uint8_t once = 0xFF;

    agenda_act act;
    parameter_role role{parameter_role::setting};
    literal code{};                  ///< of the one parameter; empty: all that have no step of their own
    std::uint8_t repeats_from{once}; ///< the first step of a section that is gone through until nothing is written

    [[nodiscard]] constexpr bool writes() const noexcept
    {
        return act == agenda_act::write or act == agenda_act::raise or act == agenda_act::lower;
    }

    /// Whether a value of this step's parameter is to be written now.
    [[nodiscard]] constexpr bool moves(std::int32_t held, std::int32_t wanted) const noexcept
    {
        return act == agenda_act::raise ? wanted > held : act == agenda_act::lower ? wanted < held : wanted != held;
    }
};

/// Raising TFR, HSP and LSP in this order, and then lowering them in the other, keeps LSP <= HSP <= TFR between any two
/// writes, from any values to any others. The channels stand as in `set_channel`. What is saved is verified after that:
/// a drive that lost its power before has saved what it held before.
inline constexpr agenda_step restore_agenda[]{
    {agenda_act::announce},
    {agenda_act::write, parameter_role::macro, {}, 1},
    {agenda_act::write, parameter_role::step_size},
    {agenda_act::raise, parameter_role::frequency_limit, "TFR"},
    {agenda_act::raise, parameter_role::frequency_limit, "HSP"},
    {agenda_act::raise, parameter_role::frequency_limit, "LSP"},
    {agenda_act::lower, parameter_role::frequency_limit, "LSP"},
    {agenda_act::lower, parameter_role::frequency_limit, "HSP"},
    {agenda_act::lower, parameter_role::frequency_limit, "TFR"},
    {agenda_act::write, parameter_role::motion},
    {agenda_act::write, parameter_role::setting, {}, 2},
    {agenda_act::write, parameter_role::supervision, {}, 11},
    {agenda_act::write, parameter_role::restart, {}, 12},
    {agenda_act::write, parameter_role::run_input},
    {agenda_act::write, parameter_role::channel},
    {agenda_act::write, parameter_role::channel, "CHCF"},
    {agenda_act::write, parameter_role::channel, "FLO", 13},
    {agenda_act::write, parameter_role::other_link},
    {agenda_act::write, parameter_role::link_timeout, {}, 17},
    {agenda_act::save},
    {agenda_act::verify},
    {agenda_act::write, parameter_role::link},
    {agenda_act::save},
};

inline constexpr std::uint8_t agenda_size = std::size(restore_agenda);

/// Whether a parameter has a step of its own.
[[nodiscard]] constexpr bool has_own_step(literal code) noexcept
{
    for (agenda_step const& each : restore_agenda) {
        if (each.code.size() != 0 and each.code == code) {
            return true;
        }
    }
    return false;
}

/// Whether a write of others depends on what the drive holds of this role.
[[nodiscard]] constexpr bool is_depended_on(parameter_role role) noexcept
{
    return role == parameter_role::step_size or role == parameter_role::frequency_limit;
}

/// Whether a step is over a parameter that was judged so.
[[nodiscard]] constexpr bool covers_row(agenda_step const& step, parameter const& row,
                                        restore_outcome judgement) noexcept
{
    parameter_role const role = role_of(row);
    bool const is_planned = judgement == restore_outcome::planned;
    switch (step.act) {
    case agenda_act::announce:
        return is_depended_on(role) or (is_planned ? role == parameter_role::restart : needs_option(judgement));
    case agenda_act::write:
    case agenda_act::raise:
    case agenda_act::lower:
        return is_planned and role == step.role and
               (step.code.size() != 0 ? row.code == step.code : not has_own_step(row.code));
    case agenda_act::verify: return is_planned and role != parameter_role::link;
    case agenda_act::save: break;
    }
    return false;
}

/// The last step that writes a parameter.
[[nodiscard]] constexpr std::uint8_t last_step_of(parameter const& row) noexcept
{
    std::uint8_t last = 0;
    for (std::uint8_t i = 0; i < agenda_size; ++i) {
        if (restore_agenda[i].writes() and covers_row(restore_agenda[i], row, restore_outcome::planned)) {
            last = i;
        }
    }
    return last;
}

/// What a drive has to be like for a write.
enum class write_care : std::uint8_t {
    rest,        ///< it stands without a command
    open_inputs, ///< and is without a fault, its run inputs open: the write may start it by the terminals or by itself
    all_inputs,  ///< these open in three-wire control, too: the write may make a stop contact a run input
};

/// A write of the supervision may take away what holds a motor back that a terminal commands.
[[nodiscard]] constexpr write_care care_for(parameter_role role) noexcept
{
    bool const may_be_started =
        role == parameter_role::supervision or role == parameter_role::restart or role == parameter_role::channel;
    bool const may_be_rewired = role == parameter_role::macro or role == parameter_role::run_input;
    return may_be_rewired ? write_care::all_inputs : may_be_started ? write_care::open_inputs : write_care::rest;
}

} // namespace altivar
} // namespace RTUWIRE_BUILD
} // namespace rtuwire
