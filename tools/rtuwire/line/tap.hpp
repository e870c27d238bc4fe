// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Listens to a line without taking part: to a port until it is over, or to a capture that is played back.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>

#include <rtuwire/trace.hpp>

#include "choices.hpp"
#include "port/any_port.hpp"

namespace tool {

/// A frame with its time since 1970, in microseconds.
struct tapped_frame {
    rtuwire::heard_frame const& heard;
    std::uint64_t unix_microseconds;
};

using take_frame = std::function<void(tapped_frame const&)>;

/// Listens until the time is over, somebody ends the program, or `goes_on` says no. Ends where the port fails.
void listen(any_port& port, std::optional<double> seconds, take_frame const& take,
            std::function<bool()> const& goes_on);

/// Opens the port that the choices name, without a word to it.
any_port open_to_listen(choices const& chosen);

} // namespace tool
