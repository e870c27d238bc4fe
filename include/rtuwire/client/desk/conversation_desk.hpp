// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// The conversations' desk of a client: a conversation that visits gets its outcome here, and leaves its next request
// where it is its turn. client/desk/turn_desk.hpp says whose turn it is, client/desk/order_desk.hpp what commanders may
// do.
// Internal: may change with any version.
#pragma once

#include <cstdint>
#include <optional>

#include <rtuwire/ask/commander.hpp>
#include <rtuwire/client/desk/order_desk.hpp>
#include <rtuwire/client/options.hpp>
#include <rtuwire/core/bytes.hpp>
#include <rtuwire/core/result.hpp>
#include <rtuwire/core/time.hpp>
#include <rtuwire/core/version.hpp>
#include <rtuwire/wire/errc.hpp>

namespace rtuwire::inline RTUWIRE_BUILD {

/// Serves conversations on a line; `LineDuty` runs one request at a time, `Orders` is as for `basic_client`.
template <typename LineDuty, typename Orders> class conversation_desk : public order_desk<LineDuty, Orders> {
    using duty = LineDuty;
    using desk = order_desk<LineDuty, Orders>;

public:
    using desk::desk;

    /// One visit of a conversation: gives it its outcome, and takes its next request when it is its turn. After an
    /// outcome the next turn is that of the others that visited meanwhile. A request to a unit with an outstanding
    /// response stays with its conversation; a request that cannot be sent at all is refused at once. Of a conversation
    /// that had settled before this visit nothing is sent, and its outcome says `used_already` from here on: read it in
    /// the pass in which it settles.
    template <conversation Conversation> constexpr void converse(Conversation& conversation, instant now) noexcept
    {
        client_options const& all = duty::options();
        // The time is constructed anew: GCC would read a constant's copy from memory.
        converse(conversation, now,
                 {.response_timeout = duration{all.response_timeout.microseconds}, .retries = all.retries});
    }

    /// The same, with a `retry_policy` for this conversation's unit.
    template <conversation Conversation>
    constexpr void converse(Conversation& conversation, instant now, retry_policy const& with) noexcept
    {
        static_cast<void>(deliver(conversation, not conversation.settled(), now));
        this->command(conversation, now);
        static_cast<void>(ask(conversation, now, with));
        if constexpr (Orders::is_kept and timed_conversation<Conversation>) {
            orders_.wake_for(conversation.poll_deadline(), now);
        }
    }

    /// The first part of `converse`: the error of the outcome that the conversation was given (`none` for a response),
    /// if it was given one. `wants_turn` tells whether it has a request to send.
    template <conversation Conversation>
    constexpr std::optional<errc> deliver(Conversation& conversation, bool wants_turn, instant now) noexcept
    {
        std::optional<errc> told;
        if (turns_.was_dropped(conversation, duty::phase_now() == client_phase::idle)) {
            told = this->reason_of_drop(conversation);
            conversation.accept(*told);
            wants_turn = wants_turn and not conversation.settled();
        } else {
            turns_.meet(conversation, conversation.settled());
        }
        if (not this->comes_by(conversation, wants_turn, now)) { // the outcome may be another's
            return told;
        }
        turns_.renew(conversation);
        conversation.forget();
        result<response> const outcome = this->take_outcome(now);
        conversation.accept(outcome);
        return outcome.error();
    }

    /// The last part of `converse`. Where the request is refused, the conversation is given the error as its outcome.
    template <conversation Conversation>
    constexpr turn_result ask(Conversation& conversation, instant now, retry_policy const& with) noexcept
    {
        static_assert(has_what_it_declares<Conversation>());
        if (conversation.settled() and not turns_.is_last(conversation)) {
            return turn_result::passed;
        }
        effect const what = this->effect_of(conversation);
        if (not this->has_turn(conversation, what, now)) {
            return turn_result::waits;
        }
        if constexpr (prompt_conversation<Conversation>) {
            if (errc const wrong = this->check_order(conversation, what); wrong != errc::none) {
                return refuse(conversation, wrong, now);
            }
            if (this->is_barred(conversation.unit().byte(), what)) {
                return this->hold_back(conversation);
            }
        }
        auto const request = conversation.next();
        if (not request) {
            return turn_result::passed;
        }
        std::uint8_t const unit = request->frame().empty() ? std::uint8_t{0} : to_u8(request->frame()[0]);
        if (this->is_barred(unit, what)) {
            return this->hold_back(conversation);
        }
        errc const wrong = this->start(as_declared<Conversation>(*request), now, unit, policy_of(conversation, with));
        if (wrong != errc::none) {
            return refuse(conversation, wrong, now);
        }
        if constexpr (Orders::is_kept and may_write_meaning<Conversation>) {
            orders_.note_request(request->frame());
        }
        turns_.renew(conversation);
        this->note_asked(conversation, what);
        return turn_result::asked;
    }

protected:
    using desk::orders_;
    using desk::turns_;

private:
    /// A conversation may allow the response less time than the unit's policy.
    template <typename Conversation>
    static constexpr decltype(auto) policy_of(Conversation const& conversation, retry_policy const& with) noexcept
    {
        if constexpr (requires { conversation.limited(with.response_timeout); }) {
            retry_policy own = with;
            own.response_timeout = conversation.limited(with.response_timeout);
            return own;
        } else {
            return (with);
        }
    }

    /// A request cannot be sent.
    template <typename Conversation>
    constexpr turn_result refuse(Conversation& conversation, errc wrong, instant now) noexcept
    {
        conversation.accept(wrong);
        duty::wake(now); // it may have another request, and no deadline shows that
        return turn_result::passed;
    }
};

} // namespace rtuwire
