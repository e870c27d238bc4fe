// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// What a line does with its time: response times and errors by unit, silences between frames, load. For days: what it
// keeps does not grow with them.
#pragma once

#include <array>
#include <cstdint>
#include <map>

#include "frame/time_counts.hpp"
#include "line/tap.hpp"

namespace tool {

/// What was seen of one unit.
struct unit_figures {
    std::uint64_t requests{0};
    std::uint64_t answered{0};
    std::uint64_t refused{0};
    std::uint64_t unanswered{0};
    std::uint64_t damaged{0};
    time_counts response_times{};
};

class line_figures {
public:
    void take(tapped_frame const& it);

    std::map<std::uint8_t, unit_figures> const& units() const { return units_; }
    std::uint64_t frames() const { return frames_; }
    std::uint64_t stray_bytes() const { return stray_bytes_; }
    /// Frames that began less than t3.5 after the one before, as far as their times of arrival tell.
    std::uint64_t too_close() const { return too_close_; }
    /// Between frames, in milliseconds; 0 before there are two.
    double shortest_silence() const { return shortest_silence_ / 1'000.0; }
    /// How much of the time bytes were on the line, from 0 to 1.
    double load() const;
    /// Seconds from the first frame to the last.
    double seconds() const;
    /// How many response times are in each: below 1, 2, 5, 10, 20, 50, 100, 200, 500 ms, and above.
    static constexpr std::array<unsigned, 9> limits{1, 2, 5, 10, 20, 50, 100, 200, 500};
    std::array<std::uint64_t, limits.size() + 1> const& histogram() const { return histogram_; }

private:
    void note_silence(std::uint64_t begin, rtuwire::line_timing const& wire);
    void note_response(unit_figures& unit, rtuwire::heard_frame const& heard);

    std::map<std::uint8_t, unit_figures> units_{};
    std::array<std::uint64_t, limits.size() + 1> histogram_{};
    std::uint64_t frames_{0};
    std::uint64_t stray_bytes_{0};
    std::uint64_t too_close_{0};
    std::uint64_t first_{0};
    std::uint64_t last_{0};
    std::uint64_t busy_{0}; ///< microseconds
    double shortest_silence_{0};
};

} // namespace tool
