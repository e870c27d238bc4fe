// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// In which order a restore writes, and what its writes depend on beside their own register: the count of a ramp means
// nothing without the size of its steps, and LSP <= HSP <= TFR holds between any two writes. Knows no request.
// Internal: may change with any version.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>

#include <rtuwire/altivar/maintenance/restore_options.hpp>
#include <rtuwire/altivar/parameters/parameter.hpp>
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

/// Whether a step is over a parameter that was judged so.
[[nodiscard]] constexpr bool covers_row(agenda_step const& step, parameter const& row,
                                        restore_outcome judgement) noexcept
{
    parameter_role const role = role_of(row);
    bool const is_planned = judgement == restore_outcome::planned;
    bool const is_depended_on = role == parameter_role::step_size or role == parameter_role::frequency_limit;
    switch (step.act) {
    case agenda_act::announce:
        return is_depended_on or (is_planned ? role == parameter_role::restart : needs_option(judgement));
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

/// The words of TFR, HSP, LSP, INR and INTP: what the drive holds of them, and what it shall hold.
class write_dependences {
public:
    /// Which of them a mnemonic is; `none` of another.
    [[nodiscard]] static constexpr std::size_t place_of(literal code) noexcept
    {
        std::size_t at = 0;
        while (at < none and codes[at] != code) {
            ++at;
        }
        return at;
    }
    static constexpr std::size_t tfr = 0, hsp = 1, lsp = 2, none = 5;

    /// A word that the restore wants; of a limit only where it may write it.
    constexpr void note_wanted(literal code, std::uint16_t word) noexcept
    {
        if (std::size_t const at = place_of(code); at < none) {
            wanted_[at] = word;
        }
    }

    /// The restore does not write a parameter that counts in the steps of this one: those must stay as they are.
    constexpr void note_left_alone(literal steps_set_by) noexcept
    {
        if (std::size_t const at = place_of(steps_set_by); at < none) {
            is_bound_[at] = true;
        }
    }

    /// What was read last, or written; empty where that is not known any more.
    constexpr void note_held(literal code, std::optional<std::uint16_t> word) noexcept
    {
        if (std::size_t const at = place_of(code); at < none) {
            held_[at] = word;
        }
    }

    /// Why a parameter must not be written; `planned` where nothing is in the way. `is_now` says that it is to be written
    /// now, beside what the drive holds of the others at this moment.
    [[nodiscard]] constexpr restore_outcome judge(parameter const& row, std::uint16_t held, std::uint16_t wanted,
                                                  bool is_now) const noexcept
    {
        std::size_t const at = place_of(row.code);
        bool const is_bound = at < none and is_bound_[at] and held != wanted;
        if (is_bound or (row.steps_set_by.size() != 0 and not has_steps(row.steps_set_by))) {
            return restore_outcome::other_steps;
        }
        bool const is_limit = at <= lsp and held != wanted;
        return is_limit and not(limits_fit() and (not is_now or are_in_order(with(at, wanted))))
                   ? restore_outcome::out_of_limits
                   : restore_outcome::planned;
    }

    /// Whether LSP <= HSP <= TFR holds once all is written.
    [[nodiscard]] constexpr bool limits_fit() const noexcept { return are_in_order(goal()); }

private:
    using words = std::array<std::optional<std::uint16_t>, none>;

    static constexpr std::array<literal, none> codes{"TFR", "HSP", "LSP", "INR", "INTP"};

    /// Whether the drive counts as the configuration does.
    [[nodiscard]] constexpr bool has_steps(literal code) const noexcept
    {
        std::size_t const at = place_of(code);
        return at < none and held_[at].has_value() and held_[at] == wanted_[at];
    }

    [[nodiscard]] constexpr words with(std::size_t at, std::uint16_t word) const noexcept
    {
        words all = held_;
        all[at] = word;
        return all;
    }

    /// What the drive holds in the end.
    [[nodiscard]] constexpr words goal() const noexcept
    {
        words all = held_;
        for (std::size_t at = tfr; at <= lsp; ++at) {
            all[at] = wanted_[at].has_value() ? wanted_[at] : held_[at];
        }
        return all;
    }

    static constexpr bool are_in_order(words const& all) noexcept
    {
        auto const fits = [&](std::size_t lower, std::size_t upper) {
            return not all[lower].has_value() or not all[upper].has_value() or *all[lower] <= *all[upper];
        };
        return fits(lsp, hsp) and fits(hsp, tfr) and fits(lsp, tfr);
    }

    words held_{};
    words wanted_{};
    std::array<bool, none> is_bound_{};
};

} // namespace altivar
} // namespace RTUWIRE_BUILD
} // namespace rtuwire
