// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Notices that a program did not run for a while: it was stopped, or the machine slept.
#pragma once

#include <chrono>

#include <rtuwire/port.hpp>

namespace tool {

class missed_time {
public:
    /// More than `limit` between two looks is too long; `now` is the first look.
    explicit missed_time(std::chrono::nanoseconds limit, std::chrono::nanoseconds now = rtuwire::host_time()) noexcept
        : limit_{limit}, last_{now}
    {}

    /// To be asked in each pass: whether the last look is too long ago, or the clock went back.
    bool is_too_long(std::chrono::nanoseconds now = rtuwire::host_time()) noexcept
    {
        std::chrono::nanoseconds const passed = now - last_;
        last_ = now;
        return passed > limit_ or passed < std::chrono::nanoseconds{0};
    }

private:
    std::chrono::nanoseconds limit_;
    std::chrono::nanoseconds last_;
};

} // namespace tool
