// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// What a client does for conversations that command motors: notes their orders and stops, lets a stop come first, and
// refuses what client/order/orders.hpp does not allow. For other conversations it does nothing.
// Internal: may change with any version.
#pragma once

#include <cstdint>
#include <type_traits>

#include <rtuwire/ask/commander.hpp>
#include <rtuwire/client/desk/turn_desk.hpp>
#include <rtuwire/client/line/phase.hpp>
#include <rtuwire/client/options.hpp>
#include <rtuwire/core/time.hpp>
#include <rtuwire/core/version.hpp>
#include <rtuwire/wire/errc.hpp>

namespace rtuwire::inline RTUWIRE_BUILD {

/// The orders of conversations on a line.
template <typename LineDuty, typename Orders> class order_desk : public turn_desk<LineDuty, Orders> {
    using duty = LineDuty;
    using desk = turn_desk<LineDuty, Orders>;

public:
    using desk::desk;

    /// The second part of `converse`: lets time pass for the conversation, and notes what a commander's user wants. A
    /// stop request gets the line first, unless it `may_ask` nothing in this pass, or a later stop has its unit: then it takes
    /// the line from nobody.
    template <conversation Conversation>
    constexpr void command(Conversation& conversation, instant now, bool may_ask = true) noexcept
    {
        if constexpr (Orders::is_kept and stops_a_unit<Conversation>) {
            orders_.tell(conversation, conversation.unit().byte()); // its first word depends on it
        }
        advance_conversation(conversation, now);
        if constexpr (commanding_conversation<Conversation> or stops_by_broadcast<Conversation>) {
            static_assert(Orders::is_kept, "this client does not keep whose motor it ordered to run: take "
                                           "drive_client<Units>, or a bus");
            if constexpr (stops_by_broadcast<Conversation>) {
                orders_.visit_for_all(conversation, now);
                for (auto& each : conversation.stops()) {
                    static_assert(commanding_conversation<std::remove_reference_t<decltype(each)>>,
                                  "each stop of a conversation that stops all units commands one of them");
                    visit(each, now);
                }
                if (conversation.is_urgent()) {
                    orders_.lose_all_but_its_own(conversation, now);
                }
                orders_.note_ordered(conversation);
            } else {
                bool const stops = conversation.begins_to_stop();
                visit(conversation, now);
                if (stops and not desk::is_asked_by(conversation)) {
                    withdraw(conversation.unit().byte(), now); // its first request may be a read
                }
            }
            bool const is_due = may_ask and conversation.intent() == effect::stopping;
            if (is_due and not desk::is_asked_by(conversation) and
                check_order(conversation, effect::stopping) == errc::none) {
                make_way_for(conversation, now);
            }
        }
    }

protected:
    using desk::orders_;
    using desk::reservation_;
    using desk::turns_;

    /// What the next request of a conversation does to a motor.
    template <typename Conversation> static constexpr effect effect_of(Conversation const& conversation) noexcept
    {
        if constexpr (commanding_conversation<Conversation> or stops_by_broadcast<Conversation>) {
            return conversation.intent();
        }
        return effect::none;
    }

    /// Whether a conversation may ask now: a stop request does not wait for its turn.
    template <typename Conversation>
    constexpr bool has_turn(Conversation& conversation, effect what, instant now) noexcept
    {
        if constexpr (commanding_conversation<Conversation> or stops_by_broadcast<Conversation>) {
            if (what == effect::stopping) {
                return desk::may_stop(conversation, unit_stopped_by(conversation), now);
            }
        }
        return desk::may_ask(conversation, prompt_conversation<Conversation>, now);
    }

    /// Why a request was given up: a stop of its unit came before it, or it was cancelled.
    template <typename Conversation> constexpr errc reason_of_drop(Conversation const& conversation) const noexcept
    {
        if constexpr (commanding_conversation<Conversation>) {
            return orders_.is_overruled(conversation, conversation.unit().byte()) ? errc::overruled : errc::cancelled;
        }
        return errc::cancelled;
    }

    /// Whether a unit gets no request of this effect now. Stop requests do not wait for outstanding responses of their
    /// unit: none of these is the echo of a stop request.
    constexpr bool is_barred(std::uint8_t unit, effect what) const noexcept
    {
        return orders_.is_silent(unit, what) or (what != effect::stopping and duty::is_held(unit));
    }

    template <typename Conversation>
    constexpr errc check_order(Conversation const& conversation, effect what) const noexcept
    {
        if constexpr (commanding_conversation<Conversation>) {
            return orders_.check(conversation, conversation.unit().byte(), what);
        }
        return errc::none;
    }

    template <typename Conversation> constexpr void note_asked(Conversation& conversation, effect what) noexcept
    {
        if constexpr (commanding_conversation<Conversation>) {
            orders_.note_asked(conversation, conversation.unit().byte(), what, conversation.drive_timeout(),
                               conversation.tolerated_misses());
        } else if constexpr (stops_by_broadcast<Conversation>) {
            for (auto& each : conversation.stops()) {
                if (each.unit().byte() == duty::asked_unit()) {
                    note_asked(each, what);
                }
            }
        } else if constexpr (Orders::is_kept and frees_all_units<Conversation>) {
            orders_.note_all_freed();
        }
    }

    /// Starts a request to a unit. To a lost unit each stop request is sent once.
    constexpr errc start(request_frame const& asked, instant now, std::uint8_t unit, retry_policy const& with) noexcept
    {
        if constexpr (Orders::is_kept) {
            orders_.note_start(now);
            retry_policy own = with;
            own.retries = orders_.is_lost(unit) ? std::uint8_t{0} : with.retries;
            return duty::start(asked, now, own);
        } else {
            return duty::start(asked, now, with);
        }
    }

private:
    /// A commander of one unit visits.
    template <typename Conversation> constexpr void visit(Conversation& conversation, instant now) noexcept
    {
        std::uint8_t const unit = conversation.unit().byte();
        if (orders_.visit(conversation, unit, now)) {
            conversation.note_loss();
        }
        if constexpr (stops_a_unit<Conversation>) {
            if (conversation.take_other_family()) {
                orders_.leave_alone(unit, now);
            }
        }
    }

    /// The unit that a stop request stops; 0 for one of several.
    template <typename Conversation>
    static constexpr std::uint8_t unit_stopped_by(Conversation const& conversation) noexcept
    {
        if constexpr (commanding_conversation<Conversation>) {
            return conversation.unit().byte();
        }
        return 0;
    }

    /// A conversation visits with a stop request. Until that has left, no other conversation sends; a request under
    /// way for its unit is given up, unless its response is arriving. One for another unit is not repeated, and given up
    /// where it has not left and is no stop's.
    template <typename Conversation> constexpr void make_way_for(Conversation& conversation, instant now) noexcept
    {
        if (desk::is_free()) {
            return;
        }
        bool may_cut = false;
        if constexpr (stops_by_broadcast<Conversation>) {
            may_cut = conversation.may_cut(duty::asked_unit());
        } else {
            may_cut = conversation.unit().byte() == duty::asked_unit();
        }
        make_way_for(conversation, unit_stopped_by(conversation), may_cut, now);
    }

    constexpr void make_way_for(asker& who, std::uint8_t unit, bool may_cut, instant now) noexcept
    {
        bool const may_drop = may_cut or not reservation_.is_of_stops();
        // Of several such requests the first one to visit is next, also to drop one whose asker no longer visits: those for
        // one unit, which give each other up, keep the line from no other.
        if (not reservation_.is_held_for_another(unit) and not(reservation_.is_held() and duty::awaits_asker())) {
            reservation_.begin(turns_, who, unit);
        }
        give_up(may_cut, may_drop, now);
    }

    /// A stop has begun: what has not left for its unit, and is no stop's, does not leave.
    constexpr void withdraw(std::uint8_t unit, instant now) noexcept
    {
        if (duty::asked_unit() == unit and not reservation_.is_of_stops()) {
            give_up(false, true, now);
        }
    }

    constexpr void give_up(bool may_cut, bool may_drop, instant now) noexcept
    {
        duty::make_way(may_cut, may_drop, now);
        if (duty::was_cut()) {
            static_cast<void>(duty::take_outcome()); // its asker is told that it was cancelled
            turns_.void_marks();                     // this visit counts once
        }
    }
};

} // namespace rtuwire
