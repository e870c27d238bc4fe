// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// A device's registers by name, from a TOML file that somebody wrote: checked whole before anything is opened.
#pragma once

#include <cstddef>
#include <string>

#include "words/named_places.hpp"

namespace tool {

constexpr std::size_t most_registers = 2'000;

/// What a text of a register file says. Ends the command at the first thing that is wrong, with its line and column.
named_places read_register_file(std::string const& file, std::string const& text);

/// The file of --device, read once.
named_places const& register_file_at(std::string const& file);

} // namespace tool
