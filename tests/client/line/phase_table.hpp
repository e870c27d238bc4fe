// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// The phases of a client's transaction, what happens to it, and where each leads: the tables that the test holds it to
// and that the site draws.
#pragma once

#include <array>
#include <cstddef>

namespace rtuwire::test::client_table {

inline constexpr std::size_t inputs = 10;
inline constexpr std::array<char const*, inputs> input_names{"visits", "transmit", "sent",    "bytes",     "response",
                                                             "busy",   "damaged",  "advance", "time_over", "cancel"};
inline constexpr std::array<char const*, 9> phases{"idle",         "settled",  "waiting", "ready",     "handed_out",
                                                   "transmitting", "awaiting", "pausing", "turnaround"};

/// As in the header; without the names of the inputs, and without the phase that this request does not reach.
inline constexpr char const* of_several_sendings = R"(
idle         ready  .          .          .        .        .       .       .            .            .
waiting      ready  .          .          .        .        .       .       .            settled      settled
ready        .      handed_out .          waiting  waiting  waiting waiting .            settled      settled
handed_out   .      .          awaiting   .        .        .       .       transmitting transmitting .
transmitting .      .          awaiting   .        .        .       .       .            settled      .
awaiting     .      .          .          .        settled  pausing waiting .            waiting      settled
pausing      .      .          .          .        .        .       .       .            waiting      settled
settled      idle   .          .          .        .        .       .       .            .            .
)";
inline constexpr char const* of_one_sending = R"(
waiting      ready  .          .          .        .        .       .       .            settled      settled
ready        .      handed_out .          settled  settled  settled settled .            settled      settled
handed_out   .      .          awaiting   .        .        .       .       transmitting transmitting .
transmitting .      .          awaiting   .        .        .       .       .            settled      .
awaiting     .      .          .          .        settled  settled settled .            settled      settled
settled      idle   .          .          .        .        .       .       .            .            .
)";
inline constexpr char const* of_a_broadcast = R"(
waiting      ready  .          .          .        .        .       .       .            settled      settled
ready        .      handed_out .          waiting  waiting  waiting waiting .            settled      settled
handed_out   .      .          turnaround .        .        .       .       transmitting transmitting .
transmitting .      .          turnaround .        .        .       .       .            turnaround   .
turnaround   .      .          .          .        .        .       .       .            settled      .
settled      idle   .          .          .        .        .       .       .            .            .
)";

} // namespace rtuwire::test::client_table
