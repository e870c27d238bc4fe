// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// Which units are lost, and how long nothing is sent to them.
//
// A *loss* is a missing response, beyond those that its commander tolerates, of a unit that is ordered or that a stop
// holds: another controller may have ordered it, or this one before it was switched off. So is, while a stop of all units is
// broadcast, an ordered unit that no stop of its own follows: nobody would see whether it heard. Then, for 2 s at most, only
// stop requests go to that unit. After that it gets no request of any conversation, until the drive's own time-out and
// 1 s more have passed since the last of them: it has stopped by itself if it can. A stop that begins meanwhile has
// 2 s for its requests, from the first one on. A response to one of them ends the loss; the order stays cancelled.
// Internal: may change with any version.
#pragma once

#include <cstddef>
#include <cstdint>

#include <rtuwire/ask/commander.hpp>
#include <rtuwire/client/order/order_places.hpp>
#include <rtuwire/client/order/stop_holds.hpp>
#include <rtuwire/core/time.hpp>
#include <rtuwire/core/version.hpp>
#include <rtuwire/wire/errc.hpp>

namespace rtuwire::inline RTUWIRE_BUILD {

/// Of a unit whose type is not the declared one: the longest time-out of any drive, and 1 s more.
inline constexpr duration silence_of_another_family = milliseconds(31'000);

/// The lost units of one client; the base of its orders.
template <std::size_t Units> class unit_losses : public stop_holds<Units> {
    using holds = stop_holds<Units>;

public:
    /// A stop of all units broadcasts, and follows some by stops of its own. Each broadcast may restart a time-out. Of the
    /// other ordered units it is told which control word was read to be theirs.
    template <typename All> constexpr void lose_all_but_its_own(All& all, instant now) noexcept
    {
        for (unit_order& each : places_) {
            bool is_followed = not each.is_ordered;
            for (auto const& own : all.stops()) {
                is_followed = is_followed or own.unit().byte() == each.unit;
            }
            if (not is_followed) {
                all.note_unlisted(each.confirmed);
                lose(each, now);
            }
        }
    }

    /// The outcome of a request of any conversation to a unit; where the client repeated it by itself, a missing
    /// response is no longer tolerated. A `cancelled` request never left: it tells nothing of its unit.
    constexpr void note_outcome(std::uint8_t unit, errc error, bool was_repeated, instant now) noexcept
    {
        unit_order* const own = places_.find(unit);
        if (own == nullptr or error == errc::cancelled) {
            return;
        }
        bool const is_answered = error == errc::none or is_exception(error);
        own->is_doubtful = own->is_doubtful or was_repeated or not is_answered;
        if (is_answered) {
            heed_gap(*own, now);
            own->heard = asked_;
            own->misses = 0;
            own->is_lost = false;
            return;
        }
        if (not own->is_ordered and own->holder == 0) {
            own->confirmed = 0; // whatever answers there next
            return;
        }
        if (own->is_lost or was_repeated or own->misses >= own->tolerated) {
            lose(*own, now);
        } else {
            ++own->misses;
        }
    }

    /// A request is taken now, to any unit.
    constexpr void note_start(instant now) noexcept { asked_ = now; }

    /// Whether a unit gets no request of this effect now; for a broadcast (0), whether one of the units is lost.
    [[nodiscard]] constexpr bool is_silent(std::uint8_t unit, effect what) const noexcept
    {
        for (unit_order const& each : places_) {
            bool const is_meant = each.is_lost and (each.unit == unit or unit == 0);
            bool const may_be_told = what == effect::stopping and (unit == 0 or each.words != stop_words::none);
            if (is_meant and not may_be_told) {
                return true;
            }
        }
        return false;
    }

    /// When `converse` is to be called again for a conversation; for clients, which know no other times of their
    /// conversations.
    constexpr void wake_for(deadline const& when, instant now) noexcept
    {
        bool const is_ahead = when and not reached(now, *when);
        if (is_ahead and not(wake_ and reached(*when, *wake_))) {
            wake_ = when;
        }
    }

    /// Whether a unit is lost.
    [[nodiscard]] constexpr bool is_lost(std::uint8_t unit) const noexcept { return places_.of(unit).is_lost; }

    /// The unit takes no word where its type has them: it gets no request until its own time-out, whatever that is, has
    /// stopped it.
    constexpr void leave_alone(std::uint8_t unit, instant now) noexcept
    {
        if (unit_order* const own = places_.make(unit)) {
            own->silence = silence_of_another_family;
            lose(*own, now);
            own->words = stop_words::none;
        }
    }

    /// Lets time pass. Returns whether a silence is over.
    constexpr bool advance(instant now) noexcept
    {
        holds::let_go_of_ended();
        wake_ = {};
        bool is_over = false;
        for (unit_order& each : places_) {
            heed_gap(each, now);
            if (each.words == stop_words::timed and reached(now, each.words_end)) {
                each.words = stop_words::none;
            }
            if (each.is_lost and reached(now, each.silence_end)) {
                each.is_lost = false;
                is_over = true;
            }
        }
        return is_over;
    }

    /// When `advance` has something to do.
    constexpr void add_to(earliest& next) const noexcept
    {
        next.add(wake_);
        for (unit_order const& each : places_) {
            if (each.is_lost) {
                next.add(each.words == stop_words::timed ? each.words_end : each.silence_end);
            }
        }
    }

protected:
    using holds::count_;
    using holds::places_;
    instant asked_{0}; ///< when the last request was taken, to any unit

private:
    /// The unit may have lost its power where it was not heard for long. Behind its own time-out it has stopped: no order to
    /// run counts any more.
    constexpr void heed_gap(unit_order& own, instant now) noexcept
    {
        constexpr duration behind = milliseconds(1'000); // a clock may be, a little
        duration const gap = now + behind - own.heard;
        own.is_doubtful = own.is_doubtful or gap > longest_gap_in_presence + behind;
        if (own.is_ordered and gap > own.silence) {
            own.confirmed = 0; // a read could let it run as ordered again
            bool const counts = own.last_order != 0 and not is_older(own.last_order, own.last_fault);
            own.last_fault = counts ? ++count_ : own.last_fault;
        }
    }

    constexpr void lose(unit_order& own, instant now) noexcept
    {
        own.confirmed = 0;
        if (not own.is_lost) {
            own.is_lost = true;
            own.was_lost = true;
            if (own.words != stop_words::due) {
                own.words = stop_words::timed;
                own.words_end = now + stop_words_after_loss;
            }
            own.last_stop = ++count_;
        }
        own.silence_end = now + own.silence;
    }

    deadline wake_{};
};

} // namespace rtuwire
