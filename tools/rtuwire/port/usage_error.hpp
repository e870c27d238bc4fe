// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// What a program throws where a word of its command line is wrong, and the numbers in such words.
#pragma once

#include <cstdint>
#include <cstdlib>
#include <optional>
#include <stdexcept>
#include <string>

namespace tool {

/// A command line that cannot be followed; `what()` says why, and names the word.
struct usage_error : std::runtime_error {
    using std::runtime_error::runtime_error;
};

/// A whole decimal number of at most nine digits, or nothing.
inline std::optional<std::uint32_t> number_in(std::string const& word)
{
    bool const is_number =
        not word.empty() and word.size() < 10 and word.find_first_not_of("0123456789") == std::string::npos;
    if (not is_number) {
        return std::nullopt;
    }
    return static_cast<std::uint32_t>(std::strtoul(word.c_str(), nullptr, 10));
}

} // namespace tool
