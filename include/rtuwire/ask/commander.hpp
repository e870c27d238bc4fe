// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// Conversations that can command a motor, as far as a client has to know them: which of their requests may move it,
// which stop it, and what they read. client/orders.hpp says what a client does with that.
#pragma once

#include <concepts>
#include <cstdint>

#include <rtuwire/ask/conversation.hpp>
#include <rtuwire/ask/unit_order.hpp>
#include <rtuwire/core/bytes.hpp>
#include <rtuwire/core/time.hpp>
#include <rtuwire/core/version.hpp>
#include <rtuwire/wire/errc.hpp>
#include <rtuwire/wire/unit_id.hpp>

namespace rtuwire {
inline namespace RTUWIRE_BUILD {

namespace detail {

/// What a request does to a motor.
enum class effect : std::uint8_t {
    none,
    enabling,    ///< the motor may start to turn, or turn in another way
    resetting,   ///< a fault is reset, after which the motor may turn
    rearranging, ///< another channel may command the motor, or words in use change their meaning
    stopping,    ///< the motor loses its power or slows down; a write of function 06, which no other response echoes
};

/// The register that says what a unit's control word means, CHCF of most Altivars: 1 and 2 are the drive profile, in any
/// other one the word of a stop may run the motor.
inline constexpr std::uint16_t meaning_register = 8401;

/// In the place of a control word's address: `meaning_register` was read, and no word is known to stop the unit but 0000.
inline constexpr std::uint16_t other_meaning = 0xFFFF;

/// Whether a request writes `meaning_register`, among others or alone. The functions that write holding registers
/// have their first address in front; 23 has it behind what it reads.
[[nodiscard]] constexpr bool writes_meaning(byte_view frame) noexcept
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

/// The base of every conversation that can command the motor of a unit. It notes what its user wants and what it read;
/// the client takes that over when the conversation visits (`converse` is called for it).
class commander : public asker {
public:
    /// Of one unit, or of all.
    explicit constexpr commander(destination whose) noexcept : whose_{whose} {}

    /// Whether its unit is lost and gets no request now, stop requests included.
    [[nodiscard]] constexpr bool is_silenced() const noexcept { return is_silenced_; }

    /// Forgets the client that it visited: for a `run`, whose client may be another one. Begun anew behind that, its order
    /// counts from its next visit.
    constexpr void leave_client() noexcept
    {
        known_ = {};
        counted_by_ = {};
        seen_ = {};
        ordered_behind_ = {};
    }

    /// Whether its user has ordered a stop since its last visit.
    [[nodiscard]] constexpr bool begins_to_stop() const noexcept { return has_stopped_; }

    /// Whether the request that it has just made is the command to run: the motor may follow it later.
    [[nodiscard]] constexpr bool says_run() const noexcept { return says_run_; }

protected:
    /// The unit whose motor it commands, where it is one.
    [[nodiscard]] constexpr unit_id unit() const noexcept { return whose_.unit(); }

    /// It begins anew in the place of `former`, which it was: its order is given now, and not where it visits next. The client
    /// that it visited last has not been destroyed, or another one was made in its place.
    constexpr void begin_anew(commander const& former) noexcept
    {
        replace(former);
        counted_by_ = former.counted_by_;
        known_ = former.known_;
        ordered_behind_ = newer_of(former.seen_, former.ordered_behind_);
        if (known_ != nullptr) {
            ordered_behind_ = newer_of(newer_of(ordered_behind_, known_->last_stop), known_->last_fault);
        }
    }

    constexpr void note_command(bool runs) noexcept { says_run_ = runs; }

    /// The user orders something that may move the motor. A stop that begins later cancels the order.
    constexpr void note_order() noexcept
    {
        has_ordered_ = true;
        is_overruled_ = false;
    }

    /// The same, to run: of two such orders for a unit the later one counts.
    constexpr void note_order_to_run() noexcept
    {
        note_order();
        takes_over_ = true;
    }

    /// The user stops: cancels older orders of this unit by any conversation, and none is accepted until the stop is
    /// over.
    constexpr void note_stop() noexcept
    {
        has_stopped_ = true;
        is_over_ = false;
    }

    /// The stop has ended, whatever its outcome.
    constexpr void note_stop_over() noexcept { is_over_ = true; }

    /// What was read of the motor's power.
    constexpr void note_power(power_seen seen) noexcept
    {
        power_seen_ = seen == power_seen::nothing ? power_seen_ : seen;
    }

    /// The drive was read in fault: orders given before no longer count.
    constexpr void note_fault() noexcept { has_read_fault_ = true; }

    /// The unit was read to be in the drive profile: at this address the words of all stops stop it. That holds until it
    /// may have been without power: it was lost, a request to it had no response, or none was made for 0.5 s; and until
    /// `meaning_register` is written. `other_meaning`: it was read to be in another one, which ends what was read before; 0:
    /// nothing was read.
    constexpr void note_meaning(std::uint16_t control_word) noexcept
    {
        if (control_word != 0) {
            read_meaning_of_ = confirmed_ = control_word;
            is_doubtful_ = false;
        }
    }

    /// Where a conversation of this client has read so, and it still holds; 0: nowhere. Told at each visit; a stop
    /// is told before its `advance`, too.
    [[nodiscard]] constexpr std::uint16_t confirmed() const noexcept
    {
        return is_doubtful_ ? std::uint16_t{0} : confirmed_;
    }

    /// The same where it was read, and the unit may have been without power since.
    [[nodiscard]] constexpr std::uint16_t was_confirmed() const noexcept
    {
        return is_doubtful_ ? confirmed_ : std::uint16_t{0};
    }
    [[nodiscard]] constexpr bool is_doubtful() const noexcept { return is_doubtful_; }
    /// The same, doubtful or not.
    [[nodiscard]] constexpr std::uint16_t last_confirmed() const noexcept { return confirmed_; }

    /// A stop request that may not be sent now counts as `none`: no other conversation waits for it.
    [[nodiscard]] constexpr effect effect_now(effect what) const noexcept
    {
        return what == effect::stopping and is_silenced_ ? effect::none : what;
    }

    /// Whether its unit was rearranged through this client since `note_arrangement`.
    [[nodiscard]] constexpr bool was_rearranged() const noexcept { return was_rearranged_; }
    constexpr void note_arrangement() noexcept { was_rearranged_ = false; }

    /// Whether its last order is older than a stop of its unit by another conversation. Told at each visit.
    [[nodiscard]] constexpr bool is_overruled() const noexcept { return is_overruled_; }

    /// Whether its order to run still counts for the client that it visited last, which must not have been destroyed: that
    /// has not stopped or lost the unit since, nor read it in fault or without power, nor ordered it to run anew. It may
    /// have been made anew in its place, and does not count it then. True before the first visit.
    [[nodiscard]] constexpr bool is_order_in_force() const noexcept
    {
        return known_ == nullptr or (end_of_order() == errc::none and not known_->is_replaced(stamp_));
    }

    /// What has ended its order to move the motor, apart from another order: `overruled`, a stop; `unit_lost`, a loss, a silence
    /// longer than the drive's time-out, a fault, or a status without power. Of the client as above.
    [[nodiscard]] constexpr errc end_of_order() const noexcept
    {
        if (known_ == nullptr) {
            return errc::none;
        }
        bool const is_stopped = is_older(stamp_, known_->last_stop);
        if (is_stopped and not known_->was_lost) {
            return errc::overruled;
        }
        bool const stands =
            known_->unit == whose_.byte() and known_->is_ordered and not is_older(stamp_, known_->last_fault);
        return is_stopped or not stands ? errc::unit_lost : errc::none;
    }

    /// Whether the order to run that counts is another conversation's: later than any of its own and than its stops, and
    /// neither stopped nor lost since, nor read in fault. As far as the client knows that it visited last.
    [[nodiscard]] constexpr bool is_ordered_by_another() const noexcept
    {
        if (known_ == nullptr or known_->unit != whose_.byte()) {
            return false;
        }
        std::uint32_t const order = known_->last_order;
        return known_->is_replaced(stamp_) and not is_older(order, known_->last_stop) and
               not is_older(order, known_->last_fault);
    }

    /// Whether a conversation of this client ordered its unit to run (where it stops all: any unit), and none has read since
    /// that the motor has no power. Told at each visit.
    [[nodiscard]] constexpr bool is_unit_ordered() const noexcept { return is_unit_ordered_; }

    /// Whether another conversation stopped its unit, lost it or read it in fault since `heed_stop`: older readings
    /// are stale.
    [[nodiscard]] constexpr bool was_stopped() const noexcept { return was_stopped_; }
    constexpr void heed_stop() noexcept { was_stopped_ = false; }

private:
    template <std::size_t> friend class orders;

    // Small processors reach bytes with short instructions only where they are near.
    bool is_doubtful_{false};
    bool says_run_{false};
    bool was_rearranged_{false};
    bool was_stopped_{false};
    bool has_ordered_{false};
    bool takes_over_{false};
    bool has_visited_{false};
    bool has_stopped_{false};
    bool is_over_{false};
    bool is_stopping_{false}; ///< a stop that visited, up to its end
    power_seen power_seen_{power_seen::nothing};
    bool has_read_fault_{false};
    bool is_silenced_{false};
    bool is_overruled_{false};
    bool is_unit_ordered_{false};
    destination whose_;
    std::uint16_t read_meaning_of_{0};
    std::uint16_t confirmed_{0};
    std::uint32_t counted_by_{0};      ///< the number of the client whose count the next two are
    std::uint32_t stamp_{0};           ///< when the last order or stop was given, in the client's count; 0: never
    std::uint32_t seen_{0};            ///< the client's count at the last visit
    std::uint32_t ordered_behind_{0};  ///< what the client had counted where it was begun anew; 0: it was not
    unit_order const* known_{nullptr}; ///< what the client knows of its unit, since the last visit
};

/// A conversation that commands the motor of one unit: it declares `urgency::stop_of_unit`. `intent` gives the effect
/// of the request that `next` would return. `note_loss` tells it that the unit was lost, by a request of any
/// conversation: it may send only stop requests now. `drive_timeout` is the time after which the unit stops its motor
/// by itself when no request reaches it; `tolerated_misses` is how many enabling requests in a row may go without a
/// response before the link counts as lost.
template <typename T>
concept commanding_conversation = prompt_conversation<T> and std::derived_from<T, commander> and
    requires(T const& conversation, T& same)
{
    requires(properties_of<T>.urgency == urgency::stop_of_unit);
    same.note_loss();
    {
        conversation.intent()
        } -> std::same_as<effect>;
    {
        conversation.drive_timeout()
        } -> std::same_as<duration>;
    {
        conversation.tolerated_misses()
        } -> std::same_as<std::uint8_t>;
};

/// A conversation whose requests may write `meaning_register`: the client looks into each. One that never does, or tells
/// it by the intent `effect::rearranging`, says so by a static `keeps_meaning`.
template <typename T>
concept may_write_meaning = not requires
{
    requires T::keeps_meaning;
};

/// A conversation that may stop a unit by its user's order: `is_stop` tells whether it does. `take_other_family` tells once
/// that the unit refuses its type's control word.
template <typename T>
concept may_be_stop = commanding_conversation<T> and requires(T& conversation)
{
    {
        conversation.is_stop()
        } -> std::same_as<bool>;
    conversation.take_other_family();
};

/// A conversation that clients visit as a base of it, which it names, so that they have one code for all that derive from
/// that. One that hides a function or a property which it has from there is visited as itself.
template <typename T>
concept visited_as_base =
    std::derived_from<T, typename T::visited_as> and not std::same_as<T, typename T::visited_as> and requires
{
    requires std::same_as<decltype(&T::next), decltype(&T::visited_as::next)>;
    requires std::same_as<decltype(&T::accept), decltype(&T::visited_as::accept)>;
    requires std::same_as<decltype(&T::settled), decltype(&T::visited_as::settled)>;
    requires std::same_as<decltype(&T::advance), decltype(&T::visited_as::advance)>;
    requires std::same_as<decltype(&T::poll_deadline), decltype(&T::visited_as::poll_deadline)>;
    requires std::same_as<decltype(&T::unit), decltype(&T::visited_as::unit)>;
    requires std::same_as<decltype(&T::intent), decltype(&T::visited_as::intent)>;
    requires std::same_as<decltype(&T::limited), decltype(&T::visited_as::limited)>;
    requires std::same_as<decltype(&T::note_loss), decltype(&T::visited_as::note_loss)>;
    requires std::same_as<decltype(&T::drive_timeout), decltype(&T::visited_as::drive_timeout)>;
    requires std::same_as<decltype(&T::is_stop), decltype(&T::visited_as::is_stop)>;
    requires std::same_as<decltype(&T::take_other_family), decltype(&T::visited_as::take_other_family)>;
    requires& T::properties == &T::visited_as::properties;
    requires& T::asks == &T::visited_as::asks;
};

/// A conversation in the form in which clients visit it.
template <typename T> [[nodiscard]] constexpr auto& as_visited(T& conversation) noexcept
{
    if constexpr (visited_as_base<T>) {
        return static_cast<typename T::visited_as&>(conversation);
    } else {
        return conversation;
    }
}

/// A conversation that stops all units of a line: it declares `urgency::stop_of_all`. It stops them by broadcasts
/// first, while `is_urgent`, then one by one, by the commanders that `stops` gives. `unit_told` is the unit of its next word, 0
/// for all; `may_cut` tells whether a unit's outstanding response need not be waited for. `note_unlisted` tells that a unit which none of them stops is ordered to run,
/// and the control word's address that was read to be its own; 0 or `other_meaning` where none was.
template <typename T>
concept stops_by_broadcast = conversation<T> and std::derived_from<T, commander> and
    requires(T& conversation, std::uint8_t unit)
{
    requires(properties_of<T>.urgency == urgency::stop_of_all);
    conversation.stops();
    conversation.note_unlisted(std::uint16_t{});
    {
        conversation.intent()
        } -> std::same_as<effect>;
    {
        conversation.is_urgent()
        } -> std::same_as<bool>;
    {
        conversation.unit_told()
        } -> std::same_as<std::uint8_t>;
    {
        conversation.may_cut(unit)
        } -> std::same_as<bool>;
};

/// A conversation that sends all units, by a broadcast, a word that takes the power of their motors away, and follows
/// none of them.
template <typename T>
concept frees_all_units = requires
{
    requires T::frees_all;
};

/// What the next request of a conversation does to a motor.
template <conversation T> [[nodiscard]] constexpr effect effect_of(T const& conversation) noexcept
{
    if constexpr (commanding_conversation<T> or stops_by_broadcast<T>) {
        return conversation.intent();
    }
    return frees_all_units<T> and not conversation.settled() ? effect::stopping : effect::none;
}

/// The unit that a stop request stops; 0 for one of several.
template <conversation T> [[nodiscard]] constexpr std::uint8_t unit_stopped_by(T const& conversation) noexcept
{
    if constexpr (stops_by_broadcast<T>) {
        return conversation.unit_told();
    } else if constexpr (commanding_conversation<T>) {
        return conversation.unit().byte();
    }
    return 0;
}

/// Whether it stops the unit of a request that is under way.
template <conversation T> [[nodiscard]] constexpr bool may_cut(T const& conversation, std::uint8_t asked) noexcept
{
    if constexpr (stops_by_broadcast<T>) {
        return conversation.may_cut(asked);
    } else if constexpr (commanding_conversation<T>) {
        return conversation.unit().byte() == asked;
    }
    return false;
}

/// How long the response may take: a commander may allow less time than the policy of its unit.
template <conversation T> [[nodiscard]] constexpr duration timeout_of(T const& conversation, duration usual) noexcept
{
    if constexpr (requires { conversation.limited(usual); }) {
        return conversation.limited(usual);
    }
    return usual;
}

/// Whether a conversation has all that its properties need; what is missing is refused in a sentence.
template <conversation T> [[nodiscard]] constexpr bool has_what_it_declares() noexcept
{
    static_assert(declares_in_public<T>, "the `properties` of a conversation are public, and of the type "
                                         "`static constexpr conversation_properties`");
    constexpr conversation_properties declared = properties_of<T>;
    static_assert(declared.freshness == freshness::any_time or prompt_conversation<T>,
                  "a conversation that declares freshness::when_free has a unit(): `unit_id unit() const`");
    static_assert(declared.urgency == urgency::in_turn or std::derived_from<T, commander>,
                  "a conversation that declares an urgency derives from commander");
    static_assert(declared.urgency != urgency::in_turn or not std::derived_from<T, commander>,
                  "a commander declares its urgency: a stop comes before all other requests");
    static_assert(declared.urgency != urgency::stop_of_unit or declared.freshness == freshness::when_free,
                  "a conversation that declares urgency::stop_of_unit also declares freshness::when_free");
    static_assert(declared.urgency != urgency::stop_of_unit or declared.freshness == freshness::any_time or
                      commanding_conversation<T>,
                  "a conversation that declares urgency::stop_of_unit has note_loss(), intent(), drive_timeout() and "
                  "tolerated_misses()");
    static_assert(declared.urgency != urgency::stop_of_all or stops_by_broadcast<T>,
                  "a conversation that declares urgency::stop_of_all has stops(), note_unlisted(), intent(), "
                  "is_urgent() and may_cut()");
    return true;
}

} // namespace detail

} // namespace RTUWIRE_BUILD
} // namespace rtuwire
