// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Values of neighbours in one word, which one request writes: `40-43=1,2,3,4`, `coil:0-2=on,off,on`,
// `setpoint,mode=21.5,heat`.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "words/register_words.hpp"
#include "words/words.hpp"

namespace tool {

struct value_block {
    std::vector<chosen_register> registers{}; ///< in rising order, without a hole; of one value none
    std::vector<std::string> words{}; ///< each value as a word of its own, "40=1"; of one value that as it was typed
    std::optional<refusal> refused{};
};

/// Why one request does not have registers as they stand, at most so many; empty where it has.
[[nodiscard]] std::string why_no_neighbours(std::vector<chosen_register> const& registers, unsigned most);

/// The values of a word "REG=VALUE". Of a drive several are refused: each is limited by what the one before it left.
[[nodiscard]] value_block values_in(std::string_view word, vocabulary const& meant);

} // namespace tool
