// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Options of a line in a table of TOML, as rtuwire.toml has them.
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "choices.hpp"
#include "files/toml_file.hpp"

namespace tool {

/// Changes what a table says of these options: "port", "baud", "format", "timeout", "retries", "pause", "echo", "rs485",
/// "listen". What is wrong ends the command, with the file, the line, the column and the word.
void read_line_options(std::string const& file, std::string const& text, toml::table const& from,
                       std::span<std::string_view const> names, line_choices& line);

} // namespace tool
