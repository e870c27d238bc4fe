// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// A file of parameters as it is written: names and texts with their places, before anybody looks at what they mean.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "files/text_place.hpp"

namespace tool {

struct placed_text {
    std::string text;
    text_place place;
};

/// What is wrong in a file.
struct file_fault {
    text_place place;
    std::string sentence;
};

/// Texts by the names of their fields.
using saved_fields = std::map<std::string, placed_text, std::less<>>;

/// One parameter.
struct saved_row {
    text_place place;
    saved_fields fields;

    /// The text of a field; null where it is not there or empty.
    [[nodiscard]] placed_text const* find(std::string_view name) const
    {
        auto const found = fields.find(name);
        return found == fields.end() or found->second.text.empty() ? nullptr : &found->second;
    }
};

/// The file, or the first thing that is wrong in it.
struct saved_text {
    saved_fields head; ///< "drive", "time"
    std::vector<saved_row> rows;
    std::optional<file_fault> fault;
};

/// Reads a backup in JSON: an object with texts and numbers, and "parameters", an array of objects with texts and
/// numbers. A number stands as it was written.
[[nodiscard]] saved_text read_json_rows(std::string_view text);

/// Reads comma-separated values as programs for tables save them: with commas, semicolons or tabs, a byte order mark,
/// either line end. The first line names the columns; lines whose group is "backup" are the head.
[[nodiscard]] saved_text read_csv_rows(std::string_view text);

/// The names of the fields of a parameter.
[[nodiscard]] bool is_row_field(std::string_view name) noexcept;

} // namespace tool
