// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// What a conversation that was run to its end gives to who ran it.
#pragma once

#include <utility>

#include <rtuwire/core/result.hpp>
#include <rtuwire/core/version.hpp>
#include <rtuwire/wire/errc.hpp>

namespace rtuwire {
inline namespace RTUWIRE_BUILD {

namespace detail {

/// A conversation with an outcome of its own: a `result`.
template <typename Conversation>
concept has_outcome = requires(Conversation& conversation)
{
    conversation.outcome().error();
};

/// A conversation that ends with a reason.
template <typename Conversation>
concept has_reason = requires(Conversation& conversation)
{
    conversation.reason().error;
};

/// Its `outcome()`, or where it has none its `reason()`, or where it has neither nothing but `busy` while it has not ended.
/// Of a conversation without a name, whose response would end with the statement, only the error.
template <typename Conversation> [[nodiscard]] constexpr auto outcome_of(Conversation&& conversation) noexcept
{
    if constexpr (requires { std::forward<Conversation>(conversation).outcome(); }) {
        return conversation.outcome();
    } else if constexpr (has_outcome<Conversation>) {
        auto const outcome = conversation.outcome();
        return outcome ? result<void>{} : result<void>{outcome.error()};
    } else if constexpr (has_reason<Conversation>) {
        return conversation.reason();
    } else {
        return conversation.settled() ? result<void>{} : result<void>{errc::busy};
    }
}

/// The same of a conversation that could not be run to its end: with the error that ended it in the place of its own.
/// Of one that had ended before (`used_already`) no earlier success is shown: its reason has not ended.
template <typename Conversation> [[nodiscard]] constexpr auto outcome_of(Conversation&& conversation, errc why) noexcept
{
    using outcome = decltype(outcome_of(std::forward<Conversation>(conversation)));
    if constexpr (has_reason<Conversation> and not has_outcome<Conversation>) {
        outcome reason = why == errc::used_already ? outcome{} : conversation.reason();
        reason.error = why;
        return reason;
    } else {
        return outcome{why};
    }
}

/// Whether a conversation can be run: one that has ended already begins anew where it can.
template <typename Conversation> [[nodiscard]] constexpr bool can_run(Conversation& conversation) noexcept
{
    if (not conversation.settled()) {
        return true;
    }
    if constexpr (requires { conversation.again(); }) {
        if constexpr (requires { conversation.leave_client(); }) {
            conversation.leave_client();
        }
        conversation.again();
        return true;
    } else {
        return false;
    }
}

} // namespace detail

} // namespace RTUWIRE_BUILD
} // namespace rtuwire
