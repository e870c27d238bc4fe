// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
#include "monitor/plot.hpp"

#include <algorithm>
#include <cmath>

#include "monitor/sparkline.hpp"

namespace tool {

namespace {

/// Dots, which characters show by `across` times `down`.
class dots {
public:
    dots(std::size_t width, std::size_t height, bool has_blocks)
        : across_{has_blocks ? 2U : 1U}, down_{has_blocks ? 4U : 2U}, width_{width},
          cells_(height, row(width, 0)), has_blocks_{has_blocks}
    {}

    std::size_t columns() const { return width_ * across_; }
    std::size_t rows() const { return cells_.size() * down_; }

    /// From the upper left.
    void set(std::size_t x, std::size_t y)
    {
        // The numbers of braille's dots: the left column, the right one, and below both the fourth row.
        constexpr unsigned char braille[4][2]{{0x01, 0x08}, {0x02, 0x10}, {0x04, 0x20}, {0x40, 0x80}};
        unsigned char& cell = cells_[y / down_][x / across_];
        cell |= has_blocks_ ? braille[y % down_][x % across_] : static_cast<unsigned char>(1U << y % down_);
    }

    std::vector<std::string> lines() const
    {
        std::vector<std::string> all;
        for (row const& each : cells_) {
            std::string& line = all.emplace_back();
            for (unsigned char const cell : each) {
                line += has_blocks_ ? braille_of(cell) : std::string{" '.:"[cell]};
            }
        }
        return all;
    }

private:
    using row = std::vector<unsigned char>;

    /// U+2800 and the dots, in UTF-8.
    static std::string braille_of(unsigned char cell)
    {
        return cell == 0 ? std::string{' '}
                         : std::string{'\xE2', static_cast<char>(0xA0 | (cell >> 6U)),
                                       static_cast<char>(0x80 | (cell & 0x3FU))};
    }

    std::size_t across_;
    std::size_t down_;
    std::size_t width_;
    std::vector<row> cells_;
    bool has_blocks_;
};

} // namespace

std::vector<std::string> plot(std::deque<double> const& samples, std::size_t width, std::size_t height, bool has_blocks)
{
    dots all{width, height, has_blocks};
    std::size_t const count = std::min(samples.size(), all.columns());
    auto const first = samples.end() - static_cast<std::ptrdiff_t>(count);
    sample_range const range = range_of(first, samples.end());
    std::size_t const bottom = std::max<std::size_t>(all.rows(), 1) - 1;
    auto const row_of = [&](double sample) {
        double const part = range.highest > range.lowest ? (sample - range.lowest) / (range.highest - range.lowest) : 0;
        return bottom - static_cast<std::size_t>(std::lround(part * static_cast<double>(bottom)));
    };
    for (std::size_t i = 0; i < count and all.rows() > 0; ++i) {
        double const now = first[static_cast<std::ptrdiff_t>(i)];
        if (not std::isfinite(now)) {
            continue;
        }
        double const before = i == 0 ? now : first[static_cast<std::ptrdiff_t>(i) - 1];
        auto const [high, low] = std::minmax({row_of(now), row_of(std::isfinite(before) ? before : now)});
        std::size_t const last = low == row_of(now) ? low : low - 1; // the one before has its own dot
        std::size_t const begin = high == row_of(now) ? high : high + 1;
        for (std::size_t y = begin; y <= last; ++y) {
            all.set(all.columns() - count + i, y);
        }
    }
    return all.lines();
}

} // namespace tool
