// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// The screen of `monitor` as lines of text. It needs no terminal.
#pragma once

#include <cstddef>
#include <vector>

#include "monitor/model.hpp"
#include "monitor/text_line.hpp"

namespace tool {

inline constexpr std::size_t least_width = 80;
inline constexpr std::size_t least_height = 24;

/// As many lines as the height at most, none longer than the width. Where the terminal is smaller than 80x24, a sentence
/// that says so.
std::vector<text_line> draw(shown_screen const& shown, std::size_t width, std::size_t height);

/// "0.5 s", "1 s", "1 min".
std::string period_text(double seconds);

} // namespace tool
