// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// The phases of a server, what happens to it, and where each leads: the table that the test holds it to and that the
// site draws.
#pragma once

#include <array>
#include <cstddef>

namespace rtuwire::test::server_table {

enum class phase { listening, asked, responding, transmitting };
enum class event {
    request,
    byte,
    damaged_byte,
    serve,
    serve_broadcast,
    poll_after_t3_5,
    poll_before,
    sent,
    time_limit
};
inline constexpr std::size_t phases = 4;
inline constexpr std::size_t events = 9;
inline constexpr std::array<char const*, phases> phase_names{"listening", "asked", "responding", "transmitting"};
inline constexpr std::array<char const*, events> event_names{"a whole request",
                                                             "another byte",
                                                             "damaged byte",
                                                             "serve",
                                                             "serve a broadcast",
                                                             "poll_transmit after t3.5",
                                                             "poll_transmit before t3.5",
                                                             "sent",
                                                             "time limit"};

/// The next phase, by phase and event, in the order of the enumerations. A broadcast waits in `asked` only.
inline constexpr auto next = [] {
    using enum phase;
    return std::array<std::array<phase, events>, phases>{{
        {asked, listening, listening, listening, listening, listening, listening, listening, listening},
        {asked, listening, asked, responding, listening, asked, asked, asked, listening},
        {asked, listening, responding, responding, responding, transmitting, responding, responding, listening},
        {transmitting, transmitting, transmitting, transmitting, transmitting, transmitting, transmitting, listening,
         listening},
    }};
}();

} // namespace rtuwire::test::server_table
