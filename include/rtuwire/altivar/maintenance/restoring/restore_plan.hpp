// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// What a restore wants, how far it is, and what it tells of each parameter. Knows no request. Nothing is kept of a
// single parameter but whether TFR, HSP and LSP were written: what a drive holds is read anew in each round.
// Internal: may change with any version.
#pragma once

#include <cstdint>
#include <optional>

#include <rtuwire/altivar/maintenance/map_blocks.hpp>
#include <rtuwire/altivar/maintenance/restore_options.hpp>
#include <rtuwire/altivar/maintenance/restoring/restore_agenda.hpp>
#include <rtuwire/core/version.hpp>

namespace rtuwire::inline RTUWIRE_BUILD::altivar {

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

/// The agenda of one restore, and its parameters. A section of the agenda is gone through again while it writes
/// something, and so is the whole agenda while the verification finds something wrong. Where it finds others wrong at
/// the end than those that were told, it tells them.
template <typename Words, typename Report> class restore_plan {
public:
    constexpr restore_plan(parameter_map const& its_map, wanted_settings<Words> const& wanted, Report its_report,
                           restore_options const& its_options) noexcept
        : map_{its_map}, words_{wanted.words}, report_{its_report}, options_{its_options}
    {}

    [[nodiscard]] constexpr parameter_map const& map() const noexcept { return map_; }
    [[nodiscard]] constexpr restore_options const& options() const noexcept { return options_; }
    [[nodiscard]] constexpr agenda_step const& step() const noexcept { return restore_agenda[at_]; }

    /// What is known of a parameter before the drive is asked.
    [[nodiscard]] constexpr restore_outcome judgement(parameter const& row) noexcept
    {
        return judged(options_, row, words_(row));
    }

    /// The word that is wanted of a parameter that has one.
    [[nodiscard]] constexpr std::uint16_t wanted(parameter const& row) noexcept { return words_(row).value_or(0); }

    /// Whether this step is over a parameter.
    [[nodiscard]] constexpr bool covers(parameter const& row) noexcept
    {
        return covers_row(step(), row, judgement(row));
    }

    constexpr void tell(placed_row const& which, restore_report const& what) noexcept
    {
        report_(*which.group, *which.row, what);
    }

    /// Tells of all parameters that are left out, before anything is sent.
    constexpr void tell_left_out() noexcept
    {
        map_.for_each([&](parameter const& row, parameter_group const& group) {
            restore_outcome const found = judgement(row);
            if (found != restore_outcome::planned) {
                report_(group, row, restore_report{found});
            }
        });
    }

    /// Tells of all parameters that the restore, which ends, did not come to; of this step those from `position` on.
    constexpr void tell_not_reached(std::uint32_t position, errc error) noexcept
    {
        map_.for_each([&](parameter const& row, parameter_group const& group) {
            if (judgement(row) == restore_outcome::planned and not was_reached(row, position)) {
                report_(group, row, restore_report{restore_outcome::not_reached, std::nullopt, error});
            }
        });
    }

    /// A parameter was treated to its end; TFR, HSP and LSP have two steps each.
    constexpr void note_treated(parameter const& row) noexcept { treated_ |= limit_bit(row); }
    constexpr void note_write() noexcept
    {
        ++written_;
        ++written_here_;
        is_saved_ = false;
    }
    constexpr void note_failure(parameter const& row) noexcept { failures_.add(row.address); }

    /// The verification found another word than the wanted one; its last time tells.
    constexpr void judge_wrong(placed_row const& which, std::uint16_t held) noexcept
    {
        wrong_.add(which.row->address);
        if (tells_wrong_) {
            tell(which, {restore_outcome::differs, held});
        }
    }

    /// The drive does not tell what it holds.
    constexpr void tell_unreadable(placed_row const& which, errc error) noexcept
    {
        tell(which, {restore_outcome::unreadable, std::nullopt, error});
        if (step().act == agenda_act::verify) {
            wrong_.add(which.row->address);
        } else if (step().writes()) {
            note_failure(*which.row);
        }
    }
    constexpr void note_saved() noexcept { is_saved_ = true; }

    [[nodiscard]] constexpr bool has_to_save() const noexcept
    {
        return step().act == agenda_act::save and options_.save and not options_.dry_run and not is_saved_;
    }

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
        return static_cast<std::uint16_t>(wrong_.count() + failures_.count());
    }

    /// Goes on to the next step; whether there is one.
    constexpr bool advance() noexcept
    {
        agenda_step const& done = step();
        if (done.act == agenda_act::verify and not verify_is_over()) {
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
    constexpr bool verify_is_over() noexcept
    {
        if (options_.dry_run) {
            wrong_ = refused_;
            return true;
        }
        bool const may_mend = written_ != written_before_ and turn_ < most_turns and not tells_wrong_;
        bool const is_told = tells_wrong_ or wrong_ == refused_;
        if (wrong_.count() == 0 or (is_told and not may_mend)) {
            return true;
        }
        tells_wrong_ = not may_mend;
        if (may_mend) {
            ++turn_;
            at_ = 1;
            refused_ = {};
            written_before_ = written_;
        }
        wrong_ = {};
        return false;
    }

    [[nodiscard]] constexpr bool was_reached(parameter const& row, std::uint32_t position) const noexcept
    {
        std::uint8_t const last = last_step_of(row);
        bool const was_before = last < at_ or (round_ > 1 and last <= section_end()) or
                                (turn_ > 1 and role_of(row) != parameter_role::link);
        return was_before or (treated_ & limit_bit(row)) != 0 or (last == at_ and row.address < position);
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
        return row.code == literal{"TFR"} ? 1 : row.code == literal{"HSP"} ? 2 : row.code == literal{"LSP"} ? 4 : 0;
    }

    parameter_map map_;
    Words words_;
    Report report_;
    restore_options options_;
    row_set failures_{}; ///< of this round
    row_set refused_{};  ///< of the last round of each section
    row_set wrong_{};    ///< by the verification
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

} // namespace rtuwire::altivar
