// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Which units `monitor` shows.
#pragma once

#include <string>
#include <vector>

#include "line/line_words.hpp"

namespace tool {

/// All that --name names; with --unit those that it lists: addresses, ranges and names, "3,7-9,fan". Refuses others.
std::vector<named_unit> units_watched(line_choices const& line);

/// Refuses words that are registers of no drive, before anything is sent.
void check_register_words(std::vector<std::string> const& words, std::vector<named_unit> const& units);

} // namespace tool
