// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Units that do not answer: while others are asked for, they are asked less and less often, so that none of them costs the
// others more than a time-out now and then. Knows no line and no clock.
#pragma once

#include <chrono>
#include <cstdint>
#include <map>

#include "line/asked_less.hpp"

namespace tool {

class silent_units {
public:
    using time = asked_less::clock::time_point;

    /// A request for this unit is next.
    void note_request(std::uint8_t unit, time now) { wanted_[unit] = now; }

    /// Whether it is asked, or said to be silent without a frame.
    [[nodiscard]] bool is_due(std::uint8_t unit, time now) const
    {
        auto const known = units_.find(unit);
        return known == units_.end() or known->second.is_due(now) or not is_other_wanted(unit, now);
    }

    /// It was asked. Whether that is news: it has fallen silent, or is back.
    bool note(std::uint8_t unit, bool has_responded, time now)
    {
        bool const was_silent = is_silent(unit);
        if (has_responded) {
            units_.erase(unit);
        } else {
            units_.try_emplace(unit, misses_allowed).first->second.note(false, now);
        }
        return was_silent == has_responded;
    }

    [[nodiscard]] bool is_silent(std::uint8_t unit) const { return units_.count(unit) > 0; }

    /// The line was away: nobody was silent.
    void forget() { units_.clear(); }

private:
    static constexpr unsigned misses_allowed = 1;
    static constexpr std::chrono::seconds lately{10};

    bool is_other_wanted(std::uint8_t unit, time now) const
    {
        for (auto const& [other, at] : wanted_) {
            if (other != unit and now - at < lately) {
                return true;
            }
        }
        return false;
    }

    std::map<std::uint8_t, asked_less> units_{}; ///< the silent ones
    std::map<std::uint8_t, time> wanted_{};      ///< when each was last asked for
};

} // namespace tool
