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
void put_unit_titles(text_line& line, bool has_times);

/// Name, address, drive, state in words; where there is room, its first value and the curve of it.
void put_unit(text_line& line, shown_unit const& unit, std::size_t width, bool has_blocks);

/// Instead of the state: how long its responses took, and what failed.
void put_times(text_line& line, shown_unit const& unit);

/// "8.2 ms, longest 24.1; 3 of 1204 failed".
std::string counts_text(exchange_counts const& counts);

struct value_marks {
    bool is_chosen{false};
    bool is_plotted{false};
};

/// Label, name, value, curve.
void put_value(text_line& line, shown_value const& value, value_marks marks, std::size_t width, bool has_blocks);

/// Seconds behind which a value that changed is not among the changed ones any more.
inline constexpr double faded = 10;

/// Of which unit it is, too; it fades.
void put_changed(text_line& line, shown_unit const& unit, shown_value const& value, std::size_t width, bool has_blocks);

/// A title and the curve below it.
std::vector<text_line> plot_of(shown_unit const& unit, shown_value const& value, std::size_t width, std::size_t height,
                               bool has_blocks);

/// "fan: unit 7, atv320, operation enabled".
std::string title_of(shown_unit const& unit);

/// What is wrong, a sentence each: the fault, the lost link, local control, what could not be asked.
std::vector<std::string> alarms_of(shown_unit const& unit);

} // namespace tool
