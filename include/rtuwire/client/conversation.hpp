// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// The one abstraction between what somebody wants of a unit and the line it goes over: questions one
// after the other, each with its answer. A read is a conversation, a plan is, a start-up is; whoever
// runs it need not know which.
#pragma once

#include <concepts>
#include <cstdint>
#include <optional>

#include <rtuwire/core/bytes.hpp>
#include <rtuwire/core/result.hpp>
#include <rtuwire/core/time.hpp>
#include <rtuwire/wire/adu.hpp>

namespace rtuwire {

/// Whether a client may send a question again by itself. A command that somebody may take back meanwhile
/// is sent once.
enum class repetition : std::uint8_t { allowed, never };

/// A question: the octets of a frame that `encode` made. Whoever asks keeps them unchanged until the
/// outcome is there, so that a repetition is the same question.
class request {
public:
    explicit constexpr request(byte_view frame, repetition again = repetition::allowed) noexcept
        : frame_{frame}, again_{again}
    {}

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
/// a broadcast. A view, valid until the next request is started.
class response {
public:
    constexpr response() noexcept = default;
    explicit constexpr response(byte_view pdu) noexcept : pdu_{pdu} {}

    /// By reference, because GCC calls memcpy for a copy where it optimises for size.
    [[nodiscard]] constexpr byte_view const& pdu() const noexcept { return pdu_; }

    /// The answer to a request of type `Request`; the errors are those of its decoder.
    template <typename Request>
    [[nodiscard]] constexpr result<typename Request::response> to() const noexcept
    {
        return Request::response::decode(pdu_);
    }

private:
    byte_view pdu_;
};

/// Whatever has questions and takes answers: `next` gives the next question, or nothing when there is
/// none now; `accept` takes the outcome of the last one before `next` is called again; `settled` tells
/// that no question follows.
template <typename T>
concept conversation = requires(T& talk, result<response> outcome)
{
    {
        talk.next()
        } -> std::same_as<std::optional<request>>;
    talk.accept(outcome);
    {
        talk.settled()
        } -> std::convertible_to<bool>;
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

/// The conversation of one question, which it owns.
template <pdu Request> class single_question {
public:
    /// Encodes the question; where that fails, nothing is asked and `outcome()` says why.
    template <typename To> constexpr single_question(To to, Request const& question) noexcept
    {
        auto const frame = encode(to, question);
        if (frame) {
            frame_ = *frame;
        } else {
            outcome_ = frame.error();
        }
    }

    constexpr std::optional<request> next() const noexcept
    {
        if (settled()) {
            return std::nullopt;
        }
        return request{frame_};
    }

    constexpr void accept(result<response> outcome) noexcept { outcome_ = outcome; }

    /// Whether the outcome is there.
    [[nodiscard]] constexpr bool settled() const noexcept
    {
        return outcome_.error() != errc::pending;
    }

    /// What came of it, `pending` until it is settled; the answer is valid until the client's next
    /// request.
    [[nodiscard]] constexpr result<response> outcome() const noexcept { return outcome_; }

private:
    frame_of<Request> frame_{};
    result<response> outcome_{errc::pending};
};

template <typename To, pdu Request> single_question(To, Request) -> single_question<Request>;

} // namespace rtuwire
