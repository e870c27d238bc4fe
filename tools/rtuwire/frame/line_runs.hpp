// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Which words of a line are the bytes that passed, and whether they are hexadecimal or decimal.
//
// A run is words that are bytes, with no other between them. Where some part of the line, whole or up to where the words are
// parted otherwise ("000011-01 03", "0A (8 bytes)"), is frames with right CRCs, that is it: as hexadecimal numbers before
// decimal ones, and each such run of the line. Else it is the longest run, without the counter in front of it and a single
// number beside text.
#pragma once

#include <string>
#include <vector>

#include "frame/byte_words.hpp"

namespace tool {

/// Bytes that passed, as they are written.
struct byte_run {
    std::vector<std::byte> bytes{};
    bool is_decimal{false};              ///< in decimal digits
    std::vector<std::byte> or_decimal{}; ///< the same digits as decimal numbers, where neither has a right CRC
    bool is_single{false};               ///< one byte, alone on its line: what comes next may go on with it
};

/// What keeps a line from being read; empty where nothing does.
struct line_refusal {
    std::size_t column{0};
    std::string word{};
    std::string why{};
};

/// The bytes of a line's words: none where there is only text.
[[nodiscard]] byte_run run_in(std::vector<line_word> const& words, line_refusal& refusal);

} // namespace tool
