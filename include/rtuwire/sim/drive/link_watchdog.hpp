// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// How a drive supervises its serial link: after the first request, each next one must come within the time-out.
// Internal: may change with any version.
#pragma once

#include <rtuwire/core/time.hpp>
#include <rtuwire/core/version.hpp>

namespace rtuwire::inline RTUWIRE_BUILD::sim {

/// Whether requests keep coming.
class link_watchdog {
public:
    /// A request has come.
    constexpr void note_contact(instant now) noexcept
    {
        back_at_ = has_lost_ ? now : back_at_;
        has_lost_ = false;
        is_armed_ = true;
        last_ = now;
    }

    /// Whether the link was lost, and no request has come since.
    [[nodiscard]] constexpr bool has_lost() const noexcept { return has_lost_; }

    /// Whether requests have come again for a second: a drive that restarts by itself waits so long.
    [[nodiscard]] constexpr bool is_back(instant now) const noexcept
    {
        return not has_lost_ and now - back_at_ >= milliseconds(1'000);
    }

    /// Whether the time-out has passed since the last request, reported once; a time-out of 0 never passes.
    [[nodiscard]] constexpr bool is_lost(instant now, duration time_out) noexcept
    {
        bool const is_over =
            is_armed_ and time_out.microseconds != 0 and (now - last_).microseconds >= time_out.microseconds;
        if (is_over) {
            is_armed_ = false;
            has_lost_ = true;
        }
        return is_over;
    }

private:
    instant last_{0};
    instant back_at_{0};
    bool has_lost_{false};
    bool is_armed_{false};
};

} // namespace rtuwire::sim
