// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// Conversations that can command a motor, as far as a client has to know them: which of their requests may move
// it, which stop it, and what they learnt. client/orders.hpp is what a client does with that.
#pragma once

#include <concepts>
#include <cstdint>

#include <rtuwire/client/conversation.hpp>
#include <rtuwire/core/time.hpp>
#include <rtuwire/core/version.hpp>
#include <rtuwire/wire/unit_id.hpp>

namespace rtuwire::inline RTUWIRE_BUILD {

/// What a request does to a motor.
enum class effect : std::uint8_t {
    none,
    enabling,    ///< the motor may turn that did not, or turn otherwise
    resetting,   ///< a fault is reset, behind which the motor may turn
    rearranging, ///< another place may command the motor, or words that were in use mean something else
    stopping,    ///< the motor loses its power or slows down; a write of function 06, whose echo no other answer is
};

/// What every conversation derives from that can command the motor of a unit. It notes what its user wants and what it
/// read; the client takes note when the conversation comes by.
class commander : public asker {
public:
    /// Whether its unit is lost and hears nothing now, words that stop it included.
    [[nodiscard]] constexpr bool is_silenced() const noexcept { return is_silenced_; }

protected:
    /// The user orders something that may move the motor. A stop that begins later takes the order away.
    constexpr void note_order() noexcept { has_ordered_ = true; }

    /// The same, to run: of two such orders for a unit the later one counts.
    constexpr void note_order_to_run() noexcept
    {
        has_ordered_ = true;
        takes_over_ = true;
    }

    /// The user stops: older orders of this unit, whoever gave them, are taken away, and none is taken until the stop is over.
    constexpr void note_stop() noexcept
    {
        has_stopped_ = true;
        is_over_ = false;
    }

    /// The stop has come to its end, whatever that is.
    constexpr void note_stop_over() noexcept { is_over_ = true; }

    /// The motor was read to be without power.
    constexpr void note_rest() noexcept { has_read_rest_ = true; }

    /// The drive was read to be in fault: orders that were given before count no more.
    constexpr void note_fault() noexcept { has_read_fault_ = true; }

    /// A word that stops is nothing of the kind while it may not be said: nobody else waits for it.
    [[nodiscard]] constexpr effect effect_now(effect what) const noexcept
    {
        return what == effect::stopping and is_silenced_ ? effect::none : what;
    }

    /// Whether its unit was rearranged over this client since `note_arrangement`.
    [[nodiscard]] constexpr bool was_rearranged() const noexcept { return was_rearranged_; }
    constexpr void note_arrangement() noexcept { was_rearranged_ = false; }

    /// Whether somebody else stopped its unit, lost it or read it in fault since `heed_stop`: what was read before is old.
    [[nodiscard]] constexpr bool was_stopped() const noexcept { return was_stopped_; }
    constexpr void heed_stop() noexcept { was_stopped_ = false; }

private:
    template <std::size_t> friend class orders;
    template <std::size_t> friend class stop_holds;

    std::uint32_t stamp_{0}; ///< when the last order or stop was given, in the client's count; 0: never
    std::uint32_t seen_{0};  ///< the client's count when it had come by last
    bool was_rearranged_{false};
    bool was_stopped_{false};
    bool has_ordered_{false};
    bool takes_over_{false};
    bool has_come_by_{false};
    bool has_stopped_{false};
    bool is_over_{false};
    bool is_stopping_{false}; ///< a stop that came by, up to its end
    bool has_read_rest_{false};
    bool has_read_fault_{false};
    bool is_silenced_{false};
};

/// A conversation that commands the motor of one unit. `intent` tells what the question does that `next` would give.
/// `note_loss` tells that the unit was lost, whoever asked it: nothing but words that stop it may be asked for now.
/// `drive_timeout` is the time after which the unit stops its motor by itself when no request reaches it;
/// `tolerated_misses` how many requests in a row that enable may go without an answer before the link counts as lost.
template <typename T>
concept commanding_conversation = prompt_conversation<T> and std::derived_from<T, commander> and
                                  requires(T const& talk, T& same)
{
    same.note_loss();
    {
        talk.intent()
        } -> std::same_as<effect>;
    {
        talk.drive_timeout()
        } -> std::same_as<duration>;
    {
        talk.tolerated_misses()
        } -> std::same_as<std::uint8_t>;
};

/// A conversation that stops all units of a line: by broadcasts first, while `is_urgent`, then one by one, by the
/// commanders that `stops` gives. `may_cut` tells whether the answer that a unit owes need not be waited for.
template <typename T>
concept stops_everyone = conversation<T> and std::derived_from<T, commander> and
                         requires(T& talk, std::uint8_t unit)
{
    talk.stops();
    {
        talk.intent()
        } -> std::same_as<effect>;
    {
        talk.is_urgent()
        } -> std::same_as<bool>;
    {
        talk.may_cut(unit)
        } -> std::same_as<bool>;
};

} // namespace rtuwire
