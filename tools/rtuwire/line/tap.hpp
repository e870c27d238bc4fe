// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Listens to a line without a word to it.
#pragma once

#include <cstdint>
#include <functional>

#include <rtuwire/client.hpp>
#include <rtuwire/trace.hpp>

#include "choices.hpp"
#include "line/line_calendar.hpp"
#include "port/any_port.hpp"

namespace tool {

/// A frame that passed, or what a listener says besides; and the time since 1970, in microseconds.
struct tapped_frame {
    rtuwire::heard_frame const& heard;
    std::uint64_t unix_microseconds;
    rtuwire::line_timing const& wire; ///< times of the bytes on its line
};

using take_frame = std::function<void(tapped_frame const&)>;

/// Listens until the chosen time is over, somebody ends the program, or `goes_on` says no. Ends where the port fails.
void listen(any_port& port, choices const& chosen, line_calendar const& calendar, take_frame const& take,
            std::function<bool()> const& goes_on);

/// Opens the port that the choices name, without a word to it.
any_port open_to_listen(choices const& chosen);

} // namespace tool
