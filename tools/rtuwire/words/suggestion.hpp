// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// What somebody may have meant, as the end of a sentence.
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "words/words.hpp"

namespace tool {

/// "; did you mean 'scan'?", or nothing.
inline std::string suggestion(std::string_view word, std::span<std::string_view const> known)
{
    std::string_view const best = nearest_word(word, known);
    return best.empty() ? std::string{} : "; did you mean '" + std::string{best} + "'?";
}

} // namespace tool
