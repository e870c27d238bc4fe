// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// How often which times were: counts by length, in steps of less than one in a hundred, so that days of them take no
// more memory than minutes.
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace tool {

class time_counts {
public:
    void add(std::uint32_t microseconds)
    {
        std::size_t const place = place_of(microseconds);
        if (place >= counts_.size()) {
            counts_.resize(place + 1);
        }
        ++counts_[place];
        ++all_;
        shortest_ = all_ == 1 or microseconds < shortest_ ? microseconds : shortest_;
        longest_ = microseconds > longest_ ? microseconds : longest_;
    }

    /// A share of the times is at most this, in milliseconds, to within one in a hundred; the shortest (0) and the
    /// longest (1) exactly. 0 where there is none.
    double quantile(double share) const
    {
        if (all_ == 0) {
            return 0;
        }
        auto left = static_cast<std::uint64_t>(share * static_cast<double>(all_ - 1));
        std::size_t place = 0;
        while (left >= counts_[place]) {
            left -= counts_[place];
            ++place;
        }
        std::uint32_t const middle = middle_of(place);
        std::uint32_t const found = share <= 0 ? shortest_ : share >= 1 ? longest_ : limited(middle);
        return found / 1'000.0;
    }

private:
    /// Exact below 128 microseconds; above, 64 steps in each doubling.
    static constexpr unsigned exact = 128;
    static constexpr unsigned steps = 64;

    static std::size_t place_of(std::uint32_t time)
    {
        if (time < exact) {
            return time;
        }
        auto const doublings = static_cast<unsigned>(std::bit_width(time)) - 7U;
        return exact + (doublings - 1) * steps + (time >> doublings) - steps;
    }
    static std::uint32_t middle_of(std::size_t place)
    {
        if (place < exact) {
            return static_cast<std::uint32_t>(place);
        }
        auto const doublings = static_cast<unsigned>((place - exact) / steps + 1);
        auto const step = static_cast<std::uint32_t>((place - exact) % steps + steps);
        return (step << doublings) + (std::uint32_t{1} << (doublings - 1));
    }
    std::uint32_t limited(std::uint32_t time) const
    {
        return time < shortest_ ? shortest_ : time > longest_ ? longest_ : time;
    }

    std::vector<std::uint64_t> counts_{};
    std::uint64_t all_{0};
    std::uint32_t shortest_{0};
    std::uint32_t longest_{0};
};

} // namespace tool
