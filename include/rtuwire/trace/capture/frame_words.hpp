// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// Roles and verdicts in words: for people, and for the comments of packets in a capture.
#pragma once

#include <rtuwire/core/literal.hpp>
#include <rtuwire/core/version.hpp>
#include <rtuwire/trace/traced_frame.hpp>

namespace rtuwire::inline RTUWIRE_BUILD {

/// "request", "response" or "unknown".
[[nodiscard]] constexpr literal name(frame_role role) noexcept
{
    switch (role) {
    case frame_role::request: return "request";
    case frame_role::response: return "response";
    case frame_role::unknown: break;
    }
    return "unknown";
}

/// The name of the enumerator: "damaged".
[[nodiscard]] constexpr literal name(frame_verdict verdict) noexcept
{
    switch (verdict) {
    case frame_verdict::good: break;
    case frame_verdict::damaged: return "damaged";
    case frame_verdict::late: return "late";
    case frame_verdict::foreign: return "foreign";
    case frame_verdict::echo: return "echo";
    case frame_verdict::stray: return "stray";
    }
    return "good";
}

} // namespace rtuwire
