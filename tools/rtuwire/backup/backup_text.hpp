// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// Settings as a file: JSON that a diff reads well, a parameter a line, or comma-separated values for people.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "backup/saved_settings.hpp"

namespace tool {

/// A parameter as it stands in a file.
struct backup_row {
    std::string group;
    unsigned address;
    std::string code;
    std::string menu;
    std::string raw; ///< empty where there is none
    bool is_raw_number;
    saved_value value;
    std::string name;
    std::string error;
};

struct backup_rows {
    std::vector<std::pair<std::string, std::string>> head;
    std::vector<backup_row> rows;
};

/// By group and address.
[[nodiscard]] backup_rows rows_of(saved_settings const& settings);

[[nodiscard]] std::string json_text_of(backup_rows const& all);
[[nodiscard]] std::string csv_text_of(backup_rows const& all);

} // namespace tool
