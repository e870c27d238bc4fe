// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
#include <algorithm>
#include <cctype>

#include "../support/say.hpp"
#include "backup/drive_settings.hpp"
#include "exit_status.hpp"
#include "files/regular_file.hpp"
#include "output/plain_text.hpp"

namespace tool {

namespace {

constexpr std::size_t largest_backup = 4U << 20U;

/// A JSON text begins with a brace, whatever the file is called.
bool is_json(std::string_view text)
{
    std::size_t const first = text.find_first_not_of(" \t\r\n\xEF\xBB\xBF");
    return first != text.npos and (text[first] == '{' or text[first] == '[');
}

} // namespace

std::string place_text(std::string const& path, text_place place)
{
    return path +
           (place.line == 0 ? ": " : ":" + std::to_string(place.line) + ":" + std::to_string(place.column) + ": ");
}

saved_text saved_text_of_file(std::string const& path)
{
    file_text const file = text_of_file(path);
    if (not file.failure.empty()) {
        throw ended{exit_status::usage, path + ": " + file.failure};
    }
    if (file.text.size() > largest_backup) {
        refuse_word(path + ": is larger than any backup");
    }
    return is_json(file.text) ? read_json_rows(file.text) : read_csv_rows(file.text);
}

saved_settings settings_of_file(std::string const& path, std::string const& drive)
{
    settings_reading const read = settings_in(saved_text_of_file(path), drive);
    if (read.fault) {
        refuse_word(place_text(path, read.fault->place) + read.fault->sentence);
    }
    if (not drive.empty() and read.settings.drive != catalog_named(drive)) {
        refuse_word(path + " is of an " + std::string{read.settings.drive->name} + ", and --drive says " + drive);
    }
    for (file_fault const& each : read.left_out) {
        complain("rtuwire: %s\n", plain_text(place_text(path, each.place) + each.sentence).c_str());
    }
    return read.settings;
}

} // namespace tool
