// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// Which motors a client ordered to run, and what follows from it for every request to their units. No conversation
// could enforce this alone: a read by another one keeps a drive's watchdog fed.
//
// Orders. A unit is *ordered* from the first request that enables it until a conversation that commands it has read that
// its motor has no power. Orders and stops have stamps, counted up: an order enables nothing if it is older than the last
// stop of its unit, than its last loss, than a fault that a conversation read, or than another order to run.
//
// Stops. A stop holds its unit from its start to its end: no other conversation commands it meanwhile. One that is
// destroyed before its end goes on holding it until another stop of the unit has ended, or `release`; once it has left out
// its visits for 0.5 s it counts as given up, and refuses no other's words that stop. Where there is no place for its unit it
// holds all units without a place, and every such stop sends its requests: the client does not know whose unit is held.
//
// Losses. A *loss* is a request that ended without a response, also one for which the line was never free, beyond those that
// its commander tolerates, of a unit that is ordered or that a stop holds: another controller may have ordered it, or this
// one before it was switched off. So is, while a stop of all units is broadcast, an ordered unit that no stop of its own
// follows: nobody would see whether it heard. So is an ordered unit that nobody's order or stop holds any more, because its
// stop was given up or released, because one broadcast of `broadcast_freewheel` was all that it was told, because the order
// that replaced its own ended before it sent a word, or because its order is over and the motor may run all the same: reads
// alone would keep it running. Then, for 2 s at most, only stop requests go to that unit. After that it gets no request of
// any conversation, until the drive's own time-out and 1 s more have passed since the last of them: it has stopped by itself
// if it can. A stop that begins meanwhile has 2 s for its requests, from the first one on. A response to one of them ends
// the loss; the order stays cancelled.
#pragma once

#include <cstddef>
#include <cstdint>
#include <type_traits>

#include <rtuwire/ask/commander.hpp>
#include <rtuwire/ask/unit_order.hpp>
#include <rtuwire/client/order_places.hpp>
#include <rtuwire/client/turns.hpp>
#include <rtuwire/core/bytes.hpp>
#include <rtuwire/core/time.hpp>
#include <rtuwire/core/version.hpp>
#include <rtuwire/wire/errc.hpp>

namespace rtuwire {
inline namespace RTUWIRE_BUILD {

namespace detail {

/// How long stop requests may be sent after a loss, or after the first one of a stop that follows it.
inline constexpr duration stop_words_after_loss = milliseconds(2'000);

/// How long a stop under way may leave out its visits before it counts as given up, in steps of 65.5 ms (0.5 s); and for how
/// many passes.
inline constexpr std::uint16_t longest_absence = 8;
inline constexpr std::uint8_t most_passes_missed = 4;

/// Nobody's order or stop holds an ordered unit: it is lost behind so many answers to others than commanders. Before, a
/// commander's look may still show that it has no power, or that its order replaces the one before.
inline constexpr std::uint8_t most_answers = 3;
/// Or where its answers have made so many points, of which one to a commander makes five: 51 of these are more than any
/// order needs before its first word.
inline constexpr std::uint32_t most_looks = 255, look_of_a_commander = 5;

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

    /// A copy knows which motors may run, which units are held and which are lost. No order that was given before counts for
    /// it: it is another client, behind the count of both. A motor that runs is held by nobody then.
    constexpr orders& operator=(orders const& original) noexcept
    {
        count_ = newer_of(count_, original.count_);
        holder_of_all_ = original.holder_of_all_;
        is_all_over_ = original.is_all_over_;
        is_all_shared_ = original.is_all_shared_;
        is_by_commander_ = original.is_by_commander_;
        all_passes_left_ = original.all_passes_left_;
        all_seen_ = original.all_seen_;
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

    /// What is known of a commander's unit before it begins.
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

    /// A commander of one unit visits: notes what its user wants, and what it read. Returns whether its unit was lost
    /// since its last visit.
    constexpr bool take_note_of(commander& who, instant now) noexcept
    {
        meet(who);
        unit_order const& before = places_.of(who.whose_.byte());
        bool const is_lost = before.is_lost and is_older(who.seen_, before.last_stop);
        // An order given since the last visit may be older than what happened meanwhile.
        bool const is_doubtful = (who.has_visited_ and has_happened(who.seen_, before)) or
                                 (who.ordered_behind_ != 0 and has_happened(who.ordered_behind_, before));
        who.ordered_behind_ = 0;
        who.was_stopped_ = who.was_stopped_ or is_doubtful;
        // One that visits for the first time has read nothing yet that this could have changed.
        bool const is_rearranged = who.has_visited_ and is_older(who.seen_, before.rearranged);
        who.was_rearranged_ = who.was_rearranged_ or is_rearranged;
        take_notes(who, is_doubtful, now);
        if (who.is_stopping_) {
            keep_hold(who, now);
        }
        who.has_visited_ = true;
        who.seen_ = count_;
        who.is_silenced_ = is_silent(who.whose_.byte(), effect::stopping);
        unit_order const& own = places_.of(who.whose_.byte());
        who.is_overruled_ = is_stopped_later(who, own) and not is_by_loss(own);
        who.is_unit_ordered_ = own.is_ordered;
        who.known_ = &own;
        tell(who, own);
        return is_lost;
    }

    /// A commander goes on behind its visit. Until its own order enables the unit, a motor that runs by the one before is held by
    /// that, for so many answers in all.
    constexpr void note_under_way(commander const& who) noexcept
    {
        unit_order* const own = places_.find(who.whose_.byte());
        bool const is_left = own != nullptr and own->answers_left != 0 and own->last_order == who.stamp_;
        if (is_left and not is_stopped_later(who, *own) and not is_older(who.stamp_, own->last_fault)) {
            own->answers_left = most_answers;
        }
    }

    /// Whether a request of this effect may be sent, apart from a silence: `overruled` where a stop came later than
    /// the order, or another stop is under way, or the unit was rearranged after its commander read it; `unit_lost`
    /// where a loss came later; `too_many_ordered` where there is no place for one more unit.
    [[nodiscard]] constexpr errc check(commander const& who, effect what) const noexcept
    {
        if (what == effect::none) {
            return errc::none;
        }
        unit_order const& own = places_.of(who.whose_.byte());
        if (what == effect::stopping) {
            return has_another_stop(who) ? errc::overruled : errc::none;
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
        return places_.is_full_for(who.whose_.byte()) ? errc::too_many_ordered : errc::none;
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

    /// Whether this client ordered a unit to run, and no conversation that commands it has read since
    /// that its motor has no power. What a `watch` reads does not count.
    [[nodiscard]] constexpr bool is_ordered(std::uint8_t unit) const noexcept { return places_.of(unit).is_ordered; }

    // Stops of all units, and holds that nobody ends.

    /// A commander that stops every unit visits.
    constexpr void take_note_of_all(commander& who, instant now) noexcept
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
        if (who.is_stopping_ and (holder_of_all_ == 0 or is_all_over_)) { // it was released, or outlives another one
            holder_of_all_ = who.stamp_;
            is_all_over_ = false;
        }
        if (who.is_stopping_) {
            is_all_shared_ = is_all_shared_ or who.stamp_ != holder_of_all_;
            all_seen_ = step_of(now);
            all_passes_left_ = most_passes_missed;
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

    /// All units are sent a word that takes the power away, without a conversation that stops them. Nobody knows whether they
    /// heard it, and it may restart the time-out of a lost one.
    constexpr void note_all_freed() noexcept
    {
        note_none_counts();
        for (unit_order& each : places_) {
            each.silence_end = asked_ + each.silence;
        }
        leave_all();
    }

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
            leave_all();
        }
        let_go(places_.others());
        for (unit_order& each : places_) {
            let_go(each);
        }
    }

    // Losses, and the time that passes.

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
    /// response is no longer tolerated. One that ended as `cancelled` tells nothing of its unit: it never left.
    constexpr void note_outcome(std::uint8_t unit, errc error, bool was_repeated, instant now) noexcept
    {
        unit_order* const own = places_.find(unit);
        if (own == nullptr or error == errc::cancelled) {
            return;
        }
        bool const is_answered = error == errc::none or is_exception(error);
        own->is_doubtful = own->is_doubtful or was_repeated or not is_answered;
        if (is_answered) {
            if (was_repeated) { // an earlier sending may not have reached it
                heed_gap(*own, now, false);
            }
            own->heard = asked_;
            own->on_line = was_repeated ? now : asked_;
            own->misses = 0;
            own->is_lost = false;
            if (own->answers_left != 0 and was_last_answer(*own)) {
                lose(*own, now);
            }
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
    constexpr void note_start(instant now) noexcept
    {
        asked_ = now;
        is_by_commander_ = false;
    }

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
    constexpr void wake_for(deadline const& when, instant now) noexcept { keep_earlier(wake_, when, now); }

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

    /// Lets time pass. Returns whether a silence is over. `is_asked`: a request to `asked` is under way, or its outcome not
    /// taken yet.
    constexpr bool advance(instant now, bool is_asked, std::uint8_t asked) noexcept
    {
        let_go_of_ended();
        wake_ = {};
        bool is_over = false;
        bool const is_all_left = holder_of_all_ != 0 and has_missed(all_passes_left_, all_seen_, now);
        for (unit_order& each : places_) {
            bool const is_under_way = is_asked and (asked == each.unit or asked == 0);
            heed_gap(each, now, is_under_way);
            heed_absence(each, is_all_left, now);
            each.on_line = is_under_way ? now : each.on_line;
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
            note_power(*own, who.power_seen_);
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

    /// A drive that may follow its order later, as one that closes a contactor first, is not at rest where it waits.
    static constexpr void note_power(unit_order& own, power_seen seen) noexcept
    {
        if (seen == power_seen::on) {
            own.is_starting = false;
        } else if (seen == power_seen::off or (seen == power_seen::waits and not own.is_starting)) {
            own.is_starting = false;
            own.is_ordered = false;
            own.misses = 0;
            own.answers_left = 0;
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
                leave(*own, own->on_line); // unless it enables the unit, too
            }
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

    constexpr void note_enabling(commander const& who, duration drive_timeout, std::uint8_t tolerated) noexcept
    {
        if (unit_order* const own = places_.make(who.whose_.byte())) {
            own->last_order = own->last_order == 0 ? who.stamp_ : own->last_order; // its place was lost meanwhile
            own->is_starting = own->is_starting or who.says_run_;
            // Else it was read for the order that is in force, and here it may not be.
            if (who.says_run_ or not own->is_ordered) {
                own->silence = drive_timeout + milliseconds(1'000);
            }
            own->heard = own->is_ordered ? own->heard : asked_;
            own->is_ordered = true;
            own->answers_left = 0;
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
    constexpr void note_stopping(commander& who, duration drive_timeout) noexcept
    {
        if (unit_order* const own = places_.find(who.whose_.byte())) {
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
        unit_order& own = place_of(who.whose_.byte());
        own.unit = who.whose_.byte(); // for the units without a place: which one is held
        own.last_stop = count_;
        own.holder = count_;
        own.held = hold::by_its_stop;
        own.words = stop_words::due;
        own.answers_left = 0;
    }

    /// A stop under way visits: a place that has become free goes to its unit, and where the stop of another unit
    /// without a place has ended, this one goes on holding.
    constexpr void keep_hold(commander const& who, instant now) noexcept
    {
        unit_order& own = place_of(who.whose_.byte());
        bool const is_back = own.held == hold::by_nobody and own.holder == who.stamp_;
        if (own.holder == 0 or own.held == hold::by_another_stop or is_back) {
            own.unit = who.whose_.byte();
            own.holder = who.stamp_;
            own.held = hold::by_its_stop;
            own.answers_left = 0;
        }
        if (own.holder == who.stamp_) {
            own.seen = step_of(now);
            own.passes_left = most_passes_missed;
        }
    }

    /// A stop has ended: ends its holds, also those of units that got their places since; and the hold of an earlier
    /// stop of this unit that was given up before the unit had a place. Orders given before no longer count.
    constexpr void end_stop(commander& who) noexcept
    {
        who.is_stopping_ = false;
        unit_order const& others = places_.others();
        std::uint32_t const given_up = others.unit == who.whose_.byte() ? others.holder : who.stamp_;
        end_hold(places_.others(), who.stamp_, given_up);
        for (unit_order& each : places_) {
            end_hold(each, who.stamp_, given_up);
        }
    }

    /// Whether another stop of the unit has begun since.
    [[nodiscard]] constexpr bool has_another_stop(commander const& who) const noexcept
    {
        unit_order const* const own = places_.find(who.whose_.byte());
        bool const stops_all = holder_of_all_ != 0 and who.stamp_ == holder_of_all_;
        return own != nullptr and own->holder != 0 and own->holder != who.stamp_ and
               own->held != hold::by_another_stop and own->held != hold::by_nobody and not stops_all;
    }

    /// Stops that ended release their units.
    constexpr void let_go_of_ended() noexcept
    {
        if (is_all_over_ and not is_all_shared_) { // else the other one holds from its next visit on
            holder_of_all_ = 0;
        }
        is_all_shared_ = false;
        let_go_if_over(places_.others());
        for (unit_order& each : places_) {
            let_go_if_over(each);
        }
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
        leave(own, own.on_line);
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

    // Losses.

    /// The unit may have lost its power where it was not heard for long. Behind its own time-out no order to run counts any
    /// more: where nothing was on the line to it for as long, it has stopped by itself; else a request may have reached it
    /// whose response did not come, and it may run on. `is_asked`: a request to it is under way; one that was taken within
    /// the last second left in time.
    [[gnu::noinline]] constexpr void heed_gap(unit_order& own, instant now, bool is_asked) noexcept
    {
        constexpr duration behind = milliseconds(1'000); // a clock may be, a little
        duration const gap = now + behind - own.heard;
        own.is_doubtful = own.is_doubtful or gap > longest_gap_in_presence + behind;
        if (not own.is_ordered or gap <= own.silence or (is_asked and now - asked_ <= behind)) {
            return;
        }
        own.confirmed = 0; // a read could let it run as ordered again
        if (own.last_order != 0 and not is_older(own.last_order, own.last_fault)) {
            own.last_fault = ++count_;
            leave(own, now);
        }
    }

    /// A stop that is given up before its end leaves a motor that nobody stops any more.
    constexpr void heed_absence(unit_order& own, bool is_all_left, instant now) noexcept
    {
        bool const is_held = own.holder != 0 and own.held == hold::by_its_stop;
        bool const is_over = own.is_ordered and now - own.on_line > own.silence; // it has stopped by itself
        if (is_held and (is_over or has_missed(own.passes_left, own.seen, now))) {
            own.held = hold::by_nobody;
            leave(own, now);
        }
        if (is_all_left and own.holder == 0) {
            leave(own, now);
        }
        own.answers_left = is_over ? std::uint8_t{0} : own.answers_left;
    }

    /// Nobody's order or stop holds an ordered unit any more. A commander that looks at it now may still see its power gone.
    /// One that was left before has no more answers.
    static constexpr void leave(unit_order& own, instant now) noexcept
    {
        bool const may_run = own.is_ordered and not own.is_lost and now - own.on_line <= own.silence;
        if (own.answers_left == 0) { // else it was left before
            own.answers_left = most_answers;
            own.looks = 0;
        }
        own.answers_left = may_run ? own.answers_left : std::uint8_t{0};
    }

    /// An answer of a unit that nobody holds: whether it was the last one.
    constexpr bool was_last_answer(unit_order& own) const noexcept
    {
        own.looks += is_by_commander_ ? look_of_a_commander : 1;
        return own.looks >= most_looks or (not is_by_commander_ and --own.answers_left == 0);
    }

    static constexpr std::uint16_t step_of(instant at) noexcept
    {
        return static_cast<std::uint16_t>(at.microseconds >> 16U);
    }

    /// A pass without a visit. True once: when the stop counts as given up.
    static constexpr bool has_missed(std::uint8_t& passes_left, std::uint16_t seen, instant now) noexcept
    {
        bool const is_short = static_cast<std::uint16_t>(step_of(now) - seen) < longest_absence;
        if (passes_left == 0 or (passes_left == 1 and is_short)) {
            return false;
        }
        return --passes_left == 0;
    }

    /// The units that no stop holds.
    constexpr void leave_all() noexcept
    {
        for (unit_order& each : places_) {
            if (each.holder == 0 and holder_of_all_ == 0) {
                leave(each, each.on_line);
            }
        }
    }

    constexpr void lose(unit_order& own, instant now) noexcept
    {
        own.confirmed = 0;
        own.answers_left = 0;
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

    std::uint32_t number_{0};        ///< of this client; 0: no commander has visited it, nor one that it is a copy of
    std::uint32_t count_{0};         ///< of all events, which are told apart by it
    std::uint32_t stopped_all_{0};   ///< the stamp of the last stop of all units
    std::uint32_t holder_of_all_{0}; ///< the same while it is under way; 0: none
    bool is_all_over_{false};
    bool is_all_shared_{false};       ///< another stop of all units visited since the last `advance`
    bool is_by_commander_{false};     ///< the last request
    std::uint8_t all_passes_left_{0}; ///< that the stop of all units may miss
    std::uint16_t all_seen_{0};       ///< when it visited last
    instant asked_{0};                ///< when the last request was taken, to any unit
    deadline wake_{};
    order_places<Units> places_;
};

} // namespace detail

} // namespace RTUWIRE_BUILD
} // namespace rtuwire
