// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// How far a restore has come in its agenda, what it does with each parameter there, and what it tells and counts of it.
// Knows no request. Nothing is kept of a single parameter but what others depend on: what a drive holds is read anew in
// each round.
// Internal: may change with any version.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>

#include <rtuwire/altivar/maintenance/block_walk.hpp>
#include <rtuwire/altivar/maintenance/restore_agenda.hpp>
#include <rtuwire/altivar/maintenance/restore_options.hpp>
#include <rtuwire/altivar/parameters/parameter.hpp>
#include <rtuwire/altivar/parameters/row_demands.hpp>
#include <rtuwire/core/version.hpp>

namespace rtuwire {
inline namespace RTUWIRE_BUILD {
namespace altivar {

/// Some parameters, as far as two such sets can be told apart: their number and a sum over their addresses.
class row_set {
public:
    constexpr void add(std::uint16_t address) noexcept
    {
        constexpr std::uint32_t spread = 2'654'435'761U; // 2^32 over the golden ratio
        std::uint32_t const mixed = (address + 1U) * spread;
        ++count_;
        sum_ += mixed ^ (mixed >> 15U);
    }
    constexpr void add(row_set const& others) noexcept
    {
        count_ = static_cast<std::uint16_t>(count_ + others.count_);
        sum_ += others.sum_;
    }
    [[nodiscard]] constexpr std::uint16_t count() const noexcept { return count_; }

    friend constexpr bool operator==(row_set const&, row_set const&) noexcept = default;

private:
    std::uint32_t sum_{0};
    std::uint16_t count_{0};
};

/// The step of the agenda. A section of it is gone through again while it writes something, and so is the whole agenda
/// while the verification finds something wrong. Where it finds others wrong than those that were told, it goes over all
/// of them once more and tells, before anything is mended.
class restore_progress {
public:
    [[nodiscard]] constexpr agenda_step const& step() const noexcept { return restore_agenda[at_]; }

    /// Whether a verification that finds something wrong tells it.
    [[nodiscard]] constexpr bool tells_wrong() const noexcept { return tells_wrong_; }

    /// A parameter was treated to its end; TFR, HSP and LSP have two steps each.
    constexpr void note_treated(parameter const& row) noexcept { treated_ |= limit_bit(row); }
    constexpr void note_write() noexcept
    {
        ++written_;
        ++written_here_;
        is_saved_ = false;
    }
    constexpr void note_failure(parameter const& row) noexcept { failures_.add(row.address); }
    constexpr void note_saved() noexcept { is_saved_ = true; }

    /// A word that is wanted and allowed, and never sent.
    constexpr void note_unfit() noexcept { ++unfit_; }

    /// The drive does not hold what it should. Of the two steps of a limit the second counts, unless `is_once` says that
    /// only this one would write it.
    constexpr void count_wrong(parameter const& row, bool is_once = false) noexcept
    {
        if (step().act == agenda_act::verify) {
            wrong_.add(row.address);
        } else if (step().writes() and (is_once or step().act != agenda_act::raise)) {
            note_failure(row);
        }
    }

    /// Whether all is held that was wanted, as far as it is known, and not saved yet.
    [[nodiscard]] constexpr bool has_to_save() const noexcept
    {
        bool const is_all_held = refused_.count() == 0 and unfit_ == 0;
        return step().act == agenda_act::save and is_all_held and not is_saved_;
    }

    /// Whether the drive has saved what it holds.
    [[nodiscard]] constexpr bool is_saved() const noexcept { return is_saved_; }

    /// Whether the drive's place on this line may have changed.
    [[nodiscard]] constexpr bool has_moved_link() const noexcept
    {
        return at_ > 0 and restore_agenda[agenda_size - 2].role == parameter_role::link and at_ >= agenda_size - 2 and
               written_here_ != 0;
    }

    [[nodiscard]] constexpr std::uint16_t written() const noexcept { return written_; }

    /// How many parameters the drive does not hold as wanted, as far as it is known.
    [[nodiscard]] constexpr std::uint16_t failed() const noexcept
    {
        return static_cast<std::uint16_t>(wrong_.count() + failures_.count() + unfit_);
    }

    /// Goes on to the next step; whether there is one.
    constexpr bool advance(bool is_dry_run) noexcept
    {
        agenda_step const& done = step();
        if (done.act == agenda_act::verify and not verify_is_over(is_dry_run)) {
            return true;
        }
        if (done.repeats_from != agenda_step::once) {
            if (written_here_ != 0 and round_ < most_rounds) {
                ++round_;
                at_ = done.repeats_from;
                written_here_ = 0;
                failures_ = {};
                return true;
            }
            end_section();
        }
        ++at_;
        return at_ < agenda_size;
    }

    /// Whether the restore has come to a parameter, where this step has come to `position`.
    [[nodiscard]] constexpr bool was_reached(parameter const& row, std::uint32_t position) const noexcept
    {
        std::uint8_t const last = last_step_of(row);
        bool const was_before = last < at_ or (round_ > 1 and last <= section_end()) or
                                (turn_ > 1 and role_of(row) != parameter_role::link);
        return was_before or (treated_ & limit_bit(row)) != 0 or (last == at_ and row.address < position);
    }

private:
    /// A section that writes in each round is one whose parameters undo each other.
    static constexpr std::uint8_t most_rounds = 6;
    static constexpr std::uint8_t most_turns = 3;

    constexpr void end_section() noexcept
    {
        refused_.add(failures_);
        failures_ = {};
        written_here_ = 0;
        round_ = 1;
    }

    /// After a verification: all is as it was told; or it begins again, or tells at last what is wrong.
    constexpr bool verify_is_over(bool is_dry_run) noexcept
    {
        if (is_dry_run) {
            wrong_ = refused_;
            return true;
        }
        bool const is_told = tells_wrong_ or wrong_ == refused_;
        bool const may_mend = written_ != written_before_ and turn_ < most_turns;
        if (wrong_.count() == 0 or (is_told and not may_mend)) {
            return true;
        }
        tells_wrong_ = not is_told;
        if (is_told) {
            ++turn_;
            at_ = 1;
            refused_ = {};
            written_before_ = written_;
        }
        wrong_ = {};
        return false;
    }

    [[nodiscard]] constexpr std::uint8_t section_end() const noexcept
    {
        std::uint8_t end = at_;
        while (restore_agenda[end].repeats_from == agenda_step::once) {
            ++end;
        }
        return end;
    }

    static constexpr std::uint8_t limit_bit(parameter const& row) noexcept
    {
        std::size_t const at = write_dependences::place_of(row.code);
        return static_cast<std::uint8_t>(at <= write_dependences::lsp ? 1U << at : 0U);
    }

    row_set failures_{}; ///< of this round
    row_set refused_{};  ///< of the last round of each section
    row_set wrong_{};    ///< by the verification
    std::uint16_t unfit_{0};
    std::uint16_t written_{0};
    std::uint16_t written_here_{0};   ///< in this round
    std::uint16_t written_before_{0}; ///< before this turn
    std::uint8_t at_{0};
    std::uint8_t round_{1};
    std::uint8_t turn_{1};
    std::uint8_t treated_{0};
    bool tells_wrong_{false};
    bool is_saved_{false};
};

/// The parameters of one restore, under the step that its progress has come to.
template <typename Device, typename Words, typename Report> class restore_plan {
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
    [[nodiscard]] constexpr restore_progress& progress() noexcept { return progress_; }
    [[nodiscard]] constexpr restore_progress const& progress() const noexcept { return progress_; }

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

    /// Does what this step does with a parameter whose word was just read, and tells it. Returns the word that is to be
    /// written now, where there is one: that is told once it is done.
    constexpr std::optional<std::uint16_t> treat(placed_row const& which, std::uint16_t held) noexcept
    {
        parameter const& row = *which.row;
        agenda_step const& now = progress_.step();
        std::uint16_t const word = wanted(row);
        bool const is_due = now.writes() and now.moves(row.count_of(held), row.count_of(word));
        dependences_.note_held(row.code, held);
        if (now.act == agenda_act::announce) {
            announce(which, held);
            return std::nullopt;
        }
        if (restore_outcome const found = dependences_.judge(row, held, word, is_due);
            found != restore_outcome::planned) {
            tell(which, {found, held});
            progress_.count_wrong(row, is_due and dependences_.limits_fit());
        } else if (held == word) {
            tell(which, {restore_outcome::holds, held});
        } else if (now.act == agenda_act::verify) {
            judge_wrong(which, held);
            return std::nullopt;
        } else if (not is_due or not options_.dry_run) {
            return is_due ? word_to_send(which, held) : std::nullopt;
        } else {
            dependences_.note_held(row.code, word);
            tell(which, {restore_outcome::planned, held});
        }
        progress_.note_treated(row);
        return std::nullopt;
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
            parameter_role const role = role_of(row);
            bool const is_planned = found == restore_outcome::planned;
            if (is_planned or (has_fitting_word(found) and role == parameter_role::step_size)) {
                dependences_.note_wanted(row.code, wanted(row));
            }
            wants_any_ = wants_any_ or is_planned;
            if (is_planned) {
                return;
            }
            if (found == restore_outcome::out_of_limits and allowed_by(options_, row) == restore_outcome::planned) {
                progress_.note_unfit();
            }
            if (is_restorable(role)) {
                dependences_.note_left_alone(row.steps_set_by);
            }
            report_(group, row, restore_report{found});
        });
    }

    /// Tells of all parameters that the restore, which ends, did not come to; of this step those from `position` on, but for
    /// those before `block_end`, which `tell_last_word` tells of.
    constexpr void tell_not_reached(std::uint32_t position, std::uint32_t block_end, errc error) noexcept
    {
        map_.for_each([&](parameter const& row, parameter_group const& group) {
            bool const is_told = row.address >= position and row.address < block_end;
            if (not is_told and is_left(row, position)) {
                report_(group, row, restore_report{restore_outcome::not_reached, std::nullopt, error});
            }
        });
    }

    /// The restore ends before it has come to this parameter, which was read just now: what was told of it before, where
    /// that was, may be old.
    constexpr void tell_last_word(placed_row const& which, std::uint16_t held, std::uint32_t position,
                                  errc error) noexcept
    {
        bool const is_old = progress_.step().writes() and held != wanted(*which.row);
        if (is_old or is_left(*which.row, position)) {
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
        return judgement(row, words_(row));
    }
    [[nodiscard]] constexpr restore_outcome judgement(parameter const& row,
                                                      std::optional<std::uint16_t> word) const noexcept
    {
        return agrees_with_drive<Device>(row) ? judged(options_, row, word) : restore_outcome::never_written;
    }

    /// Whether the restore, which has come to `position` of this step, ends without a look at this parameter.
    [[nodiscard]] constexpr bool is_left(parameter const& row, std::uint32_t position) noexcept
    {
        return judgement(row) == restore_outcome::planned and not progress_.was_reached(row, position);
    }

    /// The word that is wanted of a parameter that has one.
    [[nodiscard]] constexpr std::uint16_t wanted(parameter const& row) noexcept { return words_(row).value_or(0); }

    constexpr void tell(placed_row const& which, restore_report const& what) noexcept
    {
        report_(*which.group, *which.row, what);
    }

    /// Before any write: what is left out, or depended on, with what the drive holds.
    constexpr void announce(placed_row const& which, std::uint16_t held) noexcept
    {
        restore_outcome const found = judgement(*which.row);
        bool const is_right = has_fitting_word(found) and held == wanted(*which.row);
        tell(which, {is_right ? restore_outcome::holds : found, held});
    }

    /// The verification found another word than the wanted one; a second one tells.
    constexpr void judge_wrong(placed_row const& which, std::uint16_t held) noexcept
    {
        progress_.count_wrong(*which.row);
        if (progress_.tells_wrong()) {
            tell(which, {restore_outcome::differs, held});
        }
    }

    /// The word that is wanted, judged once more as far as that does not depend on others; where it is none any more, tells
    /// so.
    constexpr std::optional<std::uint16_t> word_to_send(placed_row const& which, std::uint16_t held) noexcept
    {
        std::optional<std::uint16_t> const word = words_(*which.row);
        restore_outcome const found = judgement(*which.row, word);
        if (found == restore_outcome::planned) {
            return word;
        }
        tell(which, {found, held});
        progress_.note_failure(*which.row);
        return std::nullopt;
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
