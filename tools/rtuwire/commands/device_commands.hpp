// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// What backup, compare, restore and write do where a register file says what the unit has.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "choices.hpp"
#include "exit_status.hpp"
#include "line/line_words.hpp"
#include "line/open_line.hpp"
#include "words/value_words.hpp"

namespace tool {

/// A backup as it is written to a file, and what it is of.
struct backup_summary {
    std::string text;
    std::string of; ///< "atv320", "meter.toml"
    std::size_t rows;
    std::size_t refused; ///< rows without a value
};

backup_summary back_up_device(open_line& line, named_unit const& unit, std::string const& port, bool is_csv);
exit_status compare_device(choices const& chosen);

/// Writes a file's settings into a unit by the rules of `write`: those that differ, one register at a time, each read back.
exit_status restore_device(choices const& chosen);

/// `write` of values that are ready, each with a name of a register file.
exit_status write_values(choices const& chosen, open_line& line, std::vector<value_to_write> values);

} // namespace tool
