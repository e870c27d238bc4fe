// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Frames that were judged when they passed, by a listener, a client or a server: what was decided of each stays. Gives
// each response its request, and tells of requests without one, by the rules of the listener.
#pragma once

#include <cstdint>
#include <vector>

#include <rtuwire/client.hpp>
#include <rtuwire/trace.hpp>

#include "line/tap.hpp"

namespace tool {

class judged_frames {
public:
    judged_frames(rtuwire::line_timing const& wire, take_frame const& take) : wire_{wire}, take_{take} {}

    /// A frame, and the time of its last byte.
    void put(rtuwire::traced_frame const& frame, std::uint64_t unix_microseconds);
    /// A request that still waits got no response.
    void finish();

private:
    struct asked {
        std::vector<std::byte> bytes{};
        std::uint64_t end{0};
    };

    std::uint64_t start_of(rtuwire::heard_frame const& it, std::uint64_t at) const;
    void request(rtuwire::heard_frame& it, std::uint64_t at);
    void response(rtuwire::heard_frame& it, std::uint64_t at);
    void other(rtuwire::heard_frame& it, std::uint64_t at);
    void answer(rtuwire::heard_frame& it, std::uint64_t at, asked& which);
    /// The request that waits had its time, or something else came.
    void give_up(std::uint64_t at);
    void give_up_in_time(std::uint64_t start);

    rtuwire::line_timing wire_;
    take_frame const& take_;
    asked pending_{};
    asked given_up_{};
};

} // namespace tool
