// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// How long a client waits and how often it retries, and what it knows of its line.
#pragma once

#include <cstdint>

#include <rtuwire/core/time.hpp>
#include <rtuwire/core/version.hpp>

namespace rtuwire {
inline namespace RTUWIRE_BUILD {

/// The time-out and the retries for one unit.
struct retry_policy {
    /// From the end of a request to the start of its response; the time that the response itself takes on the line is
    /// added.
    duration response_timeout{milliseconds(1000)};
    /// How often a request is repeated after no response or a damaged one; never after an exception other than 05 and
    /// 06, and never for a broadcast.
    std::uint8_t retries{2};
    /// How often a request is repeated after the exceptions 05 (acknowledge) and 06 (busy).
    std::uint8_t busy_retries{3};
    /// The pause before the first of these repetitions; each further one is twice as long. No other request leaves on
    /// the line meanwhile.
    duration busy_pause{milliseconds(50)};
    /// The least time from a response to the next request to the same unit, and from a failed attempt to its repetition,
    /// for a unit that misses what comes sooner. Other units' requests go on between two requests, and a stop request
    /// does not wait for it. For a pause of all units see `line_timing::with_silence`.
    duration pause{};
};

/// A client's time-outs and retries, and the properties of its line.
struct client_options {
    /// As in `retry_policy`, for every unit that has no policy of its own.
    duration response_timeout{milliseconds(1000)};
    /// From the end of a broadcast to the next request; units need it to act (SL 2.4.1).
    duration turnaround{milliseconds(100)};
    /// How much longer than `response_timeout` any unit on the line may take to respond. A unit that failed to respond
    /// in time gets no new request until all its outstanding responses must have come: client/line/quarantine.hpp
    /// derives how long that is. A response that takes longer than both together may be taken for the response to
    /// another request: RTU responses carry no number.
    duration late_response{milliseconds(200)};
    /// As in `retry_policy`.
    std::uint8_t retries{2};
    /// Whether the line returns what is sent (two wires without receiver disable). Each byte is then compared with the
    /// one sent; a difference is a `collision`. Without it, the first request that comes back ends as `line_echo`, wherever
    /// it can be told from a response; from then on echoes are taken out (see `has_seen_echo`) until a response comes
    /// without one, and after two of them a difference is a collision. `line_echo_probe` finds out before a write.
    bool has_line_echo{false};
    /// How many bytes of noise before a response are skipped: only bytes that differ from the unit's address, and the
    /// response must then be whole. Each one adds 1.5e-5 to the share of noise that passes a CRC, so the default is
    /// none.
    std::uint8_t max_leading_noise{0};

    friend constexpr bool operator==(client_options const&, client_options const&) noexcept = default;
};

} // namespace RTUWIRE_BUILD
} // namespace rtuwire
