// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// Words of a command line: compared without regard to case, matched with `*` and `?`, and, where one is wrong, the
// nearest right one.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace tool {

/// Why a word of the command line is refused.
struct refusal {
    std::string kind;      ///< a fixed word for programs: "unknown_register", "value_too_high"
    std::string culprit;   ///< the word, as it was typed
    std::string sentence;  ///< for people; names the culprit and what would be right
    std::string nearest{}; ///< the right word that is most like it, where there is one
};

[[nodiscard]] constexpr bool is_digit(char c) noexcept { return c >= '0' and c <= '9'; }

[[nodiscard]] std::string lower(std::string_view text);
[[nodiscard]] std::string upper(std::string_view text);

/// Whether two words are the same but for upper and lower case (of ASCII).
[[nodiscard]] bool is_same_word(std::string_view left, std::string_view right) noexcept;

/// The parts of a text, views of it that may be empty; a text without `between` is one.
[[nodiscard]] std::vector<std::string_view> parts_of(std::string_view text, std::string_view between = ",");

/// Whether a text holds another, without regard to case.
[[nodiscard]] bool holds_word(std::string_view text, std::string_view word);

/// Whether a word matches a pattern with `*` and `?`, without regard to case.
[[nodiscard]] bool matches(std::string_view pattern, std::string_view word) noexcept;

/// How many characters have to be changed, added or left out to make one word the other; two neighbours that changed
/// places count as one.
[[nodiscard]] std::size_t edit_distance(std::string_view left, std::string_view right);

/// The candidate that is most like a word; empty where none is like it.
[[nodiscard]] std::string_view nearest_word(std::string_view word, std::span<std::string_view const> candidates);

/// A whole number in decimal or, after 0x, hexadecimal; nothing where the text is anything else or above 65535.
[[nodiscard]] std::optional<std::uint16_t> word_number(std::string_view text) noexcept;

} // namespace tool
