// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Units that do not answer: while others are asked for, each of them is asked less and less often, and all of them together
// cost the others a tenth of the line at most, once they are known. Knows no line and no clock.
#pragma once

#include <algorithm>
#include <chrono>
#include <cstdint>
#include <map>
#include <set>

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
        if (known == units_.end() or not is_other_wanted(unit, now)) {
            return true;
        }
        // The one that has waited longest, of those that somebody wants.
        bool const is_another_first = std::ranges::any_of(units_, [&](auto const& each) {
            return each.second.tried < known->second.tried and each.second.pauses.is_due(now) and
                   was_wanted_lately(each.first, now);
        });
        return known->second.pauses.is_due(now) and now >= next_try_ and not is_another_first;
    }

    /// It was asked, which took so long. Whether that is news: it has fallen silent, or is back.
    bool note(std::uint8_t unit, bool has_responded, time now, asked_less::clock::duration cost)
    {
        bool const was_silent = is_silent(unit);
        if (has_responded) {
            units_.erase(unit);
            answered_.insert(unit);
        } else {
            silent_unit& it = units_[unit];
            it.pauses.note(false, now);
            it.tried = now;
            answered_.erase(unit);
            auto const share = parts_of_line * cost; // one try is free
            next_try_ = was_silent ? std::max(next_try_, now - share) + share : next_try_;
        }
        return was_silent == has_responded;
    }

    [[nodiscard]] bool is_silent(std::uint8_t unit) const { return units_.count(unit) > 0; }

    /// Whether it has answered what it was asked last.
    [[nodiscard]] bool has_answered(std::uint8_t unit) const { return answered_.count(unit) > 0; }

    /// The line was away: nobody was silent.
    void forget()
    {
        units_.clear();
        answered_.clear();
        next_try_ = {};
    }

private:
    struct silent_unit {
        asked_less pauses{1};
        time tried{};
    };

    static constexpr int parts_of_line = 10; ///< of which silent units have one
    static constexpr std::chrono::seconds lately{10};

    bool was_wanted_lately(std::uint8_t unit, time now) const
    {
        auto const at = wanted_.find(unit);
        return at != wanted_.end() and now - at->second < lately;
    }
    bool is_other_wanted(std::uint8_t unit, time now) const
    {
        return std::ranges::any_of(
            wanted_, [&](auto const& each) { return each.first != unit and was_wanted_lately(each.first, now); });
    }

    std::map<std::uint8_t, silent_unit> units_{}; ///< the silent ones
    std::set<std::uint8_t> answered_{};
    std::map<std::uint8_t, time> wanted_{}; ///< when each was last asked for
    time next_try_{};                       ///< of a silent one, whichever
};

} // namespace tool
