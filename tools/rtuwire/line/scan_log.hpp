// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// What a scan has found so far, in a file that survives however the program ends: a line for each address.
#pragma once

#include <set>
#include <string>
#include <vector>

#include "files/regular_file.hpp"
#include "line/open_line.hpp"
#include "output/record.hpp"

namespace tool {

class scan_log {
public:
    /// Reads what the file has; without a file's name nothing is kept. Refuses a file that is something else, or damaged,
    /// with the line, and leaves it as it is.
    explicit scan_log(std::string const& file);

    bool is_done(line_setting const& how, std::uint8_t unit) const;
    std::vector<record> const& found() const { return found_; }

    void note_silent(line_setting const& how, std::uint8_t unit);
    void note_found(line_setting const& how, std::uint8_t unit, record const& line);

private:
    void read(std::string const& text);
    void write(std::string const& line);

    std::string file_;
    std::set<std::string> done_{};
    std::vector<record> found_{};
    appended_file out_{};
};

} // namespace tool
