// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// The one abstraction between what an application wants of a unit and the line: requests one after the other, each
// with its response. A read is a conversation, so is a plan or a start-up; the code that runs one need not know which.
//
// A conversation that has ended begins anew only by its `again()`, or by a `run` that calls it; a mere visit of one that
// had ended before sends nothing and takes its outcome back, which from then on says `used_already`. Here is also what
// conversations that end have in common, and what one that was run to its end gives to who ran it.
#pragma once

#include <array>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <type_traits>
#include <utility>

#include <rtuwire/core/bytes.hpp>
#include <rtuwire/core/result.hpp>
#include <rtuwire/core/time.hpp>
#include <rtuwire/core/version.hpp>
#include <rtuwire/wire/adu.hpp>
#include <rtuwire/wire/errc.hpp>

namespace rtuwire {
inline namespace RTUWIRE_BUILD {

/// Whether a client may send a request again by itself. A command that its user may cancel meanwhile is sent once.
enum class repetition : std::uint8_t { allowed, never };

/// When a conversation makes its request.
enum class freshness : std::uint8_t {
    any_time,  ///< `next` may be called while the line is still busy or the unit is held
    when_free, ///< `next` is called only when the line is free for its `unit()`: the request holds the latest values
};

namespace detail {

/// Which of its requests come before those of other conversations.
enum class urgency : std::uint8_t {
    in_turn,      ///< none
    stop_of_unit, ///< those that stop the motor of its unit: see `commanding_conversation`
    stop_of_all,  ///< those that stop all units: see `stops_by_broadcast`
};

} // namespace detail

/// What a conversation declares of itself, by a public `static constexpr conversation_properties properties{...}`.
/// Nothing else in a conversation stands for one of these: a `unit()` alone means nothing to a client.
struct conversation_properties {
    rtuwire::detail::urgency urgency{rtuwire::detail::urgency::in_turn};
    /// Of all its requests; where it is allowed, a single `request_frame` can still forbid it.
    rtuwire::repetition repetition{rtuwire::repetition::allowed};
    rtuwire::freshness freshness{rtuwire::freshness::any_time};
};

/// How long the frames of a conversation are at most, CRC included. One whose type tells declares
/// `static constexpr frame_sizes longest_frames{...}`.
struct frame_sizes {
    std::size_t request;
    std::size_t response;
};

/// A request: the bytes of a frame that `encode` made. The client copies them when it takes the request,
/// so they have to live no longer than the call that returned them.
class request_frame {
public:
    /// A frame with its CRC; `again` says whether a lost one may be sent once more.
    explicit constexpr request_frame(byte_view frame, repetition again = repetition::allowed) noexcept
        : frame_{frame}, again_{again}
    {}

    /// Bytes that end with the statement cannot become a request.
    template <std::size_t Size>
    request_frame(std::array<std::byte, Size> const&&, repetition = repetition::allowed) = delete;
    /// Deleted: a temporary frame would be gone before the client copies it.
    template <std::size_t Size>
    request_frame(detail::fixed_buffer<Size> const&&, repetition = repetition::allowed) = delete;

    [[nodiscard]] constexpr byte_view frame() const noexcept { return frame_; }
    [[nodiscard]] constexpr bool may_be_repeated() const noexcept { return again_ == repetition::allowed; }

private:
    byte_view frame_;
    repetition again_;
};

/// A response that belongs to its request: same unit, function, length and echoed fields. Empty after
/// a broadcast. A view of the client's memory, valid until the client takes the next request.
class response {
public:
    /// Empty, as behind a broadcast.
    constexpr response() noexcept = default;
    /// Views a PDU, function code and data, which must outlive it.
    explicit constexpr response(byte_view pdu) noexcept : pdu_{pdu} {}

    /// The PDU. By value, so that no loop over it holds a reference into a response that is gone; constructed anew,
    /// because GCC calls memcpy for a copy where it optimises for size (4 bytes).
    [[nodiscard]] constexpr byte_view pdu() const noexcept { return {pdu_.data(), pdu_.size()}; }

    /// The response to a request of type `Request`; the errors are those of its decoder.
    template <typename Request> [[nodiscard]] constexpr result<typename Request::response> to() const noexcept
    {
        return Request::response::decode(pdu_);
    }

private:
    byte_view pdu_;
};

namespace detail {

class turns;

} // namespace detail

/// The base of every conversation: it holds the number of the request that this conversation has under way, and on
/// which client, so that an outcome reaches no other conversation. A conversation may be destroyed, moved, copied or
/// begun anew at any time: the outcome then goes to the object that holds the number, or is dropped.
class asker {
public:
    /// What a conversation declares that says nothing else.
    static constexpr conversation_properties properties{};

    /// Gives up the last request: its outcome is dropped, never delivered. To be called where a conversation begins
    /// anew: it is then not used already any more. The request itself may have left and have its effect.
    constexpr void forget() noexcept { ticket_ |= given_up; }

protected:
    /// Whether it was visited after the visit in which it ended: its outcome is then not to be shown any more.
    [[nodiscard]] constexpr bool is_used_already() const noexcept { return ticket_ % 4 == used_already; }

    /// It is made anew in the place of `former`, whose last request is given up.
    constexpr void replace(asker const& former) noexcept
    {
        *this = former;
        forget();
    }

private:
    friend class detail::turns;

    /// A ticket is a multiple of this, or a mark of turns.hpp; with `given_up` it still shows who asked last, and is a mark
    /// as it was. Without its lowest bit, either is `used_already`. `met` is nobody's number.
    static constexpr std::uint32_t step = 32;
    static constexpr std::uint32_t given_up = 3;
    static constexpr std::uint32_t used_already = 2;
    static constexpr std::uint32_t met = 7;

    std::uint32_t ticket_{0};
    detail::turns const* turns_{nullptr}; ///< whose number it is; null where it visited none
};

/// An asker with requests. `next` returns the next request, or nothing when there is none now; it may be called again
/// before an outcome came, where the request could not be sent. `accept` takes the outcome of this conversation's last
/// request, and of no other; it is called before `next` is called again, or never where the request was given up.
/// `settled` tells that no request follows. A request is a view of its conversation's memory.
///
/// Read the outcome of a conversation in the pass in which it settles. One that ends may have an `again()`, which calls
/// `forget()`; `run` uses it.
template <typename T>
concept conversation = std::derived_from<T, asker> and requires(T& conversation, result<response> outcome)
{
    {
        conversation.next()
        } -> std::same_as<std::optional<request_frame>>;
    conversation.accept(outcome);
    {
        conversation.settled()
        } -> std::convertible_to<bool>;
};

namespace detail {

/// The base of every conversation that ends once. One that reads a value has an `outcome` of its own, which gives the
/// value.
class finite_conversation : public asker {
public:
    /// Whether it has ended: the outcome is there, and no request follows.
    [[nodiscard]] constexpr bool settled() const noexcept { return is_settled_; }

    /// How it ended. Before that it is `busy`, so that an outcome that is read too early is never a success; `settled`
    /// tells whether it is the outcome. To be read in the pass in which it settles: from the next visit on it is
    /// `used_already`.
    [[nodiscard]] constexpr result<void> outcome() const noexcept { return error(); }

protected:
    /// It ends; `none` is success.
    constexpr void settle(errc how) noexcept
    {
        error_ = how;
        is_settled_ = true;
    }

    /// It begins anew with nothing to send: how it ended is told once more.
    constexpr void tell_again() noexcept { static_cast<asker&>(*this) = asker{}; }

    /// It begins anew; the outcome of its last request is dropped.
    constexpr void reopen() noexcept
    {
        forget();
        error_ = errc::busy;
        is_settled_ = false;
    }

    /// Why there is no value; `none` after success, `busy` before the end.
    [[nodiscard]] constexpr errc error() const noexcept { return is_used_already() ? errc::used_already : error_; }

private:
    errc error_{errc::busy};
    bool is_settled_{false};
};

/// A conversation that never settles, and says so by a static `settled`: its end cannot be waited for.
template <typename T>
concept endless_conversation = conversation<T> and requires
{
    typename std::bool_constant<T::settled()>;
    requires not T::settled();
};

/// A conversation that pauses, or has a time limit: its caller calls `advance` before `next`, and again at
/// `poll_deadline`.
template <typename T>
concept timed_conversation = conversation<T> and requires(T& conversation, instant now)
{
    conversation.advance(now);
    {
        conversation.poll_deadline()
        } -> std::same_as<deadline>;
};

/// Whether what a conversation declares can be read: a private member cannot.
template <typename T>
concept declares_in_public = std::same_as<std::remove_cv_t<decltype(T::properties)>, conversation_properties>;

/// What a conversation declares of itself; the defaults where it declares nothing.
template <typename T> inline constexpr conversation_properties properties_of{};
template <typename T>
    requires declares_in_public<T>
inline constexpr conversation_properties properties_of<T> = T::properties;

/// A request of a conversation, not to be repeated where that declares `repetition::never`.
template <conversation T>
[[nodiscard]] constexpr request_frame const& as_declared(request_frame const& request) noexcept
{
    return request;
}
template <conversation T>
    requires(properties_of<T>.repetition == repetition::never)
[[nodiscard]] constexpr request_frame as_declared(request_frame const& request) noexcept
{
    return request_frame{request.frame(), repetition::never};
}

/// A conversation with one unit that declares `freshness::when_free`.
template <typename T>
concept prompt_conversation = conversation<T> and requires(T const& conversation)
{
    requires(properties_of<T>.freshness == freshness::when_free);
    {
        conversation.unit()
        } -> std::same_as<unit_id>;
};

/// Lets time pass for a timed conversation.
template <conversation Conversation>
constexpr void advance_conversation(Conversation& conversation, instant now) noexcept
{
    if constexpr (timed_conversation<Conversation>) {
        conversation.advance(now);
    }
}

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

/// Has a conversation begin anew, for whatever client runs it; false where it cannot.
template <typename Conversation> [[nodiscard]] constexpr bool begins_anew(Conversation& conversation) noexcept
{
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

/// Whether a conversation can be run: one that has ended already begins anew where it can.
template <typename Conversation> [[nodiscard]] constexpr bool can_run(Conversation& conversation) noexcept
{
    return not conversation.settled() or begins_anew(conversation);
}

} // namespace detail

} // namespace RTUWIRE_BUILD
} // namespace rtuwire
