// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// Which stop holds which unit. A stop holds its unit from its start to its end; one that is destroyed before its end
// goes on holding it until another stop of the unit has ended, or `release`. Where there is no place for its unit it
// holds all units without a place, and every such stop sends its requests: the client does not know whose unit is
// held.
// Internal: may change with any version.
#pragma once

#include <cstddef>
#include <cstdint>
#include <type_traits>

#include <rtuwire/ask/commander.hpp>
#include <rtuwire/client/client_number.hpp>
#include <rtuwire/client/order/order_places.hpp>
#include <rtuwire/core/time.hpp>
#include <rtuwire/core/version.hpp>

namespace rtuwire::inline RTUWIRE_BUILD {

/// How long stop requests may be sent after a loss, or after the first one of a stop that follows it.
inline constexpr duration stop_words_after_loss = milliseconds(2'000);

/// The stops under way of one client; the base of its orders.
template <std::size_t Units> class stop_holds {
public:
    /// A commander that stops every unit visits.
    constexpr void visit_for_all(commander& who, instant now) noexcept
    {
        meet(who);
        if (who.has_stopped_) {
            who.has_stopped_ = false;
            who.is_stopping_ = true;
            note_none_counts();
            who.stamp_ = holder_of_all_ = count_;
            is_all_over_ = false; // if another one has just ended
            for (unit_order& each : places_) {
                each.words_end = now + stop_words_after_loss;
                each.words = stop_words::timed;
            }
        }
        if (who.is_over_) {
            who.is_over_ = false;
            who.is_stopping_ = false;
            if (who.stamp_ == holder_of_all_) { // not one that ended before, and visits again
                is_all_over_ = true;
                note_none_counts();
            }
        }
        if (who.is_stopping_ and holder_of_all_ == 0) { // it was released, and still visits
            holder_of_all_ = who.stamp_;
        }
        bool is_known = true;
        who.is_doubtful_ = false;
        for (unit_order const& each : places_) {
            bool const is_usual = each.confirmed != 0 and each.confirmed != other_meaning;
            is_known = is_known and (is_usual or not each.is_ordered);
            who.is_doubtful_ = who.is_doubtful_ or (each.is_doubtful and each.is_ordered);
        }
        who.confirmed_ = is_known ? 1 : 0;
    }

    /// All units were sent a word that takes the power away, without a conversation that stops them.
    constexpr void note_all_freed() noexcept { note_none_counts(); }

    /// Ends the hold of a stop that was given up: its unit can be commanded again. Where none holds it nothing changes: an
    /// order that is in force goes on.
    constexpr void release(std::uint8_t unit) noexcept
    {
        unit_order* const own = places_.find(unit);
        let_go(own == nullptr ? places_.others() : *own);
    }

    /// The same for all units, where a stop of all units was given up. A stop that still visits keeps its hold.
    constexpr void release_all() noexcept
    {
        if (holder_of_all_ != 0) {
            holder_of_all_ = 0;
            note_none_counts();
        }
        let_go(places_.others());
        for (unit_order& each : places_) {
            let_go(each);
        }
    }

protected:
    /// A commander visits. What it holds of another client's count tells nothing here, and that one may have stopped the
    /// unit meanwhile: its orders are over, and its stop begins anew.
    [[gnu::noinline]] constexpr void meet(commander& who) noexcept
    {
        if (number_ == 0) {
            // Behind the count of the client that may have been in this place, of which `commander::known_` is asked. It
            // begins with a stop of all units: every order of another client's count is older.
            number_ = std::is_constant_evaluated() ? 1 : next_client_number();
            count_ = origin();
            stopped_all_ = count_;
        }
        if (who.counted_by_ != number_) {
            bool const is_new = who.counted_by_ == 0 or who.ordered_behind_ != 0; // or begun anew, for this client
            who.stamp_ = is_new ? origin() : 0;
            who.ordered_behind_ = 0;
            who.seen_ = who.stamp_;
            who.has_stopped_ = who.has_stopped_ or who.is_stopping_;
            who.counted_by_ = number_;
        }
    }

    constexpr void begin_stop(commander& who, std::uint8_t unit) noexcept
    {
        who.stamp_ = ++count_;
        who.is_stopping_ = true;
        unit_order& own = place_of(unit);
        own.unit = unit; // for the units without a place: which one is held
        own.last_stop = count_;
        own.holder = count_;
        own.held = hold::by_its_stop;
        own.words = stop_words::due;
    }

    /// A stop under way visits: a place that has become free goes to its unit, and where the stop of another unit
    /// without a place has ended, this one goes on holding.
    constexpr void keep_hold(commander const& who, std::uint8_t unit) noexcept
    {
        unit_order& own = place_of(unit);
        if (own.holder == 0 or own.held == hold::by_another_stop) {
            own.unit = unit;
            own.holder = who.stamp_;
            own.held = hold::by_its_stop;
        }
    }

    /// A stop has ended: ends its holds, also those of units that got their places since; and the hold of an earlier
    /// stop of this unit that was given up before the unit had a place. Orders given before no longer count.
    constexpr void end_stop(commander& who, std::uint8_t unit) noexcept
    {
        who.is_stopping_ = false;
        unit_order const& others = places_.others();
        std::uint32_t const given_up = others.unit == unit ? others.holder : who.stamp_;
        end_hold(places_.others(), who.stamp_, given_up);
        for (unit_order& each : places_) {
            end_hold(each, who.stamp_, given_up);
        }
    }

    /// Whether another stop of the unit has begun since.
    [[nodiscard]] constexpr bool has_another_stop(commander const& who, std::uint8_t unit) const noexcept
    {
        unit_order const* const own = places_.find(unit);
        bool const stops_all = holder_of_all_ != 0 and who.stamp_ == holder_of_all_;
        return own != nullptr and own->holder != 0 and own->holder != who.stamp_ and
               own->held != hold::by_another_stop and not stops_all;
    }

    /// Stops that ended release their units.
    constexpr void let_go_of_ended() noexcept
    {
        if (is_all_over_) {
            holder_of_all_ = 0;
        }
        let_go_if_over(places_.others());
        for (unit_order& each : places_) {
            let_go_if_over(each);
        }
    }

    order_places<Units> places_{};
    std::uint32_t number_{0};        ///< of this client; 0: no commander has visited it
    std::uint32_t count_{0};         ///< of all events, which are told apart by it
    std::uint32_t stopped_all_{0};   ///< the stamp of the last stop of all units
    std::uint32_t holder_of_all_{0}; ///< the same while it is under way; 0: none

private:
    /// What its count began with.
    constexpr std::uint32_t origin() const noexcept { return (number_ << 12U) % 0x4000'0000U + 1; }

    /// From here on no order that was given before counts, of any unit.
    constexpr void note_none_counts() noexcept
    {
        stopped_all_ = ++count_;
        places_.others().last_fault = count_;
        for (unit_order& each : places_) {
            each.last_fault = count_;
        }
    }

    constexpr unit_order& place_of(std::uint8_t unit) noexcept
    {
        unit_order* const place = places_.make(unit);
        return place == nullptr ? places_.others() : *place;
    }

    constexpr void let_go(unit_order& own) noexcept
    {
        if (own.holder == 0) {
            return;
        }
        own.holder = 0;
        own.held = hold::by_its_stop;
        own.last_stop = ++count_;
        own.was_lost = false;
    }
    static constexpr void let_go_if_over(unit_order& own) noexcept
    {
        if (own.held == hold::is_over) {
            own.holder = 0;
            own.held = hold::by_its_stop;
        }
    }

    constexpr void end_hold(unit_order& own, std::uint32_t stop, std::uint32_t given_up) noexcept
    {
        if (own.holder != 0 and (own.holder == stop or own.holder == given_up)) {
            own.held = hold::is_over;
            own.last_stop = ++count_;
            own.was_lost = false;
        }
    }

    bool is_all_over_{false};
};

} // namespace rtuwire
