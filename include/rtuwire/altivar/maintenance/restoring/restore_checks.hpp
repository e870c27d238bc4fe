// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// What a restore asks of its drive: who it is, whether it stands, its words, a write and what that gave, a last look, a
// save. Each response goes to where it belongs; which parameter is next, the restore itself decides.
// Internal: may change with any version.
#pragma once

#include <cstdint>

#include <rtuwire/altivar/maintenance/block_walk.hpp>
#include <rtuwire/altivar/maintenance/guarded_write.hpp>
#include <rtuwire/altivar/maintenance/restoring/restore_procedures.hpp>
#include <rtuwire/core/version.hpp>

namespace rtuwire {
inline namespace RTUWIRE_BUILD {
namespace altivar {

/// The steps of a restore's conversation. `Restore` derives from it, and gets what came of each request by an `on_` function.
///
/// | doing         | response                              | exception            | no response       |
/// |---------------|---------------------------------------|----------------------|-------------------|
/// | identifying   | this family: check; else fail         | 01, 02, 03: compare  | fail              |
/// | comparing     | the next block; after the last: check | fail: other_family   | fail              |
/// | checking      | the procedure's next; at its end:     | as the procedure     | as the procedure  |
/// |               | `on_checked`, `go_on`, `on_saved`     |                      |                   |
/// | reading_block | `on_words`                            | `on_refused_block`   | fail              |
/// | writing       | `on_written`                          | `on_write_failed`    | `on_write_failed` |
/// | reading_back  | `on_read_back`                        | `on_no_read_back`    | `on_no_read_back` |
///
/// "Checking" is any inner procedure; one that ends otherwise than with success fails. "Fail" looks once more at a drive
/// that got a delicate write, and then ends.
template <typename Restore> class restore_checks : public restore_procedures<Restore> {
    using base = restore_procedures<Restore>;

public:
    using base::settled;

protected:
    using base::self;

    constexpr restore_checks(unit_id its_unit, drive_layout const& layout, terminal_options const& terminals,
                             identity_check const& identity) noexcept
        : base{its_unit, layout, terminals}, identity_{identity}
    {}

    // What the calls come to.

    constexpr void go_on_in_time() noexcept
    {
        if (this->is_stopping() and this->is_unit_ordered()) {
            this->finish({outcome_kind::overruled}); // the motor now runs by an order: it is not this one's to stop
        } else if (this->is_pause_over()) {
            this->run({event::kind::pause_over});
        }
    }

    constexpr void take(result<response> const& outcome) noexcept
    {
        bool const was_sent = this->is_asking();
        this->note_outcome();
        if (settled()) {
            return;
        }
        switch (doing_) {
        case doing::identifying: on_identification(outcome); break;
        case doing::comparing:
        case doing::reading_block: on_block(this->words_of(outcome)); break;
        case doing::checking: this->run(this->event_of(outcome)); break;
        case doing::writing: on_write(this->event_of(outcome), was_sent); break;
        case doing::reading_back: on_read_back(this->event_of(outcome)); break;
        }
        heed_loss();
    }

    /// The unit was lost: what would wait until the drive has stopped by itself fails now.
    constexpr void heed_loss() noexcept
    {
        if (not has_lost_ or this->is_asking() or settled()) {
            return;
        }
        has_lost_ = false;
        if (not this->is_stopping()) {
            take(errc::unit_lost);
        }
    }
    constexpr void note_loss_now() noexcept
    {
        has_lost_ = this->has_begun() and not settled();
        heed_loss();
    }

    /// Whether nothing may end what is done now but its own end.
    constexpr bool has_to_end() noexcept { return this->give_up() and doing_ == doing::checking; }

    // What `Restore` calls.

    [[nodiscard]] constexpr identity_check& identity() noexcept { return identity_; }

    /// Checks who the drive is, and whether it stands; then `on_checked`.
    constexpr void check(write_care care) noexcept
    {
        care_ = care;
        if (identity_.holds()) {
            guard();
        } else {
            identify();
        }
    }

    constexpr void read(detail::address_block block) noexcept
    {
        doing_ = doing::reading_block;
        this->read_block(block);
    }

    constexpr void write(std::uint16_t address, std::uint16_t word) noexcept
    {
        doing_ = doing::writing;
        if (care_ != write_care::rest) {
            this->note_delicate();
        }
        this->perform(once(to_rearrange(address, word)));
    }

    constexpr void read_back(std::uint16_t address) noexcept
    {
        doing_ = doing::reading_back;
        this->perform(to_read(address));
    }

    constexpr bool look_at_last() noexcept
    {
        doing_ = doing::checking;
        return base::look_at_last();
    }

    constexpr void save() noexcept
    {
        doing_ = doing::checking;
        base::save();
    }

    constexpr void fail(altivar::reason const& so) noexcept
    {
        if (base::fail(so)) {
            doing_ = doing::checking;
        }
    }

private:
    enum class doing : std::uint8_t { identifying, comparing, checking, reading_block, writing, reading_back };

    constexpr void identify() noexcept
    {
        if (identity_.has_identification()) {
            doing_ = doing::identifying;
            return this->read_product();
        }
        doing_ = doing::comparing;
        self().walk().begin();
        compare_next();
    }

    constexpr void compare_next() noexcept
    {
        if (self().walk().find(self().map(), identity_check::is_compared)) {
            return this->read_block(self().walk().block());
        }
        identity_.note_same();
        guard();
    }

    constexpr void guard() noexcept
    {
        doing_ = doing::checking;
        base::guard(care_);
    }

    constexpr void on_identification(result<response> const& outcome) noexcept
    {
        errc error{};
        switch (identity_.judge(outcome, error)) {
        case identity_check::verdict::same: return guard();
        case identity_check::verdict::not_told: return identify();
        case identity_check::verdict::other: return fail({outcome_kind::other_family, error});
        case identity_check::verdict::not_reached: break;
        }
        fail(reason_for(error));
    }

    constexpr void on_block(result<register_view> const& words) noexcept
    {
        bool const is_compared = doing_ == doing::comparing;
        if (not words and not is_of_registers(words.error())) {
            fail(reason_for(words.error()));
        } else if (not words) {
            is_compared ? fail({outcome_kind::other_family, words.error()}) : self().on_refused_block(words.error());
        } else if (is_compared) {
            self().walk().pass();
            compare_next();
        } else {
            self().on_words(*words);
        }
    }

    constexpr void on_write(event what, bool was_sent) noexcept
    {
        return what.what() == event::kind::written ? self().on_written()
                                                   : self().on_write_failed(what.error(), was_sent);
    }

    constexpr void on_read_back(event what) noexcept
    {
        return what.what() == event::kind::word_read ? self().on_read_back(what.word())
                                                     : self().on_no_read_back(what.error());
    }

    identity_check identity_;
    doing doing_{doing::identifying};
    write_care care_{write_care::rest};
    bool has_lost_{false};
};

} // namespace altivar
} // namespace RTUWIRE_BUILD
} // namespace rtuwire
