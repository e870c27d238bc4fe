// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Bytes as programs print them: "01 03", "0x01,0x03", "\x01\x03", "01:03", "[01][03]", lines of hexdump, xxd and od. A date
// or a time in front of the bytes, as logs have it, is no part of them.
#pragma once

#include <cstddef>
#include <istream>
#include <string>
#include <string_view>
#include <vector>

namespace tool {

/// Reads runs of bytes: each line is one, but for lines of a dump whose offset goes on where the line before ended.
class hex_lines {
public:
    explicit hex_lines(std::istream& from) : from_{from} {}

    /// The next run; false where there is no other. Ends the command (`ended`, usage) at what is no hexadecimal number,
    /// and names it and its place.
    bool next(std::vector<std::byte>& run);

private:
    struct line_start;
    line_start start_of(std::string_view line, std::size_t so_far) const;
    void add_words(std::string_view line, std::size_t at, std::vector<std::byte>& run) const;
    void add_word(std::string_view word, std::size_t column, std::vector<std::byte>& run) const;
    [[noreturn]] void refuse(std::string_view word, std::size_t column, std::string const& why) const;

    std::istream& from_;
    std::string line_{};
    bool has_line_{false};
    std::size_t number_{0};
};

} // namespace tool
