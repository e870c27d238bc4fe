// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// The one abstraction between what somebody wants of a unit and the line it goes over: questions one
// after the other, each with its answer. A read is a conversation, a plan is, a start-up is; whoever
// runs it need not know which.
#pragma once

#include <array>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <type_traits>

#include <rtuwire/core/bytes.hpp>
#include <rtuwire/core/fixed_buffer.hpp>
#include <rtuwire/core/result.hpp>
#include <rtuwire/core/time.hpp>
#include <rtuwire/core/version.hpp>
#include <rtuwire/wire/adu.hpp>

namespace rtuwire::inline RTUWIRE_BUILD {

/// Whether a client may send a question again by itself. A command that somebody may take back meanwhile
/// is sent once.
enum class repetition : std::uint8_t { allowed, never };

/// A question: the octets of a frame that `encode` made. The client copies them when it takes the question,
/// so they have to live no longer than the call that returned them.
class request {
public:
    explicit constexpr request(byte_view frame, repetition again = repetition::allowed) noexcept
        : frame_{frame}, again_{again}
    {}

    /// Octets that die at the end of the statement cannot be asked.
    template <std::size_t Size>
    request(std::array<std::byte, Size> const&&, repetition = repetition::allowed) = delete;
    template <std::size_t Size>
    request(fixed_buffer<Size> const&&, repetition = repetition::allowed) = delete;

    [[nodiscard]] constexpr byte_view frame() const noexcept { return frame_; }
    [[nodiscard]] constexpr bool may_be_repeated() const noexcept
    {
        return again_ == repetition::allowed;
    }

private:
    byte_view frame_;
    repetition again_;
};

/// An answer that belongs to its question: same unit, function, length and echoed fields. Empty after
/// a broadcast. A view of the client's memory, valid until the client takes the next request.
class response {
public:
    constexpr response() noexcept = default;
    explicit constexpr response(byte_view pdu) noexcept : pdu_{pdu} {}

    /// The PDU. By value, so that no loop over it holds a reference into a response that is gone; made anew,
    /// because GCC calls memcpy for a copy where it optimises for size (4 bytes).
    [[nodiscard]] constexpr byte_view pdu() const noexcept { return {pdu_.data(), pdu_.size()}; }

    /// The answer to a request of type `Request`; the errors are those of its decoder.
    template <typename Request>
    [[nodiscard]] constexpr result<typename Request::response> to() const noexcept
    {
        return Request::response::decode(pdu_);
    }

private:
    byte_view pdu_;
};

class turns;

/// What every conversation derives from: it holds the number of the request that this conversation has under
/// way, and on which client, so that an outcome reaches nobody else. A conversation may be destroyed, moved,
/// copied or begun anew at any time: the outcome then goes to whichever object holds the number, or to nobody.
class asker {
public:
    /// Gives up what was asked last: its outcome is dropped, never delivered. Whoever makes a conversation
    /// start anew calls it. The request itself may have left and have its effect.
    constexpr void forget() noexcept { ticket_ |= given_up; }

private:
    friend class turns;

    /// Tickets are multiples of this, and what turns.hpp makes of them; one more still tells who asked last.
    static constexpr std::uint32_t step = 16;
    static constexpr std::uint32_t given_up = 1;

    std::uint32_t ticket_{0};
    turns const* turns_{nullptr}; ///< whose number it is; null where there is none
};

/// An asker with questions. `next` gives the next question, or nothing when there is none now; it may be
/// called again before an outcome came, where the question could not be sent. `accept` takes the outcome of
/// the question that this conversation asked last, and of no other; it comes before `next` is called again, or
/// never where the conversation was given up. `settled` tells that no question follows. A question is a view of its
/// conversation's memory.
template <typename T>
concept conversation = std::derived_from<T, asker> and requires(T& talk, result<response> outcome)
{
    {
        talk.next()
        } -> std::same_as<std::optional<request>>;
    talk.accept(outcome);
    {
        talk.settled()
        } -> std::convertible_to<bool>;
};

/// A conversation that never settles, and says so by a static `settled`: nobody may wait for its end.
template <typename T>
concept endless_conversation = conversation<T> and requires
{
    typename std::bool_constant<T::settled()>;
    requires not T::settled();
};

/// A conversation that pauses, or has a time limit: whoever runs it calls `advance` before `next`, and
/// again at `poll_deadline`.
template <typename T>
concept timed_conversation = conversation<T> and requires(T& talk, instant now)
{
    talk.advance(now);
    {
        talk.poll_deadline()
        } -> std::same_as<deadline>;
};

/// A conversation with one unit whose question is made at the last moment: it is asked for one only when
/// the line is free for that unit.
template <typename T>
concept prompt_conversation = conversation<T> and requires(T const& talk)
{
    {
        talk.unit()
        } -> std::same_as<unit_id>;
};

/// Lets time pass for a conversation that cares for it.
template <conversation Talk> constexpr void advance_talk(Talk& talk, instant now) noexcept
{
    if constexpr (timed_conversation<Talk>) {
        talk.advance(now);
    }
}

} // namespace rtuwire
