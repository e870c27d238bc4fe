// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Bit rates and formats of a line of which nothing is known.
#pragma once

#include <string>
#include <vector>

#include "line/open_line.hpp"

namespace tool {

/// In the order in which they are tried: those that devices are delivered with come first. 8N2 stands for 8N1 as well: a
/// receiver looks at the first stop bit only, so whoever sends two is understood by a unit with one, and hears it.
std::vector<line_setting> const& usual_settings();

bool is_same_setting(line_setting const& one, line_setting const& other);

/// "38400 8N2".
std::string words_of(line_setting const& how);

/// " -b 38400 -f 8N2", as a shown command has it.
std::string typed_rate(line_setting const& how);

/// Behind a setting that was found; empty where nothing is to be said of it.
std::string note_of_format(line_setting const& how);

/// Refuses a port that has no bit rate of its own to find: `option` is what asked for one.
void refuse_without_rate(line_choices const& line, std::string const& option);

/// Whether a line has a bit rate that this program sets.
bool has_rate(line_choices const& line);

/// Whether it is a server of Modbus TCP.
bool is_modbus_tcp(line_choices const& line);

} // namespace tool
