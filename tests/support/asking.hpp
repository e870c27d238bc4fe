// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// A client with one conversation of its own, for tests that ask frame by frame: `start` asks, `poll_outcome`
// takes what came of it, and every `advance` is a pass in which the conversation comes by.
#pragma once

#include <optional>

#include <rtuwire/client/client.hpp>

namespace rtuwire::test {

/// One frame as a request. What came of it is kept; its response is a view of the client's memory.
class frame_request : public asker {
public:
    constexpr frame_request() noexcept = default;
    explicit constexpr frame_request(request_frame const& request) noexcept : request_{request} {}

    constexpr std::optional<request_frame> next() const noexcept { return settled() ? std::nullopt : request_; }
    constexpr void accept(result<response> const& outcome) noexcept { outcome_ = outcome; }
    [[nodiscard]] constexpr bool settled() const noexcept { return not request_ or outcome_.has_value(); }

    /// The outcome, once.
    constexpr std::optional<result<response>> take() noexcept
    {
        if (not outcome_) {
            return std::nullopt;
        }
        auto const taken = outcome_;
        request_.reset();
        outcome_.reset();
        return taken;
    }
    [[nodiscard]] constexpr bool is_there() const noexcept { return request_.has_value(); }

private:
    std::optional<request_frame> request_{};
    std::optional<result<response>> outcome_{};
};

/// The client that asks such requests.
template <typename Client> class asking : public Client {
public:
    using Client::Client;

    /// Asks. Errors: `busy` while an outcome was not taken, those of a request that the client refuses.
    constexpr result<void> start(request_frame const& request, instant now)
    {
        return begin(request, now, std::nullopt);
    }
    constexpr result<void> start(request_frame const& request, instant now, retry_policy const& with)
    {
        return begin(request, now, with);
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
        if (request_.is_there() and not request_.settled() and not Client::is_busy()) {
            request_.accept(errc::cancelled);
        }
    }

    constexpr std::optional<result<response>> poll_outcome()
    {
        static_cast<void>(Client::deliver(request_, false, now_));
        return request_.take();
    }

    [[nodiscard]] constexpr bool is_busy() const { return request_.is_there() or Client::is_busy(); }

private:
    constexpr result<void> begin(request_frame const& request, instant now, std::optional<retry_policy> const& with)
    {
        if (request_.is_there()) {
            return errc::busy;
        }
        now_ = now;
        with_ = with;
        request_ = frame_request{request};
        come_by();
        if (request_.settled() and not Client::is_busy()) {
            return request_.take()->error();
        }
        return {};
    }

    constexpr void come_by()
    {
        if (not request_.is_there() or request_.settled()) {
            return;
        }
        if (with_) {
            Client::converse(request_, now_, *with_);
        } else {
            Client::converse(request_, now_);
        }
    }

    frame_request request_{};
    std::optional<retry_policy> with_{};
    instant now_{0};
};

} // namespace rtuwire::test
