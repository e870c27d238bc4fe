// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Bytes as programs print them: "01 03", "0x01,0x03", "\x01\x03", "01:03", "[01][03]", "b'\x01\x03'", "1-3-0-13", lines of
// hexdump, xxd and od, logs with names, counters and times in front of the bytes.
#pragma once

#include <cstddef>
#include <istream>
#include <string>
#include <string_view>

#include "frame/line_runs.hpp"

namespace tool {

/// Reads runs of bytes: each line is one, but for lines of a dump whose offset goes on where the line before ended, and for
/// bytes that stand one on a line. A line of text alone is passed over, and so are a date and a time.
class hex_lines {
public:
    explicit hex_lines(std::istream& from) : from_{from} {}

    /// The next run; false where there is no other. Ends the command (`ended`, usage) at what may be bytes and is none, and
    /// names it and its place.
    bool next(byte_run& run);

    /// The line in which the latest run ends, from 1 on.
    [[nodiscard]] std::size_t number() const { return has_line_ ? number_ - 1 : number_; }

private:
    struct line_start;
    line_start start_of(std::string_view line, std::size_t so_far) const;
    bool next_line();
    void add_dump(std::string_view line, std::size_t from, byte_run& run) const;
    [[nodiscard]] byte_run read_line() const;
    [[noreturn]] void refuse(line_refusal const& what) const;

    std::istream& from_;
    std::string line_{};
    bool has_line_{false}; ///< one that was read and belongs to the next run
    std::size_t number_{0};
};

} // namespace tool
