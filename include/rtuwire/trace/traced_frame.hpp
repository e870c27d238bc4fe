// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// A frame as it passed on a line: its bytes, when, what it was, and how the one who saw it judged it. Knows neither a
// clock nor where it is kept.
#pragma once

#include <cstdint>

#include <rtuwire/core/bytes.hpp>
#include <rtuwire/core/literal.hpp>
#include <rtuwire/core/time.hpp>
#include <rtuwire/core/version.hpp>

namespace rtuwire {
inline namespace RTUWIRE_BUILD {

/// What a frame is, as far as its place on the line tells.
enum class frame_role : std::uint8_t { unknown, request, response };

/// How a frame passed.
enum class frame_verdict : std::uint8_t {
    good,    ///< undamaged, and part of an exchange
    damaged, ///< a wrong CRC, a receive error, or a size that its own bytes contradict
    late,    ///< a response after the time-out of its request
    foreign, ///< undamaged, and of an exchange of others
    echo,    ///< what this end sent itself, given back by the line
    stray,   ///< anything else: noise, or an undamaged frame that answers nothing
};

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

/// One frame, or the bytes that belong to none, in the pieces in which they arrived.
struct traced_frame {
    byte_view bytes; ///< address to CRC; valid until the sink returns
    instant at;      ///< when its last byte had left or arrived, by the clock of whoever traces
    frame_role role{frame_role::unknown};
    frame_verdict verdict{frame_verdict::good};
    bool is_own{false}; ///< sent by the end of the line that traces
};

/// What takes frames as they pass: `sink.take(frame)`. It is called inside `receive`, `advance` and `sent`; it must be
/// short, and must not call the client or the server that traces.
template <typename Sink>
concept frame_sink = requires(Sink& sink, traced_frame const& frame)
{
    {
        sink.take(frame)
    }
    noexcept;
};

} // namespace RTUWIRE_BUILD
} // namespace rtuwire
