// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// A curve in several lines of text.
#pragma once

#include <cstddef>
#include <deque>
#include <string>
#include <vector>

namespace tool {

/// How many samples a plot of that width shows.
[[nodiscard]] constexpr std::size_t samples_of_plot(std::size_t width, bool has_blocks)
{
    return has_blocks ? 2 * width : width;
}

/// The last samples, the newest at the right, the lowest of them in the last line: two by four dots of a character (braille),
/// without blocks one by two of ASCII. Neighbours are joined; what is not a number leaves a gap.
std::vector<std::string> plot(std::deque<double> const& samples, std::size_t width, std::size_t height,
                              bool has_blocks);

} // namespace tool
