// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// A device that a register file describes, simulated: it has the registers of the file and no others.
#pragma once

#include <memory>
#include <string>

#include "line/line_words.hpp"
#include "port/port_word.hpp"
#include "port/simulated_line.hpp"

namespace tool {

/// The device of a register file. Refuses a file that is wrong, with its place.
std::unique_ptr<simulated_drive> simulated_device(simulated_drive_choice const& choice,
                                                  rtuwire::line_timing const& timing);

/// Adds a drive, or the device of a register file.
template <typename Port>
void add_to(simulated_line<Port>& line, simulated_drive_choice const& choice, rtuwire::line_timing const& timing)
{
    if (is_register_file(choice.drive)) {
        line.add(simulated_device(choice, timing));
    } else {
        line.add(choice.drive, choice.unit);
    }
}

} // namespace tool
