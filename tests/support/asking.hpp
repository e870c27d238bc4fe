// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// A client with one conversation of its own, for tests that ask frame by frame: `start` asks, `poll_outcome`
// takes what came of it, and every `advance` is a pass in which the conversation comes by.
#pragma once

#include <optional>

#include <rtuwire/client/client.hpp>

namespace rtuwire::test {

/// One frame as a question. What came of it is kept; its answer is a view of the client's memory.
class frame_question : public asker {
public:
    constexpr frame_question() noexcept = default;
    explicit constexpr frame_question(request const& question) noexcept : question_{question} {}

    constexpr std::optional<request> next() const noexcept
    {
        return settled() ? std::nullopt : question_;
    }
    constexpr void accept(result<response> const& outcome) noexcept { outcome_ = outcome; }
    [[nodiscard]] constexpr bool settled() const noexcept
    {
        return not question_ or outcome_.has_value();
    }

    /// The outcome, once.
    constexpr std::optional<result<response>> take() noexcept
    {
        if (not outcome_) {
            return std::nullopt;
        }
        auto const taken = outcome_;
        question_.reset();
        outcome_.reset();
        return taken;
    }
    [[nodiscard]] constexpr bool is_there() const noexcept { return question_.has_value(); }

private:
    std::optional<request> question_{};
    std::optional<result<response>> outcome_{};
};

/// The client that asks such questions.
template <typename Client> class asking : public Client {
public:
    using Client::Client;

    /// Asks. Errors: `busy` while an outcome was not taken, those of a question that the client refuses.
    constexpr result<void> start(request const& question, instant now)
    {
        return begin(question, now, std::nullopt);
    }
    constexpr result<void> start(request const& question, instant now, patience const& with)
    {
        return begin(question, now, with);
    }

    constexpr void advance(instant now)
    {
        now_ = now;
        Client::advance(now);
        come_by();
    }

    constexpr void cancel(instant now)
    {
        Client::cancel(now);
        if (question_.is_there() and not question_.settled() and not Client::is_busy()) {
            question_.accept(errc::cancelled);
        }
    }

    constexpr std::optional<result<response>> poll_outcome()
    {
        static_cast<void>(Client::deliver(question_, false, now_));
        return question_.take();
    }

    [[nodiscard]] constexpr bool is_busy() const
    {
        return question_.is_there() or Client::is_busy();
    }

private:
    constexpr result<void> begin(request const& question, instant now,
                                 std::optional<patience> const& with)
    {
        if (question_.is_there()) {
            return errc::busy;
        }
        now_ = now;
        with_ = with;
        question_ = frame_question{question};
        come_by();
        if (question_.settled() and not Client::is_busy()) {
            return question_.take()->error();
        }
        return {};
    }

    constexpr void come_by()
    {
        if (not question_.is_there() or question_.settled()) {
            return;
        }
        if (with_) {
            Client::converse(question_, now_, *with_);
        } else {
            Client::converse(question_, now_);
        }
    }

    frame_question question_{};
    std::optional<patience> with_{};
    instant now_{0};
};

} // namespace rtuwire::test
