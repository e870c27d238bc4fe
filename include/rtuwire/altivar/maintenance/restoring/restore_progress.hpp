// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// How far a restore has come in its agenda, and what it counts on its way. Knows no word of the configuration.
// Internal: may change with any version.
#pragma once

#include <cstddef>
#include <cstdint>

#include <rtuwire/altivar/maintenance/restoring/restore_agenda.hpp>
#include <rtuwire/altivar/maintenance/restoring/write_dependences.hpp>
#include <rtuwire/altivar/parameters/parameter.hpp>
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

} // namespace altivar
} // namespace RTUWIRE_BUILD
} // namespace rtuwire
