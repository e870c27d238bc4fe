// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// Which conversation asked last, and which may ask next: stops first, and others in the order in which they visit
// (`converse` is called for them), beginning after the one that was served last. Knows a conversation by the number that it holds; compares no
// addresses, so that a conversation may be destroyed, moved, or made anew in the same place. So may a client (`emplace` of
// an optional, a local object of a function that is called again), which its conversations may outlive: each counts from
// another number.
#pragma once

#include <cstdint>
#include <type_traits>

#include <rtuwire/ask/conversation.hpp>
#include <rtuwire/core/time.hpp>
#include <rtuwire/core/version.hpp>

namespace rtuwire {
inline namespace RTUWIRE_BUILD {

namespace detail {

/// Another number for each client, never 0. Two clients that two tasks make at once may get the same where a processor has
/// no operation for it; they are in two places then.
[[nodiscard]] inline std::uint32_t next_client_number() noexcept
{
    static constinit std::uint32_t given{0};
#ifdef __GCC_HAVE_SYNC_COMPARE_AND_SWAP_4
    std::uint32_t const number = __atomic_add_fetch(&given, 1, __ATOMIC_RELAXED);
#else
    std::uint32_t const number = ++given;
#endif
    return number == 0 ? 1 : number;
}

/// The standing of a conversation that visits where another has asked or others wait.
enum class standing : std::uint8_t {
    waits,
    is_next, ///< waits, and its turn comes before that of all others that wait
    is_last, ///< asked last
};

/// What came of a conversation's turn.
enum class turn_result : std::uint8_t {
    asked,  ///< its request was taken
    waits,  ///< it is not its turn
    passed, ///< it has no request now, its unit is held, or its request was refused
};

/// The turns on one line.
class turns {
public:
    /// A client that is made at run time, a copy as well, may stand in the place of another one: it counts from another number.
    constexpr turns() noexcept : number_{std::is_constant_evaluated() ? 0 : first_number()} {}
    constexpr turns(turns const&) noexcept : turns{} {}

    /// A client that is set up anew in its place, for another speed, continues the count: otherwise a conversation
    /// that asked the one before would take another's outcome for its own.
    constexpr turns& operator=(turns const&) noexcept
    {
        number_ += asker::step;
        mark_ = 0;
        others_wait_ = false;
        is_missed_ = false;
        return *this;
    }

    /// A conversation asks, and gets this line's next number; or the one that asked last gets another number. All
    /// marks given so far are void.
    [[gnu::noinline]] constexpr void renew(asker& who) noexcept
    {
        is_missed_ = false;
        number_ += asker::step;
        give(who, number_);
    }

    /// Voids the marks where the conversation that asked last is not at hand.
    constexpr void void_marks() noexcept
    {
        mark_ = static_cast<std::uint8_t>((mark_ + mark_step) & (marks_begin - mark_step));
    }

    /// Whether it was this conversation that asked last.
    [[nodiscard]] constexpr bool is_own(asker const& who) const noexcept
    {
        return who.ticket_ == number_ and who.turns_ == this;
    }

    /// The same, also where it has given up its request.
    [[nodiscard]] constexpr bool is_last(asker const& who) const noexcept
    {
        return who.ticket_ - number_ <= asker::given_up and who.turns_ == this;
    }

    /// A conversation visits. One that had ended before, and has no request under way, is used already, unless
    /// it never visited before: then nobody could read yet how it ended.
    constexpr void meet(asker& who, bool has_ended) const noexcept
    {
        if (has_ended != who.is_used_already() or who.turns_ == nullptr) {
            greet(who, has_ended);
        }
    }

    /// Whether the request of this conversation was dropped because it did not visit: another has asked since, or
    /// nothing is under way. Reported once.
    constexpr bool was_dropped(asker& who, bool is_idle) const noexcept
    {
        bool const is_lost =
            who.turns_ == this and who.ticket_ % asker::step == 0 and (is_idle or who.ticket_ != number_);
        if (is_lost) {
            who.forget();
        }
        return is_lost;
    }

    /// Conversations other than the one that asked last wait for their turn.
    constexpr void note_waiting() noexcept { others_wait_ = true; }
    [[nodiscard]] constexpr bool others_wait() const noexcept { return others_wait_; }

    /// Marks a conversation that visits and may have to wait. The next in turn is the first that visits twice, beginning after
    /// the one that asked, so that one that is gone in the next pass is never the next. It stays the next while it
    /// visits; otherwise the first that visits twice meanwhile is next. A function of its own, which is smaller.
    constexpr standing mark(asker& who) noexcept
    {
        if (is_last(who)) {
            return standing::is_last;
        }
        others_wait_ = true;
        standing place = standing::waits;
        if (who.ticket_ == next_mark() and who.turns_ == this) {
            void_marks();
            place = standing::is_next;
        }
        give(who, next_mark());
        return place;
    }

    /// The next in turn finds the one that asked missing. Returns whether it does for the second time: the other one
    /// then had its chance in between.
    constexpr bool misses_asker() noexcept
    {
        bool const is_second = is_missed_;
        is_missed_ = true;
        return is_second;
    }

    /// A conversation that comes before all others visits, and may not ask yet: all other marks are void.
    constexpr void put_first(asker& who) noexcept
    {
        void_marks();
        if (not is_last(who)) {
            give(who, next_mark()); // its own number stays valid
        }
    }

    /// Whether a conversation of this standing may ask now, where the line is free and others wait. The visit of the
    /// one that was served last opens the turn for those that visit after it; where it does not visit, the turn is
    /// that of the next.
    constexpr bool opens_turn(standing at) noexcept
    {
        others_wait_ = at == standing::waits;
        return at == standing::is_next;
    }

private:
    /// A function of its own: few visits need it.
    [[gnu::noinline]] constexpr void greet(asker& who, bool has_ended) const noexcept
    {
        if (who.turns_ == nullptr) {
            give(who, asker::met);
        } else if (who.ticket_ % asker::step != 0) { // else its request is under way, here or on another line
            who.ticket_ = (who.ticket_ | asker::given_up) - (has_ended ? 1U : 0U);
        }
    }

    constexpr void give(asker& who, std::uint32_t number) const noexcept
    {
        who.ticket_ = number;
        who.turns_ = this;
    }

    /// A number that `asker::forget` does not change.
    constexpr std::uint32_t next_mark() const noexcept { return number_ + marks_begin + mark_ + (mark_step - 1U); }

    /// Scattered: two of a thousand clients lie 80 000 requests apart or more.
    static std::uint32_t first_number() noexcept
    {
        constexpr std::uint32_t golden_section = 0x9E37'79B1;
        return next_client_number() * golden_section * asker::step;
    }

    static constexpr std::uint8_t mark_step = 4;
    static constexpr std::uint8_t marks_begin = asker::step / 2; ///< behind a number; as far again to the next one

    std::uint32_t number_; ///< of a request, in steps; a number behind it marks a visit since
    std::uint8_t mark_{0};
    bool others_wait_{false};
    bool is_missed_{false};
};

/// The line reserved for a conversation that comes before all others, a stop: no other asks before it. It is known by the
/// unit that it stops: of several that stop one unit, any does.
class reservation {
public:
    static constexpr bool is_kept = true;

    constexpr reservation() noexcept = default;
    constexpr reservation(reservation const&) noexcept = default;

    /// A client that is set up anew in its place is reserved for nobody: see `turns`.
    constexpr reservation& operator=(reservation const&) noexcept
    {
        end();
        return *this;
    }

    constexpr void begin(turns& line, asker& who, std::uint8_t unit) noexcept
    {
        state_ = state::reserved;
        unit_ = unit;
        line.put_first(who);
    }
    /// A stop asks now.
    constexpr void use() noexcept { state_ = state::used; }
    /// Another conversation may ask now.
    constexpr void end() noexcept { state_ = state::none; }

    [[nodiscard]] constexpr bool is_on() const noexcept { return state_ >= state::reserved; }
    /// Whether a stop of another unit comes first; 0 stands for all units.
    [[nodiscard]] constexpr bool is_for_another(std::uint8_t unit) const noexcept { return is_on() and unit_ != unit; }
    /// Whether a request under way that has not left yet is a stop's: where the line is reserved, all others left or were
    /// given up.
    [[nodiscard]] constexpr bool is_for_stops() const noexcept { return state_ != state::none; }

    /// Another conversation visits while the line is reserved. Returns whether it does for the second time since the
    /// last visit of the reserving one: that one is gone.
    constexpr bool misses_owner(turns& line, asker& who) noexcept
    {
        standing const at = line.mark(who);
        bool const is_gone = at == standing::is_next or (at == standing::is_last and state_ == state::missed);
        if (at == standing::is_last) {
            state_ = state::missed;
        }
        return is_gone;
    }

private:
    /// `used`: the latest request is a stop's. `missed`: reserved, and the conversation that asked last visited since the
    /// reserving one did.
    enum class state : std::uint8_t { none, used, reserved, missed };

    state state_{state::none};
    std::uint8_t unit_{0};
};

/// The line of a client without commanders, for which nobody reserves it.
struct no_reservation {
    static constexpr bool is_kept = false;
    [[nodiscard]] static constexpr bool is_on() noexcept { return false; }
    [[nodiscard]] static constexpr bool is_for_stops() noexcept { return false; }
};

/// The transaction that conversations share: whose request it has, whose turn it is to ask, and for whom the line is reserved.
/// `Reservation`: of a client without commanders, `no_reservation`.
template <typename Transaction, typename Reservation> class schedule {
public:
    constexpr schedule() noexcept = default;
    template <typename Timing, typename Options>
    constexpr schedule(Timing const& its_timing, Options const& its_options) noexcept
        : transaction_{its_timing, its_options}
    {}

    [[nodiscard]] constexpr Transaction& transaction() noexcept { return transaction_; }
    [[nodiscard]] constexpr Transaction const& transaction() const noexcept { return transaction_; }
    [[nodiscard]] constexpr detail::turns& turns() noexcept { return turns_; }
    [[nodiscard]] constexpr detail::turns const& turns() const noexcept { return turns_; }

    /// Whether a request under way that has not left yet is a stop's; whether a stop comes before all others.
    [[nodiscard]] constexpr bool is_for_stops() const noexcept { return reservation_.is_for_stops(); }
    [[nodiscard]] constexpr bool is_reserved() const noexcept { return reservation_.is_on(); }

    /// Whether the request has left and others wait already: visits change nothing but the marks of those.
    [[nodiscard]] constexpr bool needs_no_visit() const noexcept
    {
        return transaction_.has_left() and turns_.others_wait() and not reservation_.is_on() and not is_put_off_;
    }

    /// Some unit gets requests again from here on.
    constexpr void note_free_unit() noexcept
    {
        if (is_put_off_) {
            is_put_off_ = false;
            turns_.void_marks();
            turns_.note_waiting();
        }
    }

    /// A conversation's unit gets no request now. The one that asked last has had its turn; others get one later.
    constexpr turn_result put_off(asker const& who) noexcept
    {
        if (not turns_.is_last(who)) {
            is_put_off_ = true;
        }
        return turn_result::passed;
    }

    /// Whether it is this conversation's turn to ask. While others wait, or for a request that is made at the last moment, the
    /// line has to be silent first.
    constexpr bool may_ask(asker& who, bool is_prompt, instant now) noexcept
    {
        if (transaction_.is_busy()) {
            return false;
        }
        bool const is_silent = transaction_.is_quiet();
        if constexpr (Reservation::is_kept) {
            if (reservation_.is_on() and not reservation_.misses_owner(turns_, who)) {
                if (is_silent) {
                    transaction_.wake(now);
                }
                return false;
            }
            reservation_.end();
        }
        if (not turns_.others_wait() and (is_silent or not is_prompt)) {
            return true;
        }
        standing const at = turns_.mark(who);
        bool const may = is_silent and turns_.opens_turn(at);
        if (is_silent and not may) {
            transaction_.wake(now);
        }
        return may;
    }

    /// The same where the line is never silent: in its turn a conversation asks in order to be told why nothing is sent. A
    /// stop still goes first.
    constexpr bool may_ask_in_vain(asker& who) noexcept
    {
        return not transaction_.is_busy() and not reservation_.is_on() and
               (not turns_.others_wait() or turns_.opens_turn(turns_.mark(who)));
    }

    /// Whether a request that stops a unit may be sent: it waits for silence, and for the stop of another unit for which the
    /// line is reserved, but not for its turn.
    constexpr bool may_stop(asker& who, std::uint8_t unit, instant now) noexcept
    {
        if (not is_free()) {
            return false;
        }
        if (reservation_.is_for_another(unit) and not reservation_.misses_owner(turns_, who)) {
            transaction_.wake(now);
            return false;
        }
        reservation_.use();
        return true;
    }

    /// Whether a request would leave in this pass.
    [[nodiscard]] constexpr bool is_free() const noexcept
    {
        return not transaction_.is_busy() and transaction_.is_quiet();
    }

    /// A conversation visits with a stop request. Until that has left, no other conversation sends; a request under way that
    /// `may_cut` is given up, unless its response is arriving. Another one is not repeated, and given up where it has not left
    /// and is no stop's. Returns whether one is given up now.
    constexpr bool make_way_for(asker& who, std::uint8_t unit, bool may_cut, instant now) noexcept
    {
        bool const may_drop = may_cut or not reservation_.is_for_stops();
        // Of several such requests the first one to visit is next, also to drop one whose asker no longer visits: those for
        // one unit, which give each other up, keep the line from no other.
        if (not reservation_.is_for_another(unit) and
            not(reservation_.is_on() and transaction_.awaits_asker(reservation_.is_for_stops()))) {
            reservation_.begin(turns_, who, unit);
        }
        return transaction_.make_way(may_cut, may_drop, now);
    }

    /// A stop has begun: what has not left for its unit, and is no stop's, does not leave. Returns whether there is such.
    constexpr bool withdraw(std::uint8_t unit, instant now) noexcept
    {
        return transaction_.asked_unit() == unit and not reservation_.is_for_stops() and
               transaction_.make_way(false, true, now);
    }

private:
    // Small processors reach what is near with short instructions: what each pass uses stands in front of the transaction,
    // which ends with the memory of a frame.
    [[no_unique_address]] detail::turns turns_;
    bool is_put_off_{false}; ///< a conversation waits for a unit that gets no request now
    [[no_unique_address]] Reservation reservation_{};
    Transaction transaction_;
};

} // namespace detail

} // namespace RTUWIRE_BUILD
} // namespace rtuwire
