// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// A curve in one line of text: a character for each sample, eight heights.
#pragma once

#include <cstddef>
#include <deque>
#include <string>

namespace tool {

/// Between which values samples are; where there is none, `lowest` is above `highest`.
struct sample_range {
    double lowest;
    double highest;
};
sample_range range_of(std::deque<double>::const_iterator first, std::deque<double>::const_iterator end);

/// The last `width` samples, the newest at the right, between the lowest and the highest of them; all low where they are
/// equal. What is not a number leaves a gap. Without blocks in characters of ASCII.
std::string sparkline(std::deque<double> const& samples, std::size_t width, bool has_blocks);

} // namespace tool
