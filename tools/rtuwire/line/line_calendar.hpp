// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// The calendar's time of what passes on a line, for days. Counted by the line's clock from one moment on: setting the
// system's clock moves no frame, and all who ask say the same.
#pragma once

#include <cstdint>

#include <rtuwire/client.hpp>

namespace tool {

class line_calendar {
public:
    line_calendar(rtuwire::instant now, std::uint64_t unix_microseconds) : at_{now}, unix_{unix_microseconds} {}

    /// At least every 35 minutes.
    void advance(rtuwire::instant now)
    {
        unix_ = of(now);
        at_ = now;
    }

    /// Microseconds since 1970, of an instant at most 35 minutes away from the last `advance`.
    std::uint64_t of(rtuwire::instant at) const
    {
        auto const ahead = static_cast<std::int32_t>((at - at_).microseconds);
        return static_cast<std::uint64_t>(static_cast<std::int64_t>(unix_) + ahead);
    }

    rtuwire::instant last() const { return at_; }

private:
    rtuwire::instant at_;
    std::uint64_t unix_;
};

} // namespace tool
