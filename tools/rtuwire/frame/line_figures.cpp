// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
#include "frame/line_figures.hpp"

#include <algorithm>

namespace tool {

using rtuwire::frame_role;
using rtuwire::frame_verdict;

double unit_figures::quantile(double share) const
{
    if (response_times.empty()) {
        return 0;
    }
    std::vector<std::uint32_t> sorted = response_times;
    auto const at = static_cast<std::ptrdiff_t>(share * static_cast<double>(sorted.size() - 1));
    std::ranges::nth_element(sorted, sorted.begin() + at);
    return sorted[static_cast<std::size_t>(at)] / 1'000.0;
}

void line_figures::note_silence(std::uint64_t begin)
{
    if (frames_ == 0 or begin <= last_) {
        return;
    }
    auto const silence = static_cast<double>(begin - last_);
    shortest_silence_ = shortest_silence_ == 0 ? silence : std::min(shortest_silence_, silence);
    too_close_ += silence < timing_.t3_5().microseconds ? 1U : 0U;
}

void line_figures::take(rtuwire::heard_frame const& heard, std::uint64_t unix_microseconds)
{
    if (heard.is_unanswered) {
        ++units_[heard.unit()].unanswered;
        return;
    }
    std::size_t const size = heard.frame.bytes.size();
    bytes_ += size;
    if (heard.frame.verdict == frame_verdict::stray and heard.frame.role == frame_role::unknown) {
        stray_bytes_ += size;
        return;
    }
    note_silence(unix_microseconds - timing_.characters(size).microseconds);
    first_ = frames_ == 0 ? unix_microseconds : first_;
    last_ = unix_microseconds;
    ++frames_;
    unit_figures& unit = units_[heard.unit()];
    if (heard.frame.verdict == frame_verdict::damaged) {
        ++unit.damaged;
    } else if (heard.frame.role == frame_role::request) {
        ++unit.requests;
    } else if (heard.frame.role == frame_role::response) {
        ++(heard.is_exception() ? unit.refused : unit.answered);
        unit.response_times.push_back(heard.response_time.microseconds);
    }
}

double line_figures::seconds() const { return static_cast<double>(last_ - first_) / 1e6; }

double line_figures::load() const
{
    double const busy = static_cast<double>(bytes_) * timing_.characters(1).microseconds / 1e6;
    return seconds() > 0 ? std::min(1.0, busy / seconds()) : 0;
}

std::array<std::uint64_t, line_figures::limits.size() + 1> line_figures::histogram() const
{
    std::array<std::uint64_t, limits.size() + 1> counts{};
    for (auto const& [number, unit] : units_) {
        for (std::uint32_t const time : unit.response_times) {
            auto const place = std::ranges::upper_bound(limits, time / 1'000U);
            ++counts[static_cast<std::size_t>(place - limits.begin())];
        }
    }
    return counts;
}

} // namespace tool
