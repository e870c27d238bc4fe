// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// Where a client stands in its transaction (SL 2.4.1).
#pragma once

#include <cstdint>

namespace rtuwire {

/// What leaves each phase of a client.
enum class client_phase : std::uint8_t {
    idle,         ///< start -> waiting
    waiting,      ///< t3.5 of silence, quarantine over -> ready; none in time -> settled (bus_jam)
    ready,        ///< poll_transmit -> transmitting; octets -> waiting, or settled where the question
                  ///< may not wait; too late -> settled
    transmitting, ///< sent -> awaiting, or turnaround after a broadcast; too late -> settled
    awaiting,     ///< the answer -> settled; time over or our answer damaged -> waiting, or settled;
                  ///< exception 05 or 06 -> pausing, or settled
    pausing,      ///< time over -> waiting
    turnaround,   ///< time over -> settled
    settled,      ///< poll_outcome -> idle
};

} // namespace rtuwire
