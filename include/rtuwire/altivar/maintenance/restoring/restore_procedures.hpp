// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// How a restore runs its inner procedures, and how it ends: not without a look at a drive whose motor a write of it may
// have started.
// Internal: may change with any version.
#pragma once

#include <cstdint>

#include <rtuwire/altivar/maintenance/restoring/inner_procedure.hpp>
#include <rtuwire/altivar/maintenance/restoring/restore_requests.hpp>
#include <rtuwire/core/version.hpp>

namespace rtuwire {
inline namespace RTUWIRE_BUILD {
namespace altivar {

/// Why a restore ends at a request that failed.
[[nodiscard]] constexpr reason reason_for(errc error) noexcept
{
    return {error == errc::overruled   ? outcome_kind::overruled
            : error == errc::cancelled ? outcome_kind::aborted
            : is_exception(error)      ? outcome_kind::refused
                                       : outcome_kind::silent,
            error};
}

/// The requests of a restore, and its inner procedures. `Restore` derives from it; at the good end of a procedure it gets
/// `on_checked`, `go_on` after a look, or `on_saved`; any other end fails. Before it ends, it gets `on_end`.
template <typename Restore> class restore_procedures : public restore_requests {
public:
    /// How it ended; `pending` until it is settled. To be read in the pass in which it settles: from the next visit on it
    /// is `used_already`.
    [[nodiscard]] constexpr altivar::reason reason() const noexcept
    {
        return this->is_used_already() ? altivar::reason{outcome_kind::used_already} : reason_;
    }

protected:
    constexpr restore_procedures(unit_id its_unit, drive_layout const& layout,
                                 terminal_options const& terminals) noexcept
        : restore_requests{its_unit, layout}, inner_{layout, terminals}
    {}

    constexpr Restore& self() noexcept { return static_cast<Restore&>(*this); }

    /// Checks whether the drive stands, and what else a write needs.
    constexpr void guard(write_care care) noexcept { perform(inner_.begin_guard(care)); }

    constexpr void save() noexcept { perform(inner_.begin_save()); }

    /// A delicate write is about to be sent.
    constexpr void note_delicate() noexcept { may_have_started_ = true; }

    /// Looks at a drive whose motor a delicate write may have started; whether there was one.
    constexpr bool look_at_last() noexcept
    {
        if (may_have_started_) {
            is_look_due_ = true;
            perform(to_pause(status_period));
        }
        return may_have_started_;
    }

    /// Notes that its user gives it up. Returns whether a procedure runs that has to come to its end first.
    constexpr bool give_up() noexcept
    {
        is_given_up_ = true;
        return is_look_due_ or inner_.has_to_end();
    }

    /// The next step of the procedure that runs.
    constexpr void run(event what) noexcept
    {
        if (is_look_due_) {
            is_look_due_ = false;
            return perform(inner_.begin_look({outcome_kind::succeeded}));
        }
        action const next = inner_.step(what);
        this->note_power(inner_.take_power());
        if (inner_.take_fault()) {
            this->note_fault();
        }
        if (what_of(next) == action_kind::end) {
            on_end_of_procedure();
        } else {
            perform(next);
        }
    }

    /// Ends, after a last look where one is due. Returns whether that runs now.
    constexpr bool fail(altivar::reason const& so) noexcept
    {
        bool const is_due = may_have_started_;
        may_have_started_ = false; // there is no second one
        is_look_due_ = false;
        if (is_due) {
            perform(inner_.begin_look(so));
        } else {
            finish(so);
        }
        return is_due;
    }

    constexpr void finish(altivar::reason so) noexcept
    {
        self().on_end(so);
        reason_ = so;
        end();
    }

private:
    constexpr void on_end_of_procedure() noexcept
    {
        bool const was_look = inner_.running() == inner_procedure::kind::look;
        may_have_started_ = may_have_started_ and not was_look;
        if (altivar::reason so = inner_.reason(); so.kind != outcome_kind::succeeded) {
            so.kind = so.kind == outcome_kind::silent ? reason_for(so.error).kind : so.kind;
            return static_cast<void>(fail(so));
        }
        if (is_given_up_) {
            return finish(reason_for(errc::cancelled));
        }
        switch (inner_.running()) {
        case inner_procedure::kind::guard: return self().on_checked();
        case inner_procedure::kind::look: return self().go_on();
        case inner_procedure::kind::save: break;
        }
        self().on_saved();
    }

    inner_procedure inner_;
    altivar::reason reason_{};
    bool may_have_started_{false}; ///< a delicate write was sent, and no look followed yet
    bool is_look_due_{false};      ///< after the pause
    bool is_given_up_{false};
};

} // namespace altivar
} // namespace RTUWIRE_BUILD
} // namespace rtuwire
