// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// Which motors a client ordered to run, and what follows from it for everything that is said to their units. No
// conversation could hold to this alone: a read by another one keeps a drive's watchdog fed.
//
// A unit is *ordered* from the first request that enables it until a conversation that commands it has read that its
// motor has no power. Orders and stops have stamps, counted up: an order that is older than the last stop of its
// unit, or than its last loss, enables nothing. While a stop is under way nothing else commands its unit; one that was
// destroyed before its end goes on holding it until another stop of the unit has ended, or `release`.
//
// A *loss* is an answer that did not come from an ordered unit, beyond those that its commander tolerates. Then, for
// 2 s at most, only words that stop it go to that unit. Then nothing does, from anybody, until the drive's own time-out
// and 1 s more have gone by since the last of them: it has stopped by itself if it can. A stop that begins meanwhile has
// 2 s for its words. An answer to one of them ends the loss; the order stays gone.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include <rtuwire/client/commander.hpp>
#include <rtuwire/core/filled.hpp>
#include <rtuwire/core/time.hpp>
#include <rtuwire/core/version.hpp>
#include <rtuwire/wire/errc.hpp>

namespace rtuwire::inline RTUWIRE_BUILD {

/// For a client that commands no motor.
struct no_orders {
    static constexpr bool is_kept = false;
    static constexpr bool advance(instant) noexcept { return false; }
    static constexpr bool is_silent(std::uint8_t, effect) noexcept { return false; }
    static constexpr bool is_lost(std::uint8_t) noexcept { return false; }
    static constexpr void note_outcome(std::uint8_t, errc, bool, instant) noexcept {}
    static constexpr void add_to(earliest&) noexcept {}
};

/// How long words that stop may follow a loss, or a stop that begins behind it.
inline constexpr duration stop_words_after_loss = milliseconds(2'000);

/// The orders of up to `Units` units at once.
template <std::size_t Units> class orders {
public:
    static constexpr bool is_kept = true;

    /// A commander of one unit comes by: takes note of what its user wants, and of what it read. Whether its unit was lost
    /// since it came by last.
    constexpr bool visit(commander& who, std::uint8_t unit, instant now) noexcept
    {
        bool const is_lost = has_lost(who, unit);
        note_arrangement(who, unit);
        take_notes(who, unit, now);
        return is_lost;
    }

    /// The same for a commander that stops every unit.
    constexpr void visit_for_all(commander& who, instant now) noexcept
    {
        if (who.has_stopped_) {
            who.has_stopped_ = false;
            who.stamp_ = ++count_;
            stopped_all_ = count_;
            holder_of_all_ = count_;
            for (entry& each : entries_) {
                each.words_end = now + stop_words_after_loss;
                each.may_be_told = each.is_lost;
            }
        }
        if (who.is_over_) {
            who.is_over_ = false;
            is_all_over_ = who.stamp_ == holder_of_all_;
        }
    }

    /// Whether a request of this effect may be asked, but for silence: `overruled` where a stop came later than the
    /// order, or another stop is under way; `unit_lost` where a loss did; `too_many_ordered` where there is no place for
    /// one more unit.
    [[nodiscard]] constexpr errc check(commander const& who, std::uint8_t unit,
                                       effect what) const noexcept
    {
        if (what == effect::none) {
            return errc::none;
        }
        entry const* const own = find(unit);
        std::uint32_t const holder = own == nullptr ? 0 : own->holder;
        bool const is_others = holder != 0 and who.stamp_ != holder;
        if (what == effect::stopping) {
            bool const stops_all = holder_of_all_ != 0 and who.stamp_ == holder_of_all_;
            return is_others and not stops_all ? errc::overruled : errc::none;
        }
        std::uint32_t const last = own == nullptr ? forgotten_ : own->last_stop;
        std::uint32_t const fault = own == nullptr ? forgotten_fault_ : own->last_fault;
        bool const is_late = is_older(who.stamp_, last) or is_older(who.stamp_, stopped_all_) or
                             (what == effect::enabling and is_older(who.stamp_, fault));
        if (holder != 0 or holder_of_all_ != 0 or is_late) {
            bool const is_loss = own != nullptr and own->was_lost and holder == 0;
            return is_loss ? errc::unit_lost : errc::overruled;
        }
        bool const is_full = own == nullptr and free_place() == Units;
        return is_full and what != effect::rearranging ? errc::too_many_ordered : errc::none;
    }

    /// A request that rearranges was taken: who relies on the unit's words reads anew what they mean.
    constexpr void note_rearranging(std::uint8_t unit) noexcept
    {
        entry* const own = find(unit);
        (own == nullptr ? forgotten_arrangement_ : own->rearranged) = ++count_;
    }

    /// Whether another stop, or one that came later, has the unit.
    [[nodiscard]] constexpr bool is_overruled(commander const& who, std::uint8_t unit) const noexcept
    {
        entry const* const own = find(unit);
        bool const holds = own != nullptr and own->holder != 0 and own->holder == who.stamp_;
        return not holds and check(who, unit, effect::enabling) == errc::overruled;
    }

    /// A request that enables was taken.
    constexpr void note_enabling(std::uint8_t unit, duration drive_timeout,
                                 std::uint8_t tolerated) noexcept
    {
        if (entry* const own = place_of(unit)) {
            own->is_ordered = true;
            own->silence = drive_timeout + milliseconds(1'000);
            own->tolerated = tolerated;
        }
    }

    /// What came of a request to a unit, whoever asked it; one that its client repeated by itself is tolerated no more.
    constexpr void note_outcome(std::uint8_t unit, errc error, bool was_repeated,
                                instant now) noexcept
    {
        entry* const own = find(unit);
        if (own == nullptr or error == errc::cancelled) {
            return;
        }
        if (error == errc::none or is_exception(error)) {
            own->misses = 0;
            own->is_lost = false;
            return;
        }
        if (not own->is_ordered) {
            return;
        }
        if (own->is_lost or was_repeated or own->misses >= own->tolerated) {
            lose(*own, now);
        } else {
            ++own->misses;
        }
    }

    /// Whether nothing of this effect is said to a unit now; to everyone (0), where one of them is lost.
    [[nodiscard]] constexpr bool is_silent(std::uint8_t unit, effect what) const noexcept
    {
        for (entry const& each : entries_) {
            bool const is_meant = each.is_lost and (each.unit == unit or unit == 0);
            bool const may_be_told =
                what == effect::stopping and (unit == 0 or each.may_be_told);
            if (is_meant and not may_be_told) {
                return true;
            }
        }
        return false;
    }

    /// Whether a unit is lost.
    [[nodiscard]] constexpr bool is_lost(std::uint8_t unit) const noexcept
    {
        entry const* const own = find(unit);
        return own != nullptr and own->is_lost;
    }

    /// Whether this client ordered a unit to run, and nobody has read since that it does not.
    [[nodiscard]] constexpr bool is_ordered(std::uint8_t unit) const noexcept
    {
        entry const* const own = find(unit);
        return own != nullptr and own->is_ordered;
    }

    /// Lets a unit be commanded again that a stop holds which was given up.
    constexpr void release(std::uint8_t unit) noexcept
    {
        if (entry* const own = find(unit)) {
            own->holder = 0;
            own->is_stop_over = false;
            own->last_stop = ++count_;
            own->was_lost = false;
        }
    }

    /// Lets time pass. Whether a silence is over. Stops that ended release their units here, so that no order counts that
    /// was given before.
    constexpr bool advance(instant now) noexcept
    {
        if (is_all_over_) {
            is_all_over_ = false;
            holder_of_all_ = 0;
            stopped_all_ = ++count_;
        }
        bool is_over = false;
        for (entry& each : entries_) {
            if (each.is_stop_over) {
                release(each.unit);
            }
            each.may_be_told = each.is_lost and each.may_be_told and not reached(now, each.words_end);
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
        for (entry const& each : entries_) {
            if (each.is_lost) {
                next.add(each.may_be_told ? each.words_end : each.silence_end);
            }
        }
    }

private:
    struct entry {
        instant words_end;
        instant silence_end;
        duration silence;
        std::uint32_t last_stop; ///< the stamp of the last stop or loss
        std::uint32_t holder;    ///< the stamp of the stop under way; 0: none
        std::uint32_t last_fault; ///< the stamp of the last time that it was read to be in fault
        std::uint32_t rearranged; ///< the stamp of the last request that did so
        std::uint8_t unit;       ///< 0: a free place
        std::uint8_t misses;     ///< in a row
        std::uint8_t tolerated;
        bool is_ordered;
        bool is_lost;
        bool is_stop_over; ///< the stop under way has ended
        bool was_lost;    ///< the last stop was a loss
        bool may_be_told; ///< while it is lost: words that stop it may go
    };

    static constexpr bool is_older(std::uint32_t stamp, std::uint32_t than) noexcept
    {
        return static_cast<std::int32_t>(stamp - than) < 0;
    }

    static constexpr std::uint32_t later(std::uint32_t one, std::uint32_t other) noexcept
    {
        return is_older(one, other) ? other : one;
    }

    constexpr void take_notes(commander& who, std::uint8_t unit, instant now) noexcept
    {
        if (who.has_read_rest_) {
            who.has_read_rest_ = false;
            if (entry* const own = find(unit)) {
                own->is_ordered = false;
                own->misses = 0;
            }
        }
        if (who.has_read_fault_) {
            who.has_read_fault_ = false;
            entry* const own = place_of(unit);
            (own == nullptr ? forgotten_fault_ : own->last_fault) = ++count_;
        }
        if (who.has_ordered_) {
            who.has_ordered_ = false;
            who.stamp_ = ++count_;
        }
        if (who.has_stopped_) {
            who.has_stopped_ = false;
            begin_stop(who, unit, now);
        }
        if (who.is_over_) {
            who.is_over_ = false;
            end_stop(who, unit);
        }
    }

    constexpr bool has_lost(commander const& who, std::uint8_t unit) const noexcept
    {
        entry const* const own = find(unit);
        return own != nullptr and own->is_lost and is_older(who.seen_, own->last_stop);
    }

    constexpr void note_arrangement(commander& who, std::uint8_t unit) const noexcept
    {
        entry const* const own = find(unit);
        std::uint32_t const last = own == nullptr ? forgotten_arrangement_ : own->rearranged;
        who.was_rearranged_ = who.was_rearranged_ or is_older(who.seen_, last);
        who.seen_ = count_;
    }

    constexpr void begin_stop(commander& who, std::uint8_t unit, instant now) noexcept
    {
        who.stamp_ = ++count_;
        if (entry* const own = place_of(unit)) {
            own->last_stop = count_;
            own->was_lost = false;
            own->holder = count_;
            own->is_stop_over = false;
            own->words_end = now + stop_words_after_loss;
            own->may_be_told = own->is_lost;
        }
    }

    constexpr void end_stop(commander const& who, std::uint8_t unit) noexcept
    {
        entry* const own = find(unit);
        if (own != nullptr and own->holder == who.stamp_) {
            own->is_stop_over = true;
        }
    }

    constexpr void lose(entry& own, instant now) noexcept
    {
        if (not own.is_lost) {
            own.is_lost = true;
            own.may_be_told = true;
            own.was_lost = true;
            own.words_end = now + stop_words_after_loss;
            own.last_stop = ++count_;
        }
        own.silence_end = now + own.silence;
    }

    constexpr entry const* find(std::uint8_t unit) const noexcept
    {
        for (entry const& each : entries_) {
            if (each.unit == unit and unit != 0) {
                return &each;
            }
        }
        return nullptr;
    }
    constexpr entry* find(std::uint8_t unit) noexcept
    {
        for (entry& each : entries_) {
            if (each.unit == unit and unit != 0) {
                return &each;
            }
        }
        return nullptr;
    }

    /// A place that is free, or whose unit is neither ordered nor held; `Units` where there is none.
    constexpr std::size_t free_place() const noexcept
    {
        std::size_t found = Units;
        for (std::size_t i = Units; i-- > 0;) {
            entry const& each = entries_[i];
            if (each.unit == 0) {
                return i;
            }
            found = each.is_ordered or each.holder != 0 ? found : i;
        }
        return found;
    }

    /// The unit's own place, or one for it; null where there is none.
    constexpr entry* place_of(std::uint8_t unit) noexcept
    {
        if (entry* const own = find(unit)) {
            return own;
        }
        std::size_t const at = free_place();
        if (at == Units) {
            return nullptr;
        }
        entry& own = entries_[at];
        // Of a unit that loses its place only this is kept; it counts for all that have none.
        forgotten_ = later(forgotten_, own.last_stop);
        forgotten_fault_ = later(forgotten_fault_, own.last_fault);
        forgotten_arrangement_ = later(forgotten_arrangement_, own.rearranged);
        own = nothing;
        own.unit = unit;
        own.last_stop = forgotten_;
        own.last_fault = forgotten_fault_;
        own.rearranged = forgotten_arrangement_;
        return &own;
    }

    /// All zero, so that a `constinit` client needs no flash; `silence` is written before it is read.
    static constexpr entry nothing{instant{0}, instant{0}, duration{}, 0, 0, 0, 0, 0,
                                   0,          0,          false,      false, false, false, false};

    std::array<entry, Units> entries_{filled<Units>(nothing)};
    std::uint32_t count_{0};
    std::uint32_t stopped_all_{0};   ///< the stamp of the last stop of all units
    std::uint32_t holder_of_all_{0}; ///< the same while it is under way; 0: none
    std::uint32_t forgotten_{0};     ///< of units that have no place
    std::uint32_t forgotten_fault_{0};
    std::uint32_t forgotten_arrangement_{0};
    bool is_all_over_{false};
};

} // namespace rtuwire
