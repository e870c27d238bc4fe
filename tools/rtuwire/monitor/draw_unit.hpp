// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// The lines of one unit, and of one of its values, on the screen of `monitor`.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "monitor/model.hpp"
#include "monitor/text_line.hpp"

namespace tool {

/// The names of the columns of `put_unit`.
void put_unit_titles(text_line& line);

/// Name, address, drive, state in words; where there is room, its first value and the curve of it.
void put_unit(text_line& line, shown_unit const& unit, std::size_t width, bool has_blocks);

/// Label, name, value, curve.
void put_value(text_line& line, shown_value const& value, std::size_t width, bool has_blocks);

/// "fan: unit 7, atv320, operation enabled".
std::string title_of(shown_unit const& unit);

/// What is wrong, a sentence each: the fault, the lost link, local control, what could not be asked.
std::vector<std::string> alarms_of(shown_unit const& unit);

} // namespace tool
