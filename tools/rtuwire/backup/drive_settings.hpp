// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// The parameters of a drive on a line.
#pragma once

#include <string>

#include "backup/saved_settings.hpp"
#include "line/line_words.hpp"
#include "line/open_line.hpp"

namespace tool {

/// Reads every parameter of a unit. What it refuses is recorded with the exception. Ends the command where the unit does
/// not answer, is known to be another drive than --drive says, or tells none of them, or the port fails: part of a drive is no
/// backup. `head` says what was asked, and when.
saved_settings settings_of(open_line& line, named_unit const& unit, std::string const& port);

/// The factory values, as far as they are known and do not depend on the rating.
saved_settings factory_settings_of(drive_catalog const& drive);

/// A file's settings. Ends the command where the file cannot be read, or something is wrong in it, with the place.
/// `drive` is what --drive says.
saved_settings settings_of_file(std::string const& path, std::string const& drive);

/// The rows of a file, JSON or a table. Ends the command where it cannot be read, or is larger than any backup.
saved_text saved_text_of_file(std::string const& path);

/// Now, as a backup's head has it.
std::string time_of_backup();

/// "cabinet.json:12:7: ", or "cabinet.json: " for the whole of it.
std::string place_text(std::string const& path, text_place place);

} // namespace tool
