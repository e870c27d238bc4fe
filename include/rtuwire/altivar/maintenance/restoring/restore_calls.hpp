// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// What a client and a program call of a restore. Each call is one step; what a report asks for in the middle of a step is
// done at its end.
// Internal: may change with any version.
#pragma once

#include <rtuwire/altivar/maintenance/guarded_write.hpp>
#include <rtuwire/altivar/maintenance/restoring/restore_checks.hpp>
#include <rtuwire/core/version.hpp>

namespace rtuwire {
inline namespace RTUWIRE_BUILD {
namespace altivar {

/// The conversation of a restore, which derives from it.
template <typename Restore> class restore_calls : public restore_checks<Restore> {
    using base = restore_checks<Restore>;
    using base::self;

public:
    using base::settled;

    /// Processes the time: begins, and ends pauses.
    constexpr void advance(instant now) noexcept
    {
        this->tick(now);
        is_inside_ = true;
        if (not this->has_begun()) {
            this->note_order();
            self().begin();
        } else if (not settled() and not this->is_asking()) {
            this->go_on_in_time();
        }
        leave();
    }

    constexpr void accept(result<response> const& outcome) noexcept
    {
        is_inside_ = true;
        this->take(outcome);
        leave();
    }

    constexpr void note_loss() noexcept
    {
        is_inside_ = true;
        this->note_loss_now();
        leave();
    }

    /// Ends it as `aborted`: tells what became of the write under way, and what was not reached. One that has not begun
    /// sends nothing. A last look, what takes the motor's power away, and the end of an order to save are not given up:
    /// run it on until it is settled, however often this is called. A report may call it, too.
    constexpr void cancel() noexcept
    {
        is_unwanted_ = true;
        if (not is_inside_) {
            is_inside_ = true;
            leave();
        }
    }

protected:
    constexpr restore_calls(unit_id its_unit, drive_layout const& layout, terminal_options const& terminals,
                            identity_check const& identity) noexcept
        : base{its_unit, layout, terminals, identity}
    {}

    /// Becomes as it was made; its last request is given up.
    constexpr void make_anew(terminal_options const& terminals, identity_check const& identity) noexcept
    {
        asker const former{*this};
        *this = restore_calls{this->unit(), this->layout(), terminals, identity};
        this->replace(former);
    }

private:
    constexpr void leave() noexcept
    {
        if (is_unwanted_ and not settled()) {
            is_unwanted_ = false;
            give_up_now();
        }
        is_inside_ = false;
    }

    constexpr void give_up_now() noexcept
    {
        if (not this->has_begun()) {
            self().tell_left_out();
            this->finish(reason_for(errc::cancelled));
        } else if (not this->has_to_end()) {
            this->forget();
            this->take(errc::cancelled);
        }
    }

    bool is_inside_{false};   ///< of a call that reports
    bool is_unwanted_{false}; ///< it is to be given up at the end of that call
};

} // namespace altivar
} // namespace RTUWIRE_BUILD
} // namespace rtuwire
