// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// Writes a configuration into a drive that stands: what differs, one parameter at a time, each read back. It may be cut
// at any moment: each parameter then holds its old word or the new one, the report says which, and a second restore goes
// on where the first one ended.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include <rtuwire/altivar/device/drive_type.hpp>
#include <rtuwire/altivar/maintenance/restoring/restore_checks.hpp>
#include <rtuwire/altivar/maintenance/restoring/restore_plan.hpp>
#include <rtuwire/altivar/maintenance/restoring/row_write.hpp>
#include <rtuwire/core/version.hpp>
#include <rtuwire/table/device.hpp>

namespace rtuwire::inline RTUWIRE_BUILD::altivar {

/// Restores a configuration: `restore conversation{drive, atv320::parameters, wanted, report, options}`.
///
/// `report(parameter_group const&, parameter const&, restore_report const&)` is called for each parameter of the map; the
/// last call about a parameter counts. What is left out is told before anything is sent, and what is left out for want
/// of an option, once more with the word that the drive holds. ATR, FLR and what else lets the drive start by itself are
/// told with their words before anything is written.
///
/// Before each write the drive is read to stand (states 2, 3, 4, or in fault), its command to be 0000 and its output
/// frequency 0; before CFG, channels, run inputs and automatic restart also to be without fault, with its run inputs
/// open. A drive that does not, ends the restore; so does one that names another family. The order of the writes is
/// restore_agenda.hpp's. A motor that a terminal starts after such a write is sent 0000 once.
///
/// `reason()`: `succeeded` where the drive holds all that was wanted and allowed, or the dry run is told; `not_taken`
/// where it refused some or reads back otherwise, and `failed()` is how many; `other_family`; `refused_while_running`;
/// `overwritten` where its command is not 0000; `run_input_closed`; `unknown_register` where its inputs cannot be read;
/// `in_fault`; `started_by_terminals`; `silent` and `refused`, by `error`; `executed_unconfirmed` where that was after a
/// write of the link's own; `overruled` where this client ordered the unit to run, or a stop came later.
///
/// The map's groups outlive it; what it calls does not throw.
template <drive_type Device, typename Words, typename Report>
class restore : public restore_checks<restore<Device, Words, Report>> {
    using checks = restore_checks<restore>;
    friend checks;
    friend restore_procedures<restore>;

public:
    constexpr restore(station<Device> const& its_drive, parameter_map const& map,
                      wanted_settings<Words> const& its_wanted, Report report,
                      restore_options const& options = {}) noexcept
        : checks{its_drive.unit(), drive_check<Device>::layout, options.terminals,
                 identity_check{drive_family::of(Device::reference), its_wanted.family,
                                implements<Device>(function_code::encapsulated_interface)}},
          plan_{map, its_wanted, report, options}, walk_{Device::limits.read}
    {}

    /// How many parameters were written, and read back as wanted.
    [[nodiscard]] constexpr std::uint16_t written() const noexcept { return plan_.written(); }

    /// How many of the parameters that were wanted and allowed the drive does not hold; known at the end.
    [[nodiscard]] constexpr std::uint16_t failed() const noexcept { return plan_.failed(); }

private:
    using verdict = row_write::verdict;

    // What the checks call.

    constexpr void begin() noexcept
    {
        plan_.tell_left_out();
        if (this->identity().is_meant()) {
            this->check(false);
        } else {
            this->fail({outcome_kind::other_family});
        }
    }

    [[nodiscard]] constexpr parameter_map const& map() const noexcept { return plan_.map(); }
    [[nodiscard]] constexpr block_walk& walk() noexcept { return walk_; }

    /// The drive was checked: as a whole, or for a write.
    constexpr void on_checked() noexcept
    {
        if (has_row_) {
            this->write(row_.row->address, plan_.wanted(*row_.row));
        } else {
            walk_.begin();
            go_on();
        }
    }

    constexpr void on_words(register_view words) noexcept
    {
        for (std::size_t i = 0; i < words.size(); ++i) {
            words_[i] = words[i];
        }
        index_ = 0;
        is_in_block_ = true;
        go_through_block();
    }

    constexpr void on_refused_block(errc error) noexcept
    {
        if (walk_.refuse()) {
            plan_.tell_unreadable(row_at(map(), walk_.block().start), error);
            walk_.pass();
        }
        go_on();
    }

    constexpr void on_written() noexcept { act_on(write_.confirm()); }
    constexpr void on_write_failed(errc error, bool was_sent) noexcept
    {
        act_on(was_sent ? write_.fail(error) : write_.stop(error), error);
    }
    constexpr void on_read_back(std::uint16_t word) noexcept { act_on(write_.compare(word), write_.report().error); }
    constexpr void on_no_read_back(errc error) noexcept { act_on(write_.go_without(error), error); }

    constexpr void on_saved() noexcept
    {
        plan_.note_saved();
        go_on();
    }

    /// The last look found the drive at rest.
    constexpr void go_on() noexcept
    {
        while (not asks_in_this_step()) {
            if (not plan_.advance()) {
                return this->finish({plan_.failed() == 0 ? outcome_kind::succeeded : outcome_kind::not_taken});
            }
            walk_.begin();
            this->identity().expire();
        }
    }

    /// The restore ends: tells of everything that it did not come to.
    constexpr void on_end(reason& so) noexcept
    {
        if (has_row_) {
            static_cast<void>(write_.stop(so.error));
            close_row();
        }
        if (plan_.has_moved_link() and so.kind == outcome_kind::silent) {
            so.kind = outcome_kind::executed_unconfirmed;
        }
        if (so.kind != outcome_kind::succeeded and so.kind != outcome_kind::not_taken) {
            plan_.tell_not_reached(is_in_block_ ? walk_.block().start + index_ : walk_.position(), so.error);
        }
    }

    // The walk over the parameters.

    constexpr bool asks_in_this_step() noexcept
    {
        if (plan_.has_to_save()) {
            this->save();
            return true;
        }
        if (walk_.find(map(), [this](parameter const& row) { return plan_.covers(row); })) {
            this->read(walk_.block());
            return true;
        }
        return this->look_at_last();
    }

    constexpr void go_through_block() noexcept
    {
        for (; index_ < walk_.block().count; ++index_) {
            row_ = row_at(map(), static_cast<std::uint16_t>(walk_.block().start + index_));
            if (has_to_write(words_[index_])) {
                has_row_ = true;
                write_ = {plan_.wanted(*row_.row), words_[index_], role_of(*row_.row) == parameter_role::link};
                return this->check(is_delicate(role_of(*row_.row)));
            }
        }
        is_in_block_ = false;
        walk_.pass();
        go_on();
    }

    /// Whether the parameter is to be written now; where it is not, what is known of it is told.
    constexpr bool has_to_write(std::uint16_t held) noexcept
    {
        parameter const& row = *row_.row;
        agenda_step const& now = plan_.step();
        std::uint16_t const wanted = plan_.wanted(row);
        bool const is_right = held == wanted;
        if (is_right) {
            plan_.note_treated(row);
            plan_.tell(row_, {restore_outcome::holds, held});
        } else if (now.act == agenda_act::announce) {
            plan_.tell(row_, {plan_.judgement(row), held});
        } else if (now.act == agenda_act::verify) {
            plan_.judge_wrong(row_, held);
        } else if (now.moves(row.count_of(held), row.count_of(wanted))) {
            if (not plan_.options().dry_run) {
                return true;
            }
            plan_.note_treated(row);
            plan_.tell(row_, {restore_outcome::planned, held});
        }
        return false;
    }

    constexpr void act_on(verdict next, errc error = errc::none) noexcept
    {
        switch (next) {
        case verdict::read_back: return this->read_back(row_.row->address);
        case verdict::check_again: return this->check(is_delicate(role_of(*row_.row)));
        case verdict::next: close_row(); return go_through_block();
        case verdict::end: break;
        }
        close_row();
        this->fail(reason_for(error));
    }

    /// The parameter that was open is told.
    constexpr void close_row() noexcept
    {
        has_row_ = false;
        ++index_;
        plan_.note_treated(*row_.row);
        plan_.tell(row_, write_.report());
        if (write_.has_written()) {
            plan_.note_write();
        } else {
            plan_.note_failure(*row_.row);
        }
    }

    restore_plan<Words, Report> plan_;
    block_walk walk_;
    row_write write_{};
    placed_row row_{};
    std::array<std::uint16_t, Device::limits.read> words_{};
    std::uint16_t index_{0};
    bool has_row_{false};
    bool is_in_block_{false};
};

} // namespace rtuwire::altivar
