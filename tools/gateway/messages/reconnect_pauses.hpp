// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// How long to wait before the broker is tried again: longer each time, and not as long as any other gateway, so that a hundred
// of them do not come at once when their broker is back.
#pragma once

#include <algorithm>
#include <chrono>
#include <cstdint>
#include <random>
#include <string_view>

namespace tool::gateway {

class reconnect_pauses {
public:
    using duration = std::chrono::milliseconds;

    static constexpr duration first{1'000};
    static constexpr duration longest{30'000};
    /// A connection that lasted as long was a good one.
    static constexpr std::chrono::seconds good{10};

    /// `name`: of the gateway.
    explicit reconnect_pauses(std::string_view name)
    {
        std::uint32_t hash = 2'166'136'261U;
        for (char const each : name) {
            hash = (hash ^ static_cast<unsigned char>(each)) * 16'777'619U;
        }
        draws_.seed(hash == 0 ? 1 : hash);
    }

    /// From half of the pause to one and a half.
    duration next()
    {
        auto const half = pause_.count() / 2;
        auto const drawn = static_cast<duration::rep>(draws_() % static_cast<std::uint32_t>(pause_.count() + 1));
        pause_ = std::min(pause_ * 2, longest);
        return duration{half + drawn};
    }

    /// After a connection that lasted so long.
    void connection_lasted(std::chrono::nanoseconds time) { pause_ = time >= good ? first : pause_; }

private:
    std::minstd_rand draws_{};
    duration pause_{first};
};

} // namespace tool::gateway
