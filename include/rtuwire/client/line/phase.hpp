// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// The phases of a client's transaction (SL 2.4.1), and where each input leads, for a request that may be repeated once
// more; a dot: the phase stays. `visits`: the asker does, on a quiet line; `transmit`: `poll_transmit`.
//
//                visits transmit   sent       bytes    response busy    damaged advance      time_over    cancel
//   idle         ready  .          .          .        .        .       .       .            .            .
//   waiting      ready  .          .          .        .        .       .       .            settled      settled
//   ready        .      handed_out .          waiting  waiting  waiting waiting .            settled      settled
//   handed_out   .      .          awaiting   .        .        .       .       transmitting transmitting .
//   transmitting .      .          awaiting   .        .        .       .       .            settled      .
//   awaiting     .      .          .          .        settled  pausing waiting .            waiting      settled
//   pausing      .      .          .          .        .        .       .       .            waiting      settled
//   turnaround   .      .          .          .        .        .       .       .            settled      .
//   settled      idle   .          .          .        .        .       .       .            .            .
//
// Where no repetition is left, awaiting ends as settled instead of pausing and waiting. Where the request may not be
// repeated at all, bytes settle it in ready, too. After a broadcast, `sent` and the end of the time of transmitting
// lead to turnaround. Where the request was cancelled while it left, `sent` settles it.
#pragma once

#include <cstdint>

#include <rtuwire/core/version.hpp>

namespace rtuwire {
inline namespace RTUWIRE_BUILD {

namespace detail {

/// What ends each phase of a client.
enum class client_phase : std::uint8_t {
    idle,         ///< a conversation's request -> waiting
    waiting,      ///< t3.5 of silence, and its asker visits -> ready; not in time -> settled (bus_jam)
    ready,        ///< poll_transmit -> handed_out; bytes -> waiting, or settled where the request
                  ///< may not wait; too late -> settled
    handed_out,   ///< advance -> transmitting, whose time limit starts here; sent: as in transmitting
    transmitting, ///< sent -> awaiting, or turnaround after a broadcast, or settled where it was cancelled
                  ///< or came back; too late -> settled
    awaiting,     ///< the response -> settled; time over or a damaged response of our unit -> waiting, or settled;
                  ///< exception 05 or 06 -> pausing, or settled
    pausing,      ///< time over -> waiting
    turnaround,   ///< time over -> settled
    settled,      ///< its asker takes the outcome or has given it up, or the next in turn finds it missing -> idle
};

/// The phase of a client. That of a copy, which nobody has asked: what was ready does not leave.
class kept_phase {
public:
    constexpr kept_phase(client_phase at) noexcept : at_{at} {}
    constexpr kept_phase(kept_phase const& original) noexcept
        : at_{original.at_ == client_phase::ready ? client_phase::waiting : original.at_}
    {}
    constexpr kept_phase& operator=(kept_phase const& original) noexcept { return *this = kept_phase{original}.at_; }
    constexpr kept_phase& operator=(client_phase at) noexcept
    {
        at_ = at;
        return *this;
    }
    [[nodiscard]] constexpr operator client_phase() const noexcept { return at_; }

private:
    client_phase at_;
};

/// Whether a request is between its start and its outcome.
[[nodiscard]] constexpr bool is_under_way(client_phase at) noexcept
{
    return at != client_phase::idle and at != client_phase::settled;
}

/// Whether the request is with the transmitter.
[[nodiscard]] constexpr bool is_leaving(client_phase at) noexcept
{
    return at == client_phase::handed_out or at == client_phase::transmitting;
}

} // namespace detail

} // namespace RTUWIRE_BUILD
} // namespace rtuwire
