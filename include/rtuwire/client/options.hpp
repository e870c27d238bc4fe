// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// How patient a client is, and what it knows of its line.
#pragma once

#include <cstdint>

#include <rtuwire/core/time.hpp>
#include <rtuwire/core/version.hpp>

namespace rtuwire::inline RTUWIRE_BUILD {

/// How patient a client is with one unit.
struct patience {
    /// From the end of a request to the start of its answer; the time the answer itself takes on the
    /// line comes on top.
    duration response_timeout{milliseconds(1000)};
    /// How often a request is repeated after silence or a damaged answer; never after another
    /// exception than 05 and 06, and never for a broadcast.
    std::uint8_t retries{2};
    /// How often a request is repeated after the exceptions 05 (acknowledge) and 06 (busy).
    std::uint8_t busy_retries{3};
    /// The pause before the first of these repetitions; each further one is twice as long. Nothing
    /// else is asked on the line meanwhile.
    duration busy_pause{milliseconds(50)};
};

/// How patient a client is, and what its line does.
struct client_options {
    /// As in `patience`, for every unit that none is given for.
    duration response_timeout{milliseconds(1000)};
    /// From the end of a broadcast to the next request; units need it to act (SL 2.4.1).
    duration turnaround{milliseconds(100)};
    /// How much longer than `response_timeout` any unit on the line may take to answer. A unit that failed to
    /// answer in time is asked nothing new until all that it may still owe has come: client/quarantine.hpp
    /// derives how long that is. An answer that takes longer than both together may pass for another one's:
    /// RTU answers carry no number.
    duration late_answer{milliseconds(200)};
    /// As in `patience`.
    std::uint8_t retries{2};
    /// Whether the line gives back what is sent (two wires without receiver disable). Each octet is
    /// then held against the one sent; a difference is a `collision`. Without it, a request that comes back
    /// ends as `echoed` wherever it can be told from an answer; `echo_probe` finds out.
    bool has_echo{false};
    /// How many octets of noise before an answer are skipped: only octets that are not the unit's, and
    /// the answer must then be whole. Each one adds 1.5e-5 to the share of noise that passes a CRC, so
    /// none unless told.
    std::uint8_t skip_noise{0};
};

} // namespace rtuwire
