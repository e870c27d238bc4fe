// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// A value that somebody wants in a register, on its way to the line, and what came of it.
#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace tool::gateway {

inline constexpr std::uint64_t longest_expiry = 60'000'000; ///< microseconds ahead

struct setting_request {
    std::size_t device;    ///< of `line_plan::devices`
    std::size_t value;     ///< of `device_plan::values`, one with `setting`
    std::string text;      ///< as it would be typed: "21.5", "heat", "true"
    std::uint64_t expires; ///< microseconds since 1970
    std::string id{};      ///< of whoever asked, given back with the answer
};

enum class setting_result : std::uint8_t { done, refused, expired, failed };

constexpr std::string_view name_of(setting_result result) noexcept
{
    switch (result) {
    case setting_result::done: return "done";
    case setting_result::refused: return "refused";
    case setting_result::expired: return "expired";
    case setting_result::failed: break;
    }
    return "failed";
}

/// A request that waits for its turn; expired by the calendar, or by the clock that nobody sets.
struct waiting_setting {
    setting_request request;
    std::chrono::steady_clock::time_point until;

    bool is_expired(std::chrono::steady_clock::time_point now, std::uint64_t unix_time) const
    {
        return now >= until or unix_time >= request.expires;
    }
};

inline constexpr char why_too_late[] = "it expired before it could be written";

/// Each request has one.
struct setting_answer {
    std::size_t device{0};
    std::size_t value{0};
    std::string id{};
    setting_result result{setting_result::failed};
    std::string why{}; ///< or what there is to know of what was done; may be empty
    std::uint64_t time{0};
};

} // namespace tool::gateway
