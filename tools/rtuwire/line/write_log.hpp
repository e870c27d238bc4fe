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
    std::string after; ///< what the unit holds; "unknown" where it could not be read back
};

/// Adds a line: time, user, port, unit, register, before, after. Why the file cannot be written; empty where it was.
std::string log_write(written_value const& what);

/// Ends the command where the log cannot be added to, before anything is written: it has no place, is something else than a
/// file, or may not be written. Makes an empty one where there is none.
void refuse_wrong_log();

/// How many orders to save to EEPROM the file has for a unit, this one included.
unsigned count_saves(std::string const& port, unsigned unit);

/// The file's name; empty where there is no home.
std::string write_log_file();

} // namespace tool
