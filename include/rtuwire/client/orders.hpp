// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// Which motors a client ordered to run, and what follows from it for every request to their units. No conversation could
// enforce this alone: a read by another one keeps a drive's watchdog fed.
//
// Orders. A unit is *ordered* from the first request that enables it until a conversation that commands it has read that its
// motor has no power. Orders and stops have stamps, counted up: an order enables nothing if it is older than the last stop of
// its unit, than its last loss, than a fault that a conversation read, or than another order to run.
//
// Stops. A stop holds its unit from its start to its end: no other conversation commands it meanwhile. One that is destroyed
// before its end goes on holding it until another stop of the unit has ended, or `release`; once it has left out its visits
// for 0.5 s it counts as given up, and refuses no other's words that stop. Where there is no place for its unit it holds all
// units without a place, and every such stop sends its requests: the client does not know whose unit is held.
//
// Losses. A *loss* is a request that ended without a response, also one for which the line was never free, beyond those that
// its commander tolerates, of a unit that is ordered or that a stop holds: another controller may have ordered it, or this one
// before it was switched off. So is, while a stop of all units is broadcast, an ordered unit that no stop of its own follows:
// nobody would see whether it heard. So is an ordered unit that nobody's order or stop holds any more, because its stop was
// given up or released, because one broadcast of `broadcast_freewheel` was all that it was told, because the order that
// replaced its own ended before it sent a word, or because its order is over and the motor may run all the same: reads alone
// would keep it running. Then, for 2 s at most, only stop requests go to that unit. After that it gets no request of any
// conversation, until the drive's own time-out and 1 s more have passed since the last of them: it has stopped by itself if it
// can. A stop that begins meanwhile has 2 s for its requests, from the first one on. A response to one of them ends the loss;
// the order stays cancelled.
#pragma once

#include <cstddef>
#include <cstdint>
#include <type_traits>

#include <rtuwire/ask/commander.hpp>
#include <rtuwire/ask/unit_order.hpp>
#include <rtuwire/client/turns.hpp>
#include <rtuwire/core/bytes.hpp>
#include <rtuwire/core/time.hpp>
#include <rtuwire/core/version.hpp>
#include <rtuwire/wire/errc.hpp>

namespace rtuwire {
inline namespace RTUWIRE_BUILD {

namespace detail {

/// Of a unit whose type is not the declared one: the longest time-out of any drive, and 1 s more.
inline constexpr duration silence_of_another_family = milliseconds(31'000);

/// For a client that commands no motor.
struct no_orders {
    static constexpr bool is_kept = false;
    static constexpr bool advance(instant, bool, std::uint8_t) noexcept { return false; }
    static constexpr bool is_silent(std::uint8_t, effect) noexcept { return false; }
    static constexpr void note_outcome(std::uint8_t, errc, bool, instant) noexcept {}
    static constexpr void add_to(earliest&) noexcept {}
};

/// The orders of up to `Units` units at once, the stops that hold them, and those that are lost.
template <std::size_t Units> class orders {
public:
    static constexpr bool is_kept = true;

    constexpr orders() noexcept = default;
    constexpr orders(orders const& original) noexcept { *this = original; }

    /// A copy knows which motors may run, which units are held and which are lost. It is another client, behind the count of
    /// both: no order that was given before counts for it, and a motor that runs is held by nobody.
    constexpr orders& operator=(orders const& original) noexcept
    {
        count_ = newer_of(count_, original.count_);
        all_ = original.all_;
        is_by_commander_ = original.is_by_commander_;
        is_stop_asked_ = original.is_stop_asked_;
        is_cut_ = original.is_cut_;
        asked_ = original.asked_;
        wake_ = original.wake_;
        places_ = original.places_;
        if (count_ != 0) { // else none was used
            begin_count();
            note_none_counts();
            leave_all();
        }
        return *this;
    }

    // What commanders tell when they visit, and what they are told.

    /// Before a commander begins: what is known of its unit.
    constexpr void tell(commander& who) const noexcept
    {
        unit_order const& own = places_.of(who.whose_.byte());
        who.is_unit_ordered_ = own.is_ordered;
        if (who.read_meaning_of_ == 0) { // else what it read is newer
            tell(who, own);
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

    /// A commander of one unit visits: what its user wants, and what it read. Returns whether its unit was lost meanwhile.
    constexpr bool take_note_of(commander& who, instant now) noexcept
    {
        meet(who);
        unit_order const& before = places_.of(who.whose_.byte());
        bool const is_lost = before.is_lost and is_older(who.seen_, before.last_stop);
        // An order given since the last visit may be older than what happened meanwhile.
        bool const is_begun_anew = who.ordered_behind_ != 0; // and has not visited since
        bool const is_doubtful = (who.has_visited_ or is_begun_anew) and
                                 has_happened(is_begun_anew ? who.ordered_behind_ : who.seen_, before);
        who.ordered_behind_ = 0;
        who.was_stopped_ = who.was_stopped_ or is_doubtful;
        // One that visits for the first time has read nothing yet that this could have changed.
        bool const is_rearranged = who.has_visited_ and is_older(who.seen_, before.rearranged);
        who.was_rearranged_ = who.was_rearranged_ or is_rearranged;
        take_notes(who, is_doubtful, now);
        if (who.is_stopping_) {
            places_.make_entry(who.whose_.byte()).keep_hold(who.whose_.byte(), who.stamp_, now);
        }
        who.has_visited_ = true;
        who.seen_ = count_;
        who.is_silenced_ = is_silent(who.whose_.byte(), effect::stopping);
        unit_order const& own = places_.of(who.whose_.byte());
        who.is_overruled_ = is_stopped_later(who, own) and not own.is_by_loss();
        who.is_unit_ordered_ = own.is_ordered;
        who.known_ = &own;
        tell(who, own);
        return is_lost;
    }

    /// A commander goes on. Until its order enables the unit, a motor that runs by the one before is held for so many answers.
    constexpr void note_under_way(commander const& who) noexcept
    {
        unit_order* const own = places_.find(who.whose_.byte());
        bool const is_left = own != nullptr and own->answers_left != 0 and own->last_order == who.stamp_;
        if (is_left and not is_stopped_later(who, *own) and not is_older(who.stamp_, own->last_fault)) {
            own->answers_left = most_answers;
        }
    }

    /// Whether a request of this effect may be sent, apart from a silence: `overruled` where a stop came later than the order,
    /// or another stop is under way, or the unit was rearranged after its commander read it; `unit_lost` where a loss came
    /// later; `too_many_ordered` where there is no place for one more unit.
    [[nodiscard]] constexpr errc check(commander const& who, effect what) const noexcept
    {
        if (what == effect::none) {
            return errc::none;
        }
        unit_order const& own = places_.of(who.whose_.byte());
        if (what == effect::stopping) {
            return has_another_stop(who) ? errc::overruled : errc::none;
        }
        bool const is_late = is_stopped_later(who, own) or (what == effect::enabling and own.has_newer(who.stamp_));
        if (own.holder != 0 or all_.stamp() != 0 or is_late) {
            return own.is_by_loss() ? errc::unit_lost : errc::overruled;
        }
        if (what == effect::rearranging) {
            return own.is_ordered ? errc::overruled : errc::none; // only a drive that is not ordered to run
        }
        if (who.was_rearranged_) {
            return errc::overruled;
        }
        return places_.is_full_for(own) ? errc::too_many_ordered : errc::none;
    }

    /// Whether another stop, or a later one, overrules this commander of the unit.
    [[nodiscard]] constexpr bool is_overruled(commander const& who) const noexcept
    {
        return check(who, who.is_stopping_ ? effect::stopping : effect::enabling) == errc::overruled;
    }

    /// A request of this effect was taken from a commander.
    constexpr void note_asked(commander& who, effect what, duration drive_timeout, std::uint8_t tolerated) noexcept
    {
        is_by_commander_ = true;
        is_stop_asked_ = what == effect::stopping;
        switch (what) {
        case effect::enabling:
        case effect::resetting: return note_enabling(who, drive_timeout, tolerated);
        case effect::rearranging: return note_rearranging(who.whose_.byte());
        case effect::stopping: return note_stopping(who, drive_timeout);
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

    /// Whether a unit is ordered (what a `watch` reads does not end that), or lost.
    [[nodiscard]] constexpr bool is_ordered(std::uint8_t unit) const noexcept { return places_.of(unit).is_ordered; }
    [[nodiscard]] constexpr bool is_lost(std::uint8_t unit) const noexcept { return places_.of(unit).is_lost; }

    // Stops of all units, and holds that nobody ends.

    /// A commander that stops every unit visits.
    constexpr void take_note_of_all(commander& who, instant now) noexcept
    {
        meet(who);
        if (who.has_stopped_) {
            who.has_stopped_ = false;
            who.is_stopping_ = true;
            note_none_counts();
            who.stamp_ = count_;
            all_.begin(count_);
            for (unit_order& each : places_) {
                each.time_words(now);
            }
        }
        if (who.is_over_) {
            who.is_over_ = false;
            who.is_stopping_ = false;
            if (who.stamp_ == all_.stamp()) { // not one that ended before, and visits again
                all_.end();
                note_none_counts();
            }
        }
        if (who.is_stopping_) {
            all_.keep(who.stamp_, now);
        }
        bool is_known = true;
        who.is_doubtful_ = false;
        for (unit_order& each : places_) {
            each.answers_left = who.is_stopping_ and each.holder == 0 ? std::uint8_t{0} : each.answers_left;
            bool const is_usual = each.confirmed != 0 and each.confirmed != other_meaning;
            is_known = is_known and (is_usual or not each.is_ordered);
            who.is_doubtful_ = who.is_doubtful_ or (each.is_doubtful and each.is_ordered);
        }
        who.confirmed_ = is_known ? 1 : 0;
    }

    /// All units are sent a word that takes the power away, and no conversation stops them. Nobody knows whether they heard it;
    /// it may restart the time-out of a lost one.
    constexpr void note_all_freed() noexcept
    {
        note_none_counts();
        for (unit_order& each : places_) {
            each.silence_end = asked_ + each.silence;
        }
        leave_all();
    }

    /// Ends the hold of a stop that was given up. Where none holds it nothing changes: an order that is in force goes on.
    constexpr void release(std::uint8_t unit) noexcept { places_.entry_of(unit).let_go(count_); }

    /// The same for all units, where a stop of all units was given up. A stop that still visits keeps its hold.
    constexpr void release_all() noexcept
    {
        if (all_.stamp() != 0) {
            all_.let_go();
            note_none_counts();
            leave_all();
        }
        places_.others().let_go(count_);
        for (unit_order& each : places_) {
            each.let_go(count_);
        }
    }

    // Losses, and the time that passes.

    /// A stop of all units broadcasts, and follows some by stops of its own. Each broadcast may restart a time-out. Of the
    /// other ordered units it is told which control word was read to be theirs.
    template <typename All> constexpr void lose_all_but_its_own(All& all, instant now) noexcept
    {
        for (unit_order& each : places_) {
            each.silence_end = now + each.silence;
            bool is_followed = not each.is_ordered;
            for (auto const& own : all.stops()) {
                is_followed = is_followed or own.unit().byte() == each.unit;
            }
            if (not is_followed) {
                all.note_unlisted(each.confirmed);
                each.lose(now, count_);
            }
        }
    }

    /// The outcome of a request of any conversation to a unit; where the client repeated it, a missing response is no longer
    /// tolerated. One that a stop cut short, or that ended as `cancelled` and never left, tells nothing of its unit.
    constexpr void note_outcome(std::uint8_t unit, errc error, bool was_repeated, instant now) noexcept
    {
        unit_order* const own = places_.find(unit);
        if (own == nullptr or is_cut_ or error == errc::cancelled) {
            return;
        }
        bool const is_answered = error == errc::none or is_exception(error);
        if (was_repeated or not is_answered) {
            own->is_doubtful = true;
        }
        if (is_answered) {
            if (was_repeated) { // an earlier sending may not have reached it
                heed_gap(*own, now, false);
            }
            own->note_answer(asked_, was_repeated ? now : asked_);
            // What was asked before the loss tells nothing of whether the unit is being stopped.
            own->is_lost = own->is_lost and not is_stop_asked_;
            if (own->answers_left != 0 and own->was_last_answer(is_by_commander_)) {
                own->lose(now, count_);
            }
            return;
        }
        if (not own->is_ordered and own->holder == 0) {
            own->confirmed = 0; // whatever answers there next
            return;
        }
        if (own->is_lost or was_repeated or own->misses >= own->tolerated) {
            own->lose(now, count_);
        } else {
            ++own->misses;
        }
    }

    /// A request is taken now, to any unit.
    constexpr void note_start(instant now) noexcept
    {
        asked_ = now;
        is_by_commander_ = false;
        is_stop_asked_ = false;
        is_cut_ = false;
    }

    /// The request under way is given up for a stop.
    constexpr void note_cut() noexcept { is_cut_ = true; }

    /// Whether a unit gets no request of this effect now; for a broadcast (0), whether one of the units is lost.
    [[nodiscard]] constexpr bool is_silent(std::uint8_t unit, effect what) const noexcept
    {
        for (unit_order const& each : places_) {
            bool const may_be_told = what == effect::stopping and (unit == 0 or each.words != stop_words::none);
            if (each.is_lost and not may_be_told and (each.unit == unit or unit == 0)) {
                return true;
            }
        }
        return false;
    }

    /// When `converse` is to be called again for a conversation: a client knows no other times of these.
    constexpr void wake_for(deadline const& when, instant now) noexcept { keep_earlier(wake_, when, now); }

    /// The unit takes no word where its type has them: it gets no request until its own time-out has stopped it.
    constexpr void leave_alone(std::uint8_t unit, instant now) noexcept
    {
        if (unit_order* const own = places_.make(unit)) {
            own->silence = silence_of_another_family;
            own->lose(now, count_);
            own->words = stop_words::none;
        }
    }

    /// Lets time pass, from where stops that ended hold their units no longer. Returns whether a silence is over. `is_asked`: a
    /// request to `asked` has no outcome taken yet.
    constexpr bool advance(instant now, bool is_asked, std::uint8_t asked) noexcept
    {
        all_.let_go_if_over();
        places_.others().let_go_if_over();
        wake_ = {};
        bool is_over = false;
        bool const is_all_left = all_.has_missed(now);
        for (unit_order& each : places_) {
            each.let_go_if_over();
            bool const is_under_way = is_asked and (asked == each.unit or asked == 0);
            each.on_line = is_under_way ? now : each.on_line; // it may feed a motor that runs
            heed_gap(each, now, is_under_way);
            each.heed_absence(is_all_left, now);
            is_over = each.end_silence(now) or is_over;
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

private:
    // What a commander tells.

    static constexpr void tell(commander& who, unit_order const& own) noexcept
    {
        who.confirmed_ = own.confirmed;
        who.is_doubtful_ = own.is_doubtful;
    }

    constexpr void take_notes(commander& who, bool is_doubtful, instant now) noexcept
    {
        if (unit_order* const own = places_.find(who.whose_.byte())) {
            own->note_power(who.power_seen_);
        }
        who.power_seen_ = power_seen::nothing;
        if (who.has_read_fault_ or who.read_meaning_of_ != 0) {
            unit_order* const found = places_.make(who.whose_.byte());
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
                take_over(who, now);
            }
        }
        if (who.has_stopped_) {
            who.has_stopped_ = false;
            begin_stop(who);
        }
        if (who.is_over_) {
            who.is_over_ = false;
            end_stop(who);
        }
    }

    /// Whether there was a stop, a loss or a fault since.
    constexpr bool has_happened(std::uint32_t since, unit_order const& own) const noexcept
    {
        return is_older(since, own.last_stop) or is_older(since, own.last_fault) or is_older(since, stopped_all_);
    }

    /// The silence of its unit before it, which ended older orders, does not end this one. It has left the unit doubtful.
    constexpr void take_over(commander& who, instant now) noexcept
    {
        unit_order* const own = who.takes_over_ ? places_.make(who.whose_.byte()) : nullptr;
        who.takes_over_ = false;
        if (own != nullptr) {
            own->last_order = who.stamp_;
            if (own->holder == 0 and own->answers_left == 0) {
                own->leave(own->on_line); // unless it enables the unit, too
            }
            own->heard = own->is_doubtful ? now : own->heard;
        }
    }

    constexpr bool is_stopped_later(commander const& who, unit_order const& own) const noexcept
    {
        return is_older(who.stamp_, own.last_stop) or is_older(who.stamp_, stopped_all_);
    }

    constexpr void note_enabling(commander const& who, duration drive_timeout, std::uint8_t tolerated) noexcept
    {
        if (unit_order* const own = places_.make(who.whose_.byte())) {
            own->last_order = own->last_order == 0 ? who.stamp_ : own->last_order; // its place was lost meanwhile
            own->note_enabling(who.says_run_, drive_timeout, tolerated, asked_);
        }
    }

    /// A commander that relies on the unit's words reads anew what they mean.
    constexpr void note_rearranging(std::uint8_t unit) noexcept
    {
        unit_order& own = places_.entry_of(unit);
        own.rearranged = ++count_;
        own.confirmed = 0;
    }

    /// A unit that was not ordered here is left alone for the time that its drive's type gives. Another conversation's order
    /// that ran the motor, as beside a cycle without one, is over: each of the two would undo the other's words.
    constexpr void note_stopping(commander& who, duration drive_timeout) noexcept
    {
        if (unit_order* const own = places_.find(who.whose_.byte())) {
            own->is_starting = false;
            if (not who.is_stopping_ and own->is_replaced(who.stamp_)) {
                own->withdraw(++count_);
                who.seen_ = count_; // it knows its own word
            }
            if (own->words == stop_words::due) {
                own->time_words(asked_);
            }
            own->silence = own->silence == duration{} ? drive_timeout + milliseconds(1'000) : own->silence;
            own->looks = 0; // it follows its word
        }
    }

    // The holds of stops.

    /// A commander visits. What it holds of another client's count tells nothing here, and that one may have stopped the
    /// unit meanwhile: its orders are over, and its stop begins anew.
    [[gnu::noinline]] constexpr void meet(commander& who) noexcept
    {
        if (number_ == 0) {
            begin_count();
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

    constexpr void begin_stop(commander& who) noexcept
    {
        who.stamp_ = ++count_;
        who.is_stopping_ = true;
        unit_order& own = places_.make_entry(who.whose_.byte());
        own.last_stop = count_;
        own.take_hold(who.whose_.byte(), count_);
        own.words = stop_words::due;
    }

    /// Ends all holds of a stop that has ended, and that of an earlier stop of this unit that was given up before the unit had a
    /// place. Orders given before no longer count.
    constexpr void end_stop(commander& who) noexcept
    {
        who.is_stopping_ = false;
        unit_order const& others = places_.others();
        std::uint32_t const given_up = others.unit == who.whose_.byte() ? others.holder : who.stamp_;
        places_.others().end_stop(who.stamp_, given_up, count_);
        for (unit_order& each : places_) {
            each.end_stop(who.stamp_, given_up, count_);
        }
    }

    /// Whether another stop of the unit has begun since.
    [[nodiscard]] constexpr bool has_another_stop(commander const& who) const noexcept
    {
        unit_order const* const own = places_.find(who.whose_.byte());
        bool const stops_all = all_.stamp() != 0 and who.stamp_ == all_.stamp();
        return own != nullptr and own->is_held_by_another(who.stamp_) and not stops_all;
    }

    /// Behind the count of the client that may have been in this place, of which `commander::known_` is asked. It begins with
    /// a stop of all units: every order of another client's count is older.
    constexpr void begin_count() noexcept
    {
        number_ = std::is_constant_evaluated() ? count_ + 1 : next_client_number();
        count_ = newer_of(count_, origin());
        stopped_all_ = count_;
    }

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

    /// The orders to run of a unit end that was not heard for longer than its own time-out.
    [[gnu::noinline]] constexpr void heed_gap(unit_order& own, instant now, bool is_asked) noexcept
    {
        if (own.heed_gap(now, is_asked, asked_)) {
            own.last_fault = ++count_;
            own.leave(now);
        }
    }

    /// The units that no stop holds.
    constexpr void leave_all() noexcept
    {
        for (unit_order& each : places_) {
            if (each.holder == 0 and all_.stamp() == 0) {
                each.leave(each.on_line);
            }
        }
    }

    std::uint32_t count_{0};       ///< of all events, which are told apart by it
    std::uint32_t number_{0};      ///< of this client; 0: no commander has visited it, nor one that it is a copy of
    std::uint32_t stopped_all_{0}; ///< the stamp of the last stop of all units
    [[no_unique_address]] stop_of_all all_{};
    bool is_by_commander_{false}; ///< the last request
    bool is_stop_asked_{false};   ///< the last request stops a unit
    bool is_cut_{false};          ///< a stop cut it short
    instant asked_{0};            ///< when the last request was taken, to any unit
    deadline wake_{};
    order_places<Units> places_;
};

} // namespace detail

} // namespace RTUWIRE_BUILD
} // namespace rtuwire
