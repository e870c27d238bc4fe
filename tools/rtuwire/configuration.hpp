// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// The configuration file: what a person types each time for the line of a cabinet, and names for its units. A few lines of
// TOML:
//     port = "/dev/ttyUSB0"
//     name = ["fan=7:atv320", "pump=3:atv12"]
// It never allows anything: --write and --allow-run are typed.
#pragma once

#include <optional>
#include <string>

#include "choices.hpp"

namespace tool {

/// The file to read where none is named: ./rtuwire.toml, or rtuwire.toml in $XDG_CONFIG_HOME (~/.config where that is not
/// set); nothing where there is neither.
[[nodiscard]] std::optional<std::string> configuration_file();

/// Changes what the file speaks of. What is wrong in it ends the command, with the file, the line, the column and the word.
void read_configuration(std::string const& file, line_choices& line);

} // namespace tool
