// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// One of several units that does not respond is asked less and less often, so that it does not hold up the others.
#pragma once

#include <algorithm>
#include <chrono>

namespace tool {

class asked_less {
public:
    using clock = std::chrono::steady_clock;

    static constexpr std::chrono::seconds longest_wait{8};

    /// So many rounds without a response in a row, and it is silent; then asked after that long at most.
    explicit asked_less(unsigned misses, clock::duration longest = longest_wait)
        : misses_allowed_{misses}, longest_{longest}
    {}

    bool is_due(clock::time_point now) const { return now >= next_; }
    bool is_silent() const { return misses_ >= misses_allowed_; }

    /// Behind a round. A silent one waits twice as long each time.
    void note(bool has_responded, clock::time_point now)
    {
        misses_ = has_responded ? 0 : misses_ + 1;
        if (is_silent()) {
            auto const wait = std::chrono::milliseconds{250} * (1 << std::min(misses_ - misses_allowed_, 5U));
            next_ = now + std::min<clock::duration>(wait, longest_);
        }
    }

private:
    unsigned misses_allowed_; ///< 1 at least
    clock::duration longest_;
    unsigned misses_{0};
    clock::time_point next_{};
};

} // namespace tool
