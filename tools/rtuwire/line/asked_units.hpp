// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Which units of a line are asked, and which of the words of the command line mean each.
#pragma once

#include <string>
#include <vector>

#include "line/line_words.hpp"

namespace tool {

/// Those that --unit lists: addresses, ranges and names, "3,7-9,fan". Refuses others. The register file of --device is of
/// those that nobody called a drive.
std::vector<named_unit> units_asked(line_choices const& line);

/// The same for `monitor`, which without --unit shows all that --name names.
std::vector<named_unit> units_watched(line_choices const& line);

/// "fan", or "unit7" where it has no name.
std::string name_of(named_unit const& unit);

/// The words that one of these units is asked: without a unit behind them, or with this one: `RFR@fan`, `input:40@7`. Refuses
/// those of a unit that is not asked.
std::vector<std::string> words_for(named_unit const& unit, std::vector<std::string> const& words,
                                   std::vector<named_unit> const& units);

} // namespace tool
