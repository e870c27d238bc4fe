// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// What a client knows of each unit whose motor it commands, and of a stop of all of them; what each event makes of that; and
// the places where it is kept. The client tells it the events (client/orders.hpp, which has the law); a conversation that
// ordered a motor to run asks it whether that still counts. Events are ordered by stamps, which the client counts up.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include <rtuwire/core/bytes.hpp>
#include <rtuwire/core/time.hpp>
#include <rtuwire/core/version.hpp>

namespace rtuwire {
inline namespace RTUWIRE_BUILD {

namespace detail {

/// A drive that is silent for no longer was not switched off and on again meanwhile: assumed, no manual gives the time that
/// its control needs until it answers. What was read of a unit counts only as long as it has answered so.
inline constexpr duration longest_gap_in_presence = milliseconds(500);

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

/// What a status showed of a motor's power.
enum class power_seen : std::uint8_t {
    nothing, ///< no status was read, or it does not tell
    off,     ///< none, until an order to run
    waits,   ///< none, and one control word gives it: also where the drive follows such a word later
    on,
};

/// How the stop under way holds a unit.
enum class hold : std::uint8_t {
    by_its_stop,
    by_another_stop, ///< a stop whose unit had no place when this unit got one
    by_nobody,       ///< that stop was given up: it visits no more
    is_over,         ///< that stop has ended
};

/// Whether requests that stop a unit may still be sent while it is lost.
enum class stop_words : std::uint8_t {
    none,
    timed, ///< up to `words_end`
    due,   ///< a stop has begun, and has sent none yet: its time begins with the first one
};

/// Whether an event came before another one.
[[nodiscard]] constexpr bool is_older(std::uint32_t stamp, std::uint32_t than) noexcept
{
    return static_cast<std::int32_t>(stamp - than) < 0;
}

[[nodiscard]] constexpr std::uint32_t newer_of(std::uint32_t one, std::uint32_t other) noexcept
{
    return is_older(one, other) ? other : one;
}

/// When a stop visits, in steps of 65.5 ms.
[[nodiscard]] constexpr std::uint16_t step_of(instant at) noexcept
{
    return static_cast<std::uint16_t>(at.microseconds >> 16U);
}

/// A pass in which a stop did not visit. True once: when it counts as given up.
[[nodiscard]] constexpr bool has_missed(std::uint8_t& passes_left, std::uint16_t seen, instant now) noexcept
{
    bool const is_short = static_cast<std::uint16_t>(step_of(now) - seen) < longest_absence;
    if (passes_left == 0 or (passes_left == 1 and is_short)) {
        return false;
    }
    return --passes_left == 0;
}

/// Its marks and times.
struct unit_marks {
    // Small processors reach bytes with short instructions only where they are near.
    std::uint8_t unit{0}; ///< 0: a free place
    bool is_ordered{false};
    bool is_starting{false}; ///< the command to run was sent; neither seen with power nor told to stop since
    bool is_doubtful{false}; ///< it may have been without power since `confirmed` was read
    bool is_lost{false};
    bool was_lost{false};   ///< the last stop was a loss
    std::uint8_t misses{0}; ///< missing responses in a row
    std::uint8_t tolerated{0};
    std::uint8_t answers_left{
        0}; ///< not 0: its motor may run, and no order or stop is in force; lost after so many answers
    std::uint8_t passes_left{0}; ///< that the stop under way may miss before it counts as given up
    stop_words words{stop_words::none};
    hold held{hold::by_its_stop};
    std::uint16_t confirmed{0}; ///< the control word that was read to be that of the drive profile; 0: none
    std::uint16_t seen{0};      ///< when the stop under way visited last
    instant words_end{0};
    instant silence_end{0};
    instant heard{0};   ///< when the last request was made that it answered
    instant on_line{0}; ///< when a request to it may have been on the line
    duration silence{};
};

/// Its stamps.
struct unit_stamps {
    std::uint32_t last_stop{0};  ///< the stamp of the last stop or loss
    std::uint32_t last_order{0}; ///< of the last order to run; 0: none
    std::uint32_t last_fault{0}; ///< of the last time that it was read in fault, or of the last stop of all units
    std::uint32_t rearranged{0}; ///< of the last request that rearranged it
    std::uint32_t holder{0};     ///< of the stop under way; 0: none
    std::uint32_t looks{0};      ///< all answers since it was left or told to stop, one to a commander being several
};

/// What is known of one unit. All zero where nothing is known, so that a `constinit` client lives in .bss; the times
/// are written before they are read.
struct unit_order : unit_marks, unit_stamps {
    // Its orders.

    /// Whether another order to run came later than one of this stamp.
    [[nodiscard]] constexpr bool is_replaced(std::uint32_t order) const noexcept
    {
        return last_order != 0 and is_older(order, last_order);
    }

    /// Whether a fault, or another order to run, came later.
    [[nodiscard]] constexpr bool has_newer(std::uint32_t order) const noexcept
    {
        return is_replaced(order) or is_older(order, last_fault);
    }

    /// Whether it was a loss, and no stop, that withdrew its orders.
    [[nodiscard]] constexpr bool is_by_loss() const noexcept { return was_lost and holder == 0; }

    /// A stop withdraws all orders that were given before.
    constexpr void withdraw(std::uint32_t stop) noexcept
    {
        last_stop = stop;
        was_lost = false;
    }

    /// A request that enables it was taken.
    constexpr void note_enabling(bool says_run, duration drive_timeout, std::uint8_t most_missed,
                                 instant asked) noexcept
    {
        is_starting = is_starting or says_run;
        // Else it was read for the order that is in force, and here it may not be.
        if (says_run or not is_ordered) {
            silence = drive_timeout + milliseconds(1'000);
        }
        heard = is_ordered ? heard : asked;
        is_ordered = true;
        answers_left = 0;
        tolerated = most_missed;
    }

    /// A drive that may follow its order later, as one that closes a contactor first, is not at rest where it waits.
    constexpr void note_power(power_seen power) noexcept
    {
        if (power == power_seen::on) {
            is_starting = false;
        } else if (power == power_seen::off or (power == power_seen::waits and not is_starting)) {
            is_starting = false;
            is_ordered = false;
            misses = 0;
            answers_left = 0;
        }
    }

    /// It has answered a request that was made at `asked`; one may have been on the line until `until`.
    constexpr void note_answer(instant asked, instant until) noexcept
    {
        heard = asked;
        on_line = until;
        misses = 0;
    }

    // The stop that holds it.

    /// A stop of `whose` begins to hold it, or goes on: the entry of the units without a place tells which one is held.
    constexpr void take_hold(std::uint8_t whose, std::uint32_t stop) noexcept
    {
        unit = whose;
        holder = stop;
        held = hold::by_its_stop;
        answers_left = 0;
    }

    /// A stop under way visits: a place that has become free goes to its unit, and where the stop of another unit without a
    /// place has ended, this one goes on holding.
    constexpr void keep_hold(std::uint8_t whose, std::uint32_t stop, instant now) noexcept
    {
        bool const is_back = held == hold::by_nobody and holder == stop;
        if (holder == 0 or held == hold::by_another_stop or is_back) {
            take_hold(whose, stop);
        }
        if (holder == stop) {
            seen = step_of(now);
            passes_left = most_passes_missed;
        }
    }

    /// Whether another stop than this one holds it, and goes on.
    [[nodiscard]] constexpr bool is_held_by_another(std::uint32_t stop) const noexcept
    {
        return holder != 0 and holder != stop and held != hold::by_another_stop and held != hold::by_nobody;
    }

    /// A stop has ended, and with it one that was given up. The hold lasts until `let_go_if_over`.
    [[gnu::noinline]] constexpr void end_stop(std::uint32_t stop, std::uint32_t given_up, std::uint32_t& count) noexcept
    {
        if (holder != 0 and (holder == stop or holder == given_up)) {
            held = hold::is_over;
            withdraw(++count);
        }
    }
    constexpr void let_go_if_over() noexcept
    {
        if (held == hold::is_over) {
            holder = 0;
            held = hold::by_its_stop;
        }
    }

    /// The hold of a stop that was given up is released.
    constexpr void let_go(std::uint32_t& count) noexcept
    {
        if (holder == 0) {
            return;
        }
        holder = 0;
        held = hold::by_its_stop;
        withdraw(++count);
        leave(on_line);
    }

    // Nobody holds it.

    /// Nobody's order or stop holds an ordered unit any more. A commander that looks at it now may still see its power gone.
    /// One that was left before has no more answers.
    constexpr void leave(instant now) noexcept
    {
        bool const may_run = is_ordered and not is_lost and now - on_line <= silence;
        if (answers_left == 0) { // else it was left before
            answers_left = most_answers;
            looks = 0;
        }
        answers_left = may_run ? answers_left : std::uint8_t{0};
    }

    /// It has answered while nobody holds it. Returns whether that was the last answer.
    constexpr bool was_last_answer(bool is_to_commander) noexcept
    {
        looks += is_to_commander ? look_of_a_commander : 1;
        return looks >= most_looks or (not is_to_commander and --answers_left == 0);
    }

    /// A stop that is given up before its end leaves a motor that nobody stops any more; a stop of all units, all that none
    /// of their own holds.
    constexpr void heed_absence(bool is_all_left, instant now) noexcept
    {
        bool const is_held = holder != 0 and held == hold::by_its_stop;
        bool const is_over = is_ordered and now - on_line > silence; // it has stopped by itself
        if (is_held and (is_over or has_missed(passes_left, seen, now))) {
            held = hold::by_nobody;
            leave(now);
        }
        if (is_all_left and holder == 0) {
            leave(now);
        }
        answers_left = is_over ? std::uint8_t{0} : answers_left;
    }

    /// It may have lost its power where it was not heard for long. Behind its own time-out no order to run counts any more, and
    /// true is returned: where nothing was on the line to it for as long, it has stopped by itself; else a request may have
    /// reached it whose response did not come, and it may run on. `is_asked`: a request to it is under way; one that was taken,
    /// at `asked`, within the last second left in time.
    constexpr bool heed_gap(instant now, bool is_asked, instant asked) noexcept
    {
        constexpr duration behind = milliseconds(1'000); // a clock may be, a little
        duration const gap = now + behind - heard;
        is_doubtful = is_doubtful or gap > longest_gap_in_presence + behind;
        if (not is_ordered or gap <= silence or (is_asked and now - asked <= behind)) {
            return false;
        }
        confirmed = 0; // a read could let it run as ordered again
        return last_order != 0 and not is_older(last_order, last_fault);
    }

    // Losses.

    constexpr void lose(instant now, std::uint32_t& count) noexcept
    {
        confirmed = 0;
        answers_left = 0;
        if (not is_lost) {
            is_lost = true;
            was_lost = true;
            if (words != stop_words::due) {
                time_words(now);
            }
            last_stop = ++count;
        }
        silence_end = now + silence;
    }

    /// From now on stop requests may be sent for their time.
    constexpr void time_words(instant now) noexcept
    {
        words = stop_words::timed;
        words_end = now + stop_words_after_loss;
    }

    /// Ends the times that are over. Returns whether its silence is.
    constexpr bool end_silence(instant now) noexcept
    {
        if (words == stop_words::timed and reached(now, words_end)) {
            words = stop_words::none;
        }
        if (not is_lost or not reached(now, silence_end)) {
            return false;
        }
        is_lost = false;
        return true;
    }
};
inline constexpr unit_order nothing_known{};

/// How many of `Size` places are in use, so that nobody looks at the others. The only place of one counts as used, which takes
/// no memory.
template <std::size_t Size> class used_places {
public:
    [[nodiscard]] constexpr std::size_t count() const noexcept { return count_; }
    constexpr void set(std::size_t count) noexcept { count_ = count; }

private:
    std::size_t count_{0};
};
template <> class used_places<1> {
public:
    [[nodiscard]] static constexpr std::size_t count() noexcept { return 1; }
    static constexpr void set(std::size_t) noexcept {}
};

/// Places for `Units` units, and one entry for all others together.
template <std::size_t Units> class order_places {
public:
    /// The unit's place; null where it has none.
    [[nodiscard]] constexpr unit_order* find(std::uint8_t unit) noexcept
    {
        std::size_t const at = index_of(unit);
        return at < Units ? &places_[at] : nullptr;
    }
    [[nodiscard]] constexpr unit_order const* find(std::uint8_t unit) const noexcept
    {
        std::size_t const at = index_of(unit);
        return at < Units ? &places_[at] : nullptr;
    }

    /// The same, or the entry of all units without a place: the latest stamp of each kind.
    [[nodiscard]] constexpr unit_order const& of(std::uint8_t unit) const noexcept
    {
        unit_order const* const own = find(unit);
        return own == nullptr ? others_ : *own;
    }
    [[nodiscard]] constexpr unit_order& entry_of(std::uint8_t unit) noexcept
    {
        unit_order* const own = find(unit);
        return own == nullptr ? others_ : *own;
    }
    [[nodiscard]] constexpr unit_order& others() noexcept { return others_; }

    /// Whether a unit, whose entry this is, neither has a place nor can get one.
    [[nodiscard]] constexpr bool is_full_for(unit_order const& entry) const noexcept
    {
        return &entry == &others_ and free_place() == Units;
    }

    /// The unit's place, or a new one; null where there is none.
    [[nodiscard]] constexpr unit_order* make(std::uint8_t unit) noexcept
    {
        if (unit_order* const own = find(unit)) {
            return own;
        }
        std::size_t const at = free_place();
        if (at == Units) {
            return nullptr;
        }
        used_.set(Units - at > used_.count() ? Units - at : used_.count());
        unit_order& own = places_[at];
        forget(own);
        static_cast<unit_marks&>(own) = others_; // in two parts: for the whole GCC calls memcpy
        static_cast<unit_stamps&>(own) = others_;
        own.unit = unit;
        own.held = others_.held == hold::by_its_stop ? hold::by_another_stop : others_.held;
        return &own;
    }

    /// The same, or the entry of all units without a place.
    [[nodiscard]] constexpr unit_order& make_entry(std::uint8_t unit) noexcept
    {
        unit_order* const own = make(unit);
        return own == nullptr ? others_ : *own;
    }

    /// Those that were ever in use.
    [[nodiscard]] constexpr auto begin() noexcept { return places_.begin() + first_used(); }
    [[nodiscard]] constexpr auto end() noexcept { return places_.end(); }
    [[nodiscard]] constexpr auto begin() const noexcept { return places_.begin() + first_used(); }
    [[nodiscard]] constexpr auto end() const noexcept { return places_.end(); }

private:
    /// They are taken into use from the last one on.
    constexpr std::ptrdiff_t first_used() const noexcept { return static_cast<std::ptrdiff_t>(Units - used_.count()); }

    constexpr std::size_t index_of(std::uint8_t unit) const noexcept
    {
        std::size_t at = Units - used_.count();
        while (at < Units and (places_[at].unit != unit or unit == 0)) {
            ++at;
        }
        return at;
    }

    /// A place that is free, or whose unit is neither ordered, held nor lost; `Units` where there is none.
    constexpr std::size_t free_place() const noexcept
    {
        std::size_t const first = Units - used_.count();
        if (first != 0) {
            return first - 1;
        }
        std::size_t found = Units;
        for (std::size_t i = Units; i-- > 0;) {
            unit_order const& each = places_[i];
            if (each.unit == 0) {
                return i;
            }
            found = each.is_ordered or each.is_lost or each.holder != 0 ? found : i;
        }
        return found;
    }

    /// Of a unit that loses its place only the stamps are kept; they count for all units without a place.
    constexpr void forget(unit_order const& known) noexcept
    {
        others_.last_stop = newer_of(others_.last_stop, known.last_stop);
        others_.last_fault = newer_of(others_.last_fault, known.last_fault);
        others_.rearranged = newer_of(others_.rearranged, known.rearranged);
    }

    std::array<unit_order, Units> places_{filled<Units>(nothing_known)};
    unit_order others_{nothing_known};
    [[no_unique_address]] used_places<Units> used_{};
};

/// The stop of all units that is under way: it holds all that no stop of their own holds.
class stop_of_all {
public:
    /// Its stamp; 0: there is none.
    [[nodiscard]] constexpr std::uint32_t stamp() const noexcept { return stamp_; }

    constexpr void begin(std::uint32_t stamp) noexcept
    {
        stamp_ = stamp;
        is_over_ = false; // if another one has just ended
    }

    /// It visits, or another one does. One of which the hold was released, or that outlives another one, takes it.
    constexpr void keep(std::uint32_t stamp, instant now) noexcept
    {
        if (stamp_ == 0 or is_over_) {
            begin(stamp);
        }
        is_shared_ = is_shared_ or stamp != stamp_;
        seen_ = step_of(now);
        passes_left_ = most_passes_missed;
    }

    /// It has ended. Its hold lasts until `let_go_if_over`.
    constexpr void end() noexcept { is_over_ = true; }
    constexpr void let_go_if_over() noexcept
    {
        if (is_over_ and not is_shared_) { // else the other one holds from its next visit on
            stamp_ = 0;
        }
        is_shared_ = false;
    }
    constexpr void let_go() noexcept { stamp_ = 0; }

    /// A pass, in which it may not have visited. True once: when it counts as given up.
    [[nodiscard]] constexpr bool has_missed(instant now) noexcept
    {
        return stamp_ != 0 and detail::has_missed(passes_left_, seen_, now);
    }

private:
    std::uint32_t stamp_{0};
    bool is_over_{false};
    bool is_shared_{false};       ///< another stop of all units visited since the last `let_go_if_over`
    std::uint8_t passes_left_{0}; ///< that it may miss
    std::uint16_t seen_{0};       ///< when it visited last
};

} // namespace detail

} // namespace RTUWIRE_BUILD
} // namespace rtuwire
