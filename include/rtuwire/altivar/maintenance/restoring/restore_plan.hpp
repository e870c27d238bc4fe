// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// What a restore wants, and what it does with each parameter and tells of it. Knows no request. Nothing is kept of a
// single parameter but what others depend on: what a drive holds is read anew in each round.
// Internal: may change with any version.
#pragma once

#include <cstdint>
#include <optional>

#include <rtuwire/altivar/maintenance/map_blocks.hpp>
#include <rtuwire/altivar/maintenance/restore_options.hpp>
#include <rtuwire/altivar/maintenance/restoring/restore_agenda.hpp>
#include <rtuwire/altivar/maintenance/restoring/restore_progress.hpp>
#include <rtuwire/altivar/maintenance/restoring/write_dependences.hpp>
#include <rtuwire/core/version.hpp>

namespace rtuwire {
inline namespace RTUWIRE_BUILD {
namespace altivar {

/// The parameters of one restore, under the step that its progress has come to.
template <typename Words, typename Report> class restore_plan {
public:
    constexpr restore_plan(parameter_map const& its_map, wanted_settings<Words> const& wanted, Report its_report,
                           restore_options const& its_options) noexcept
        : map_{its_map}, words_{wanted.words}, report_{its_report}, options_{its_options}
    {}

    /// Begins again: nothing is known of the drive, and nothing was done.
    constexpr void begin() noexcept
    {
        dependences_ = {};
        progress_ = {};
        wants_any_ = false;
    }

    [[nodiscard]] constexpr parameter_map const& map() const noexcept { return map_; }
    [[nodiscard]] constexpr terminal_options const& terminals() const noexcept { return options_.terminals; }
    [[nodiscard]] constexpr restore_progress& progress() noexcept { return progress_; }
    [[nodiscard]] constexpr restore_progress const& progress() const noexcept { return progress_; }

    /// The word that is wanted of a parameter that has one.
    [[nodiscard]] constexpr std::uint16_t wanted(parameter const& row) noexcept { return words_(row).value_or(0); }

    /// The word that is to be sent, judged once more as far as that does not depend on others; where it is none any more,
    /// tells so.
    constexpr std::optional<std::uint16_t> word_to_send(placed_row const& which, std::uint16_t held) noexcept
    {
        std::optional<std::uint16_t> const word = words_(*which.row);
        restore_outcome const found = judged(options_, *which.row, word);
        if (found == restore_outcome::planned) {
            return word;
        }
        tell(which, {found, held});
        progress_.note_failure(*which.row);
        return std::nullopt;
    }

    /// Whether this step is over a parameter. A dry run has nothing to verify.
    [[nodiscard]] constexpr bool covers(parameter const& row) noexcept
    {
        bool const is_idle = options_.dry_run and progress_.step().act == agenda_act::verify;
        return not is_idle and covers_row(progress_.step(), row, judgement(row));
    }

    [[nodiscard]] constexpr bool has_to_save() const noexcept
    {
        return options_.save and not options_.dry_run and wants_any_ and progress_.has_to_save();
    }

    /// Goes on to the next step; whether there is one.
    constexpr bool advance() noexcept { return progress_.advance(options_.dry_run); }

    /// Does what this step does with a parameter whose word was just read, and tells it. Returns whether it is to be written
    /// now, which is told once that is done.
    constexpr bool treat(placed_row const& which, std::uint16_t held) noexcept
    {
        parameter const& row = *which.row;
        agenda_step const& now = progress_.step();
        dependences_.note_held(row.code, held);
        if (now.act == agenda_act::announce) {
            announce(which, held);
        } else if (not allows(which, held)) {
            progress_.note_treated(row);
        } else if (held == wanted(row)) {
            progress_.note_treated(row);
            tell(which, {restore_outcome::holds, held});
        } else if (now.act == agenda_act::verify) {
            judge_wrong(which, held);
        } else if (now.moves(row.count_of(held), row.count_of(wanted(row)))) {
            return is_for_real(which, held);
        }
        return false;
    }

    /// A write has come to its end.
    constexpr void close(placed_row const& which, restore_report const& what, bool has_written) noexcept
    {
        progress_.note_treated(*which.row);
        dependences_.note_held(which.row->code, what.held);
        tell(which, what);
        if (has_written) {
            progress_.note_write();
        } else {
            progress_.note_failure(*which.row);
        }
    }

    /// Tells of all parameters that are left out, before anything is sent.
    constexpr void tell_left_out() noexcept
    {
        map_.for_each([&](parameter const& row, parameter_group const& group) {
            restore_outcome const found = judgement(row);
            bool const is_planned = found == restore_outcome::planned;
            if (is_planned or (has_fitting_word(found) and role_of(row) == parameter_role::step_size)) {
                dependences_.note_wanted(row.code, wanted(row));
            }
            wants_any_ = wants_any_ or is_planned;
            if (not is_planned) {
                note_left_out(row, found);
                report_(group, row, restore_report{found});
            }
        });
    }

    /// Tells of all parameters that the restore, which ends, did not come to; of this step those from `position` on.
    constexpr void tell_not_reached(std::uint32_t position, errc error) noexcept
    {
        map_.for_each([&](parameter const& row, parameter_group const& group) {
            if (judgement(row) == restore_outcome::planned and not progress_.was_reached(row, position)) {
                report_(group, row, restore_report{restore_outcome::not_reached, std::nullopt, error});
            }
        });
    }

    /// The restore ends before it has come to this parameter again, which was read just now: what was told of it before
    /// may be old.
    constexpr void tell_last_word(placed_row const& which, std::uint16_t held, errc error) noexcept
    {
        if (progress_.step().writes() and held != wanted(*which.row)) {
            tell(which, {restore_outcome::not_reached, held, error});
        }
    }

    /// The drive does not tell what it holds.
    constexpr void tell_unreadable(placed_row const& which, errc error) noexcept
    {
        dependences_.note_held(which.row->code, std::nullopt);
        tell(which, {restore_outcome::unreadable, std::nullopt, error});
        progress_.count_wrong(*which.row);
    }

private:
    /// What is known of a parameter before the drive is asked.
    [[nodiscard]] constexpr restore_outcome judgement(parameter const& row) noexcept
    {
        return judged(options_, row, words_(row));
    }

    constexpr void tell(placed_row const& which, restore_report const& what) noexcept
    {
        report_(*which.group, *which.row, what);
    }

    constexpr void note_left_out(parameter const& row, restore_outcome found) noexcept
    {
        if (found == restore_outcome::out_of_limits and allowed_by(options_, row) == restore_outcome::planned) {
            progress_.note_unfit();
        }
        if (is_restorable(role_of(row))) {
            dependences_.note_left_alone(row.steps_set_by);
        }
    }

    /// Before any write: what is left out, or depended on, with what the drive holds.
    constexpr void announce(placed_row const& which, std::uint16_t held) noexcept
    {
        restore_outcome const found = judgement(*which.row);
        bool const is_right = has_fitting_word(found) and held == wanted(*which.row);
        tell(which, {is_right ? restore_outcome::holds : found, held});
    }

    /// Whether others allow this parameter to be written, or to be right; where they do not, tells why, and counts it.
    constexpr bool allows(placed_row const& which, std::uint16_t held) noexcept
    {
        parameter const& row = *which.row;
        agenda_step const& now = progress_.step();
        bool const is_now = now.writes() and now.moves(row.count_of(held), row.count_of(wanted(row)));
        restore_outcome const found = dependences_.judge(row, held, wanted(row), is_now);
        if (found != restore_outcome::planned) {
            tell(which, {found, held});
            progress_.count_wrong(row, is_now and dependences_.limits_fit());
        }
        return found == restore_outcome::planned;
    }

    /// The verification found another word than the wanted one; a second one tells.
    constexpr void judge_wrong(placed_row const& which, std::uint16_t held) noexcept
    {
        progress_.count_wrong(*which.row);
        if (progress_.tells_wrong()) {
            tell(which, {restore_outcome::differs, held});
        }
    }

    /// Whether a parameter that differs is written; in a dry run it is told.
    constexpr bool is_for_real(placed_row const& which, std::uint16_t held) noexcept
    {
        if (options_.dry_run) {
            progress_.note_treated(*which.row);
            dependences_.note_held(which.row->code, wanted(*which.row));
            tell(which, {restore_outcome::planned, held});
        }
        return not options_.dry_run;
    }

    parameter_map map_;
    Words words_;
    Report report_;
    restore_options options_;
    write_dependences dependences_{};
    restore_progress progress_{};
    bool wants_any_{false};
};

} // namespace altivar
} // namespace RTUWIRE_BUILD
} // namespace rtuwire
