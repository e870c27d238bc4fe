// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Who wrote what: a file that every write is added to, $XDG_STATE_HOME/rtuwire/writes.log, or ~/.local/state/...
#pragma once

#include <cstdint>
#include <string>

namespace tool {

struct written_value {
    std::string port;
    unsigned unit;
    std::string label;
    std::string before;
    std::string after;
};

/// Adds a line: time, user, port, unit, register, before, after. False where the file cannot be written.
bool log_write(written_value const& what);

/// How many orders to save to EEPROM the file has for a unit, this one included.
unsigned count_saves(std::string const& port, unsigned unit);

/// The file's name; empty where there is no home.
std::string write_log_file();

} // namespace tool
