// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Who wrote what: a file that every write is added to, $XDG_STATE_HOME/rtuwire/writes.log, or ~/.local/state/...
#pragma once

#include <cstddef>
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

/// Why no such row could be added: the log has no place, is something else than a file, may not be written, or its disk
/// is full. Empty where there is room, which is kept where the file system can. Makes an empty one where there is none.
std::string why_nothing_can_be_noted(std::size_t rows = 1);

/// The same before anything is written: ends the command.
void refuse_wrong_log(std::size_t rows = 1);

/// How many orders to save to EEPROM the file has for a unit, this one included.
unsigned count_saves(std::string const& port, unsigned unit);

/// The file's name; empty where there is no home.
std::string write_log_file();

} // namespace tool
