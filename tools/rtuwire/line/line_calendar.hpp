// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// The calendar's time of what passes on a line, for days. Counted by the line's clock from one moment on: setting the
// system's clock moves no frame, and all who ask say the same. It counts 64 bits, so that a program that was stopped
// for an hour goes on with the right time.
#pragma once

#include <chrono>
#include <cstdint>

#include <rtuwire/port.hpp>

namespace tool {

class line_calendar {
public:
    explicit line_calendar(std::uint64_t unix_microseconds)
        : start_{static_cast<std::int64_t>(unix_microseconds) - steady_microseconds()}
    {}

    /// Microseconds since 1970, of an instant of `steady_now` at most 35 minutes away from now.
    std::uint64_t of(rtuwire::instant at) const
    {
        std::int64_t const now = steady_microseconds();
        auto const ahead = static_cast<std::int32_t>(at.microseconds - static_cast<std::uint32_t>(now));
        return static_cast<std::uint64_t>(start_ + now + ahead);
    }

private:
    static std::int64_t steady_microseconds()
    {
        return std::chrono::duration_cast<std::chrono::microseconds>(rtuwire::host_time()).count();
    }

    std::int64_t start_; ///< when the line's clock showed 0
};

} // namespace tool
