// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// Writes a configuration into a drive that stands: what differs, one parameter at a time, each read back. It may be cut
// at any moment: each parameter then holds its old word or the new one, the report says which, and a second restore goes
// on where the first one ended.
//
// Here is what is written, in which order, and when it ends. What that stands on is in restoring/: restore_calls.hpp has what
// a client calls, restore_checks.hpp what each response means, restore_procedures.hpp the inner procedures (the look whether
// the drive stands, the save), restore_requests.hpp one request at a time. A response goes from the calls to the checks, from
// these to the inner procedure under way, and its end comes back here.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>

#include <rtuwire/altivar/device/drive_type.hpp>
#include <rtuwire/altivar/maintenance/guarded_write.hpp>
#include <rtuwire/altivar/maintenance/restore_plan.hpp>
#include <rtuwire/altivar/maintenance/restoring/restore_calls.hpp>
#include <rtuwire/altivar/maintenance/restoring/restore_checks.hpp>
#include <rtuwire/core/version.hpp>
#include <rtuwire/table/device.hpp>

namespace rtuwire {
inline namespace RTUWIRE_BUILD {
namespace altivar {

/// Restores a configuration: `restore conversation{drive, atv320::parameters, wanted, report, options}`.
///
/// `report(parameter_group const&, parameter const&, restore_report const&)` is called for each parameter of the map; the
/// last call about a parameter counts. What is left out is told before anything is sent, and what is left out for want
/// of an option, once more with the word that the drive holds. ATR, FLR and what else lets the drive start by itself are
/// told with their words before anything is written.
///
/// Before each write, and before it saves, the drive is read to stand (states 2, 3, 4, or in fault), its command to be
/// 0000 and its output frequency 0; before CFG, channels, run inputs, supervision and automatic restart also to be
/// without fault, with its run inputs open. A drive that does not, ends the restore; so does one that names another
/// family. The order of the writes is restore_agenda.hpp's. A motor that a terminal starts before the look after such
/// writes is sent 0000 once; one that it starts later ends the restore as `refused_while_running`.
///
/// What depends on others is not sent without them: a ramp, where the drive does not hold the INR of the configuration,
/// and INR, where a ramp is left out (`other_steps`); TFR, HSP and LSP where they do not fit each other
/// (`out_of_limits`).
///
/// `reason()`: `succeeded` where the drive holds all that was wanted and allowed, or the dry run is told; `not_taken`
/// where it refused some or reads back otherwise, and `failed()` is how many; `other_family`; `refused_while_running`;
/// `overwritten` where its command is not 0000; `run_input_closed`; `unknown_register` where its inputs cannot be read;
/// `in_fault`; `started_by_terminals`; `silent` and `refused`, by `error`; `executed_unconfirmed` where that was after a
/// write of the link's own; `overruled` where this client ordered the unit to run, or a stop came later.
///
/// The map's groups outlive it; what it calls does not throw.
template <drive_type Device, typename Words, typename Report>
class restore : public restore_calls<restore<Device, Words, Report>> {
    using calls = restore_calls<restore>;
    friend calls;
    friend restore_checks<restore>;
    friend restore_procedures<restore>;

public:
    constexpr restore(station<Device> const& its_drive, parameter_map const& map,
                      wanted_settings<Words> const& its_wanted, Report report,
                      restore_options const& options = {}) noexcept
        : calls{its_drive.unit(), drive_check<Device>::layout, options.terminals,
                identity_check{drive_family::of(Device::reference), its_wanted.family, map.family(),
                               has_identification}},
          plan_{map, its_wanted, report, options}, walk_{Device::limits.read}
    {}

    /// Begins anew, as it was made, and tells each parameter once more. One under way is given up first, as if it had been
    /// destroyed. Not to be called by the report.
    constexpr void again() noexcept
    {
        this->make_anew(plan_.terminals(), this->identity().anew(has_identification));
        plan_.begin();
        walk_ = block_walk{Device::limits.read};
        has_row_ = false;
        is_in_block_ = false;
    }

    /// How many writes the drive took: each was read back as wanted, or confirmed where it is the link's own. More than
    /// one a parameter where a later write had undone it.
    [[nodiscard]] constexpr std::uint16_t written() const noexcept { return plan_.progress().written(); }

    /// How many of the parameters that were wanted and allowed the drive does not hold, those among them whose words were
    /// never sent (`out_of_limits`, `other_steps`); known at the end.
    [[nodiscard]] constexpr std::uint16_t failed() const noexcept { return plan_.progress().failed(); }

    /// Whether the drive was told to save what it now holds, and did. It is not told where something is known not to be
    /// held; what only the verification behind it finds is in `failed()`.
    [[nodiscard]] constexpr bool saved() const noexcept { return plan_.progress().is_saved(); }

private:
    using verdict = row_write::verdict;

    static constexpr bool has_identification = detail::implements<Device>(function_code::encapsulated_interface);

    // What the checks call.

    constexpr void begin() noexcept
    {
        plan_.tell_left_out();
        if (this->identity().is_meant()) {
            this->check(write_care::rest);
        } else {
            this->fail({outcome_kind::other_family});
        }
    }

    constexpr void tell_left_out() noexcept { plan_.tell_left_out(); }

    [[nodiscard]] constexpr parameter_map const& map() const noexcept { return plan_.map(); }
    [[nodiscard]] constexpr block_walk& walk() noexcept { return walk_; }

    /// The drive was checked: as a whole, for a write, or before it saves.
    constexpr void on_checked() noexcept
    {
        if (has_row_) {
            this->write(row_.row->address, write_.wanted());
        } else if (plan_.has_to_save()) {
            this->save();
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
        act_on(was_sent ? write_.fail(error) : write_.stop(error));
    }
    constexpr void on_read_back(std::uint16_t word) noexcept { act_on(write_.compare(word)); }
    constexpr void on_no_read_back(errc error) noexcept { act_on(write_.go_without(error)); }

    constexpr void on_saved() noexcept
    {
        plan_.progress().note_saved();
        go_on();
    }

    /// The last look found the drive at rest.
    constexpr void go_on() noexcept
    {
        while (not asks_in_this_step()) {
            if (not plan_.advance()) {
                return this->finish(
                    {plan_.progress().failed() == 0 ? outcome_kind::succeeded : outcome_kind::not_taken});
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
        if (plan_.progress().has_moved_link() and so.kind == outcome_kind::silent) {
            so.kind = outcome_kind::executed_unconfirmed;
        }
        if (so.kind != outcome_kind::succeeded and so.kind != outcome_kind::not_taken) {
            tell_rest_of_block(so.error);
            plan_.tell_not_reached(is_in_block_ ? walk_.block().start + index_ : walk_.position(), so.error);
        }
    }

    constexpr void tell_rest_of_block(errc error) noexcept
    {
        for (std::uint16_t i = index_; is_in_block_ and i < walk_.block().count; ++i) {
            plan_.tell_last_word(row_at(map(), static_cast<std::uint16_t>(walk_.block().start + i)), words_[i], error);
        }
    }

    // The walk over the parameters.

    constexpr bool asks_in_this_step() noexcept
    {
        if (plan_.has_to_save()) {
            this->check(write_care::rest);
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
            if (plan_.treat(row_, words_[index_]) and begins_write(words_[index_])) {
                return;
            }
        }
        is_in_block_ = false;
        walk_.pass();
        go_on();
    }

    constexpr bool begins_write(std::uint16_t held) noexcept
    {
        parameter_role const role = role_of(*row_.row);
        std::optional<std::uint16_t> const word = plan_.word_to_send(row_, held);
        has_row_ = word.has_value();
        if (word) {
            write_ = {*word, held, role == parameter_role::link};
            this->check(care_for(role));
        }
        return has_row_;
    }

    constexpr void act_on(verdict next) noexcept
    {
        switch (next) {
        case verdict::read_back: return this->read_back(row_.row->address);
        case verdict::check_again: return this->check(care_for(role_of(*row_.row)));
        case verdict::next: close_row(); return go_through_block();
        case verdict::end: break;
        }
        close_row();
        this->fail(reason_for(write_.report().error));
    }

    /// The parameter that was open is told.
    constexpr void close_row() noexcept
    {
        has_row_ = false;
        ++index_;
        plan_.close(row_, write_.report(), write_.has_written());
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

} // namespace altivar
} // namespace RTUWIRE_BUILD
} // namespace rtuwire
