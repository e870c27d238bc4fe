// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// Which motors a client ordered to run, and what follows from it for every request to their units. No conversation
// could enforce this alone: a read by another one keeps a drive's watchdog fed.
//
// A unit is *ordered* from the first request that enables it until a conversation that commands it has read that its
// motor has no power. Orders and stops have stamps, counted up: an order enables nothing if it is older than the last
// stop of its unit, than its last loss, than a fault that a conversation read, or than another order to run. While a
// stop is under way no other conversation commands its unit; a stop that was destroyed before its end goes on holding
// the unit until another stop of the unit has ended, or `release`. client/order/unit_losses.hpp says what follows from
// a missing response of an ordered unit.
// Internal: may change with any version.
#pragma once

#include <cstddef>
#include <cstdint>

#include <rtuwire/ask/commander.hpp>
#include <rtuwire/client/order/order_places.hpp>
#include <rtuwire/client/order/unit_losses.hpp>
#include <rtuwire/core/bytes.hpp>
#include <rtuwire/core/time.hpp>
#include <rtuwire/core/version.hpp>
#include <rtuwire/wire/errc.hpp>

namespace rtuwire::inline RTUWIRE_BUILD {

/// For a client that commands no motor.
struct no_orders {
    static constexpr bool is_kept = false;
    static constexpr bool advance(instant) noexcept { return false; }
    static constexpr bool is_silent(std::uint8_t, effect) noexcept { return false; }
    static constexpr void note_outcome(std::uint8_t, errc, bool, instant) noexcept {}
    static constexpr void add_to(earliest&) noexcept {}
};

/// The orders of up to `Units` units at once.
template <std::size_t Units> class orders : public unit_losses<Units> {
    using losses = unit_losses<Units>;
    using losses::begin_stop;
    using losses::count_;
    using losses::end_stop;
    using losses::has_another_stop;
    using losses::holder_of_all_;
    using losses::keep_hold;
    using losses::places_;
    using losses::stopped_all_;

    using losses::asked_;

public:
    static constexpr bool is_kept = true;

    /// What is known of the words of a commander's unit.
    constexpr void tell(commander& who, std::uint8_t unit) const noexcept
    {
        if (who.read_meaning_of_ == 0) { // else what it read is newer
            tell(who, places_.of(unit));
        }
    }

    /// Tells a commander that stops every unit whether one is still ordered, behind its visit and those of its stops.
    constexpr void note_ordered(commander& who) const noexcept
    {
        who.is_unit_ordered_ = false;
        for (unit_order const& each : places_) {
            who.is_unit_ordered_ = who.is_unit_ordered_ or each.is_ordered;
        }
    }

    /// A commander of one unit visits: notes what its user wants, and what it read. Returns whether its unit was lost
    /// since its last visit.
    constexpr bool visit(commander& who, std::uint8_t unit, instant now) noexcept
    {
        losses::meet(who);
        bool const is_lost = has_lost(who, unit);
        // An order given since the last visit may be older than what happened meanwhile.
        bool const is_doubtful = (who.has_come_by_ and has_happened(who.seen_, unit)) or
                                 (who.ordered_behind_ != 0 and has_happened(who.ordered_behind_, unit));
        who.ordered_behind_ = 0;
        who.was_stopped_ = who.was_stopped_ or is_doubtful;
        tell_arrangement(who, unit);
        take_notes(who, unit, is_doubtful, now);
        if (who.is_stopping_) {
            keep_hold(who, unit);
        }
        who.has_come_by_ = true;
        who.seen_ = count_;
        who.is_silenced_ = losses::is_silent(unit, effect::stopping);
        unit_order const& own = places_.of(unit);
        who.is_overruled_ = is_stopped_later(who, own) and not is_by_loss(own);
        who.is_unit_ordered_ = own.is_ordered;
        who.known_ = &own;
        tell(who, own);
        return is_lost;
    }

    /// Whether a request of this effect may be sent, apart from a silence: `overruled` where a stop came later than
    /// the order, or another stop is under way, or the unit was rearranged after its commander read it; `unit_lost`
    /// where a loss came later; `too_many_ordered` where there is no place for one more unit.
    [[nodiscard]] constexpr errc check(commander const& who, std::uint8_t unit, effect what) const noexcept
    {
        if (what == effect::none) {
            return errc::none;
        }
        unit_order const& own = places_.of(unit);
        if (what == effect::stopping) {
            return has_another_stop(who, unit) ? errc::overruled : errc::none;
        }
        bool const is_late = is_stopped_later(who, own) or (what == effect::enabling and has_newer(own, who));
        if (own.holder != 0 or holder_of_all_ != 0 or is_late) {
            return is_by_loss(own) ? errc::unit_lost : errc::overruled;
        }
        if (what == effect::rearranging) {
            return own.is_ordered ? errc::overruled : errc::none; // only a drive that is not ordered to run
        }
        if (who.was_rearranged_) {
            return errc::overruled;
        }
        return places_.is_full_for(unit) ? errc::too_many_ordered : errc::none;
    }

    /// Whether another stop, or a later one, overrules this commander of the unit.
    [[nodiscard]] constexpr bool is_overruled(commander const& who, std::uint8_t unit) const noexcept
    {
        return check(who, unit, who.is_stopping_ ? effect::stopping : effect::enabling) == errc::overruled;
    }

    /// A request of this effect was taken from a commander.
    constexpr void note_asked(commander& who, std::uint8_t unit, effect what, duration drive_timeout,
                              std::uint8_t tolerated) noexcept
    {
        switch (what) {
        case effect::enabling:
        case effect::resetting: return note_enabling(who, unit, drive_timeout, tolerated);
        case effect::rearranging: return note_rearranging(unit);
        case effect::stopping: return note_stopping(who, unit, drive_timeout);
        case effect::none: break;
        }
    }

    /// A request of any conversation was taken: one that writes what the control words mean ends what was read of that.
    constexpr void note_request(byte_view frame) noexcept
    {
        if (not writes_meaning(frame)) {
            return;
        }
        std::uint8_t const unit = to_u8(frame[0]);
        for (unit_order& each : places_) {
            each.confirmed = unit == 0 or each.unit == unit ? std::uint16_t{0} : each.confirmed;
        }
    }

    /// Whether this client ordered a unit to run, and no conversation that commands it has read since
    /// that its motor has no power. What a `watch` reads does not count.
    [[nodiscard]] constexpr bool is_ordered(std::uint8_t unit) const noexcept { return places_.of(unit).is_ordered; }

private:
    static constexpr void tell(commander& who, unit_order const& own) noexcept
    {
        who.confirmed_ = own.confirmed;
        who.is_doubtful_ = own.is_doubtful;
    }

    constexpr void take_notes(commander& who, std::uint8_t unit, bool is_doubtful, instant now) noexcept
    {
        if (unit_order* const own = places_.find(unit)) {
            note_power(*own, who.power_seen_);
        }
        who.power_seen_ = power_seen::nothing;
        if (who.has_read_fault_ or who.read_meaning_of_ != 0) {
            unit_order* const found = places_.make(unit);
            unit_order& own = found == nullptr ? places_.others() : *found;
            own.last_fault = who.has_read_fault_ ? ++count_ : own.last_fault;
            // What was read of a unit without a place is forgotten at once.
            if (who.read_meaning_of_ != 0 or found == nullptr) {
                own.confirmed = found == nullptr ? std::uint16_t{0} : who.read_meaning_of_;
                own.is_doubtful = false;
                own.heard = asked_;
            }
            who.has_read_fault_ = false;
            who.read_meaning_of_ = 0;
        }
        if (who.has_ordered_) {
            who.has_ordered_ = false;
            if (is_doubtful) {
                who.takes_over_ = false;
            } else {
                who.stamp_ = ++count_;
                take_over(who, unit, now);
            }
        }
        if (who.has_stopped_) {
            who.has_stopped_ = false;
            begin_stop(who, unit);
        }
        if (who.is_over_) {
            who.is_over_ = false;
            end_stop(who, unit);
        }
    }

    /// A drive that may follow its order later, as one that closes a contactor first, is not at rest where it waits.
    static constexpr void note_power(unit_order& own, power_seen seen) noexcept
    {
        if (seen == power_seen::on) {
            own.is_starting = false;
        } else if (seen == power_seen::off or (seen == power_seen::waits and not own.is_starting)) {
            own.is_starting = false;
            own.is_ordered = false;
            own.misses = 0;
        }
    }

    /// Whether a request writes `meaning_register`, among others or alone. The functions that write holding registers
    /// have their first address in front; 23 has it behind what it reads.
    static constexpr bool writes_meaning(byte_view frame) noexcept
    {
        constexpr std::uint8_t one = 0x06, several = 0x10, exchange = 0x17;
        constexpr std::size_t shortest = 8;
        std::uint8_t const function = frame.size() < shortest ? std::uint8_t{0} : to_u8(frame[1]);
        if (function == one) {
            return u16_at(frame, 2) == meaning_register;
        }
        bool const is_exchange = function == exchange and frame.size() > shortest + 4;
        if (function != several and not is_exchange) {
            return false;
        }
        std::size_t const at = is_exchange ? 6 : 2;
        return static_cast<std::uint16_t>(meaning_register - u16_at(frame, at)) < u16_at(frame, at + 2);
    }

    /// Whether there was a stop, a loss or a fault since.
    constexpr bool has_happened(std::uint32_t since, std::uint8_t unit) const noexcept
    {
        unit_order const& own = places_.of(unit);
        return is_older(since, own.last_stop) or is_older(since, own.last_fault) or is_older(since, stopped_all_);
    }

    constexpr bool has_lost(commander const& who, std::uint8_t unit) const noexcept
    {
        unit_order const& own = places_.of(unit);
        return own.is_lost and is_older(who.seen_, own.last_stop);
    }

    /// A commander that visits for the first time has read nothing yet that this could have changed.
    constexpr void tell_arrangement(commander& who, std::uint8_t unit) const noexcept
    {
        bool const is_new = who.has_come_by_ and is_older(who.seen_, places_.of(unit).rearranged);
        who.was_rearranged_ = who.was_rearranged_ or is_new;
    }

    /// The silence of its unit before it, which ended older orders, does not end this one. It has left the unit doubtful.
    constexpr void take_over(commander& who, std::uint8_t unit, instant now) noexcept
    {
        unit_order* const own = who.takes_over_ ? places_.make(unit) : nullptr;
        who.takes_over_ = false;
        if (own != nullptr) {
            own->last_order = who.stamp_;
            own->heard = own->is_doubtful ? now : own->heard;
        }
    }

    constexpr bool is_stopped_later(commander const& who, unit_order const& own) const noexcept
    {
        return is_older(who.stamp_, own.last_stop) or is_older(who.stamp_, stopped_all_);
    }

    /// Whether it was a loss, and no stop, that withdrew the orders of a unit.
    static constexpr bool is_by_loss(unit_order const& own) noexcept { return own.was_lost and own.holder == 0; }

    /// Whether a fault, or another order to run, came after this commander's order.
    static constexpr bool has_newer(unit_order const& own, commander const& who) noexcept
    {
        bool const is_replaced = own.last_order != 0 and is_older(who.stamp_, own.last_order);
        return is_replaced or is_older(who.stamp_, own.last_fault);
    }

    constexpr void note_enabling(commander const& who, std::uint8_t unit, duration drive_timeout,
                                 std::uint8_t tolerated) noexcept
    {
        if (unit_order* const own = places_.make(unit)) {
            own->last_order = own->last_order == 0 ? who.stamp_ : own->last_order; // its place was lost meanwhile
            own->is_starting = own->is_starting or who.says_run_;
            // Else it was read for the order that is in force, and here it may not be.
            if (who.says_run_ or not own->is_ordered) {
                own->silence = drive_timeout + milliseconds(1'000);
            }
            own->heard = own->is_ordered ? own->heard : asked_;
            own->is_ordered = true;
            own->tolerated = tolerated;
        }
    }

    /// A commander that relies on the unit's words reads anew what they mean.
    constexpr void note_rearranging(std::uint8_t unit) noexcept
    {
        unit_order* const found = places_.find(unit);
        unit_order& own = found == nullptr ? places_.others() : *found;
        own.rearranged = ++count_;
        own.confirmed = 0;
    }

    /// A unit that was not ordered here is left alone for the time that its drive's type gives. Where another conversation's
    /// order ran the motor, as beside a cycle without one, that order is over: each of the two would undo the other's words.
    constexpr void note_stopping(commander& who, std::uint8_t unit, duration drive_timeout) noexcept
    {
        if (unit_order* const own = places_.find(unit)) {
            own->is_starting = false;
            if (not who.is_stopping_ and own->last_order != 0 and is_older(who.stamp_, own->last_order)) {
                own->last_stop = ++count_;
                own->was_lost = false;
                who.seen_ = count_; // it knows its own word
            }
            if (own->words == stop_words::due) {
                own->words = stop_words::timed;
                own->words_end = asked_ + stop_words_after_loss;
            }
            own->silence = own->silence == duration{} ? drive_timeout + milliseconds(1'000) : own->silence;
        }
    }
};

} // namespace rtuwire
