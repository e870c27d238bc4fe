// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
#include "monitor/sparkline.hpp"

#include <algorithm>
#include <cmath>
#include <string_view>

namespace tool {

namespace {

constexpr std::size_t heights = 8;
constexpr std::string_view blocks[heights]{"▁", "▂", "▃", "▄", "▅", "▆", "▇", "█"};
constexpr std::string_view letters[heights]{"_", ".", "-", "~", "+", "*", "%", "#"};

std::size_t height_of(double sample, double lowest, double highest)
{
    if (not std::isfinite(sample) or not(highest > lowest)) {
        return 0;
    }
    double const part = (sample - lowest) / (highest - lowest);
    return std::min(static_cast<std::size_t>(part * heights), heights - 1);
}

} // namespace

sample_range range_of(std::deque<double>::const_iterator first, std::deque<double>::const_iterator end)
{
    sample_range range{HUGE_VAL, -HUGE_VAL};
    for (auto each = first; each != end; ++each) {
        if (std::isfinite(*each)) {
            range = {std::min(range.lowest, *each), std::max(range.highest, *each)};
        }
    }
    return range;
}

std::string sparkline(std::deque<double> const& samples, std::size_t width, bool has_blocks)
{
    std::size_t const count = std::min(samples.size(), width);
    auto const first = samples.end() - static_cast<std::ptrdiff_t>(count);
    auto const [lowest, highest] = range_of(first, samples.end());
    std::string line(width - count, ' ');
    for (auto each = first; each != samples.end(); ++each) {
        std::size_t const height = height_of(*each, lowest, highest);
        line += not std::isfinite(*each) ? std::string_view{" "} : has_blocks ? blocks[height] : letters[height];
    }
    return line;
}

} // namespace tool
