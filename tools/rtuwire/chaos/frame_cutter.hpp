// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// The bytes of one direction as frames: one ends where its function's form and its CRC say so, anything else with silence. Nothing is lost or added, whatever comes.
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

#include <rtuwire/frames.hpp>
#include <rtuwire/trace.hpp>

#include "chaos/line_fault.hpp"
#include "frame/frame_fit.hpp"

namespace tool {

class frame_cutter {
public:
    frame_cutter(frame_way way, rtuwire::duration silence)
        : role_{way == frame_way::request ? rtuwire::frame_role::request : rtuwire::frame_role::response}, silence_{
                                                                                                               silence}
    {}

    template <typename Take> void receive(rtuwire::byte_view bytes, rtuwire::instant now, Take take)
    {
        held_.insert(held_.end(), bytes.begin(), bytes.end());
        last_ = now;
        while (std::size_t const size = frame_at_begin(held_, role_)) {
            hand_out(size, take);
        }
        while (held_.size() >= rtuwire::max_adu_size) {
            hand_out(rtuwire::max_adu_size, take);
        }
    }

    /// Time has passed.
    template <typename Take> void advance(rtuwire::instant now, Take take)
    {
        if (not held_.empty() and reached(now, last_ + silence_)) {
            hand_out(held_.size(), take);
        }
    }

    [[nodiscard]] rtuwire::deadline poll_deadline() const
    {
        return held_.empty() ? rtuwire::deadline{} : rtuwire::deadline{last_ + silence_};
    }

private:
    template <typename Take> void hand_out(std::size_t size, Take& take)
    {
        auto const end = held_.begin() + static_cast<std::ptrdiff_t>(size);
        std::vector<std::byte> const frame(held_.begin(), end);
        held_.erase(held_.begin(), end);
        take(rtuwire::byte_view{frame});
    }

    rtuwire::frame_role role_;
    rtuwire::duration silence_;
    std::vector<std::byte> held_{};
    rtuwire::instant last_{0};
};

} // namespace tool
