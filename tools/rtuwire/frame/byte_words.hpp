// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// The words of a line: which are bytes, in hexadecimal or decimal digits or in a literal of a script, and which are not.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace tool {

/// A word of a line, or the literal of a script.
struct line_word {
    std::size_t column{0};
    std::string text{};
    std::string before{};               ///< what parts it from the word in front, blanks as one
    std::vector<std::byte> bytes{};     ///< as hexadecimal digits; empty where it is not written so
    std::optional<std::byte> decimal{}; ///< as a decimal number
    bool is_literal{false};             ///< a text with escapes: a run of its own

    [[nodiscard]] bool is_byte() const { return not bytes.empty() or decimal.has_value(); }
    /// What looks like a number and is no byte: nobody's label.
    [[nodiscard]] bool is_wrong_number() const;
};

/// The words of a line from a column on.
[[nodiscard]] std::vector<line_word> words_in(std::string_view line, std::size_t from = 0);

/// Why a word is no byte.
[[nodiscard]] std::string why_no_byte(line_word const& word);

} // namespace tool
