// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// The end of the line that only listens, and hands on what the library's listener makes of it.
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

#include <rtuwire/client.hpp>
#include <rtuwire/trace.hpp>

namespace playground {

/// What takes the frames of a line; called inside of a pass.
class frame_taker {
public:
    virtual void take(rtuwire::heard_frame const& heard) = 0;

protected:
    ~frame_taker() = default;
};

class line_tap {
public:
    /// A request without a response after `limit` is unanswered.
    line_tap(rtuwire::line_timing const& timing, rtuwire::duration limit) : listener_{timing, limit} {}

    /// From here on frames are handed on; `taker` must outlive this end.
    void hand_to(frame_taker& taker) noexcept { taker_ = &taker; }

    /// Whether no frame is on the line, no request waits for its response, and the client does not go on at once.
    [[nodiscard]] bool is_free(rtuwire::instant now) const noexcept
    {
        constexpr rtuwire::duration pause = rtuwire::milliseconds(10);
        return arriving_.empty() and not is_asked_ and reached(now, last_ + pause);
    }

    // As an end of the line.
    void receive(rtuwire::byte_view bytes, rtuwire::instant now) noexcept
    {
        arriving_.insert(arriving_.end(), bytes.begin(), bytes.end());
        last_ = now;
        listener_.receive(bytes, now, [this](auto const& heard) { take(heard); });
    }
    void receive_error(rtuwire::instant now) noexcept
    {
        last_ = now;
        listener_.receive_error(now, [this](auto const& heard) { take(heard); });
    }
    static void sent(rtuwire::instant) noexcept {}
    void advance(rtuwire::instant now) noexcept
    {
        listener_.advance(now, [this](auto const& heard) { take(heard); });
    }
    static rtuwire::byte_view poll_transmit() noexcept { return {}; }
    rtuwire::deadline poll_deadline() const noexcept { return listener_.poll_deadline(); }

private:
    void take(rtuwire::heard_frame const& heard)
    {
        std::size_t const ended = std::min(heard.frame.bytes.size(), arriving_.size());
        arriving_.erase(arriving_.begin(), arriving_.begin() + static_cast<std::ptrdiff_t>(ended));
        bool const is_request = heard.frame.role == rtuwire::frame_role::request;
        constexpr std::byte everyone{0};
        is_asked_ = is_request and not heard.frame.bytes.empty() and heard.frame.bytes[0] != everyone;
        if (taker_ != nullptr) {
            taker_->take(heard);
        }
    }

    rtuwire::line_listener listener_;
    frame_taker* taker_{nullptr};
    std::vector<std::byte> arriving_{}; ///< the bytes of a frame that has not ended yet
    rtuwire::instant last_{0};
    bool is_asked_{false};
};

} // namespace playground
