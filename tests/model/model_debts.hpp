// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// What units owe (rules 17 to 19): a model that shares no code with the headers.
#pragma once

#include "model_line.hpp"

namespace model {

/// The sendings of one request.
struct sendings {
    unsigned unanswered{0};
    microseconds first{0};   ///< when the first of them had left, since nothing was unanswered
    microseconds begun{0};   ///< rule 17's b
    microseconds allowed{0}; ///< rule 17's c

    /// One that took at most `leaving` to leave, and whose response may take `length`.
    void left(microseconds at, microseconds leaving, microseconds length)
    {
        if (unanswered == 0) {
            first = begun = at;
            allowed = 0;
        }
        begun = std::min(std::max(begun, at) + limited(length), at + longest);
        allowed = limited(allowed + leaving + limited(length));
        ++unanswered;
    }
    /// How long the response that came at `now` took, as the clock shows it.
    microseconds taken(microseconds now) const
    {
        return std::min<microseconds>(static_cast<std::uint32_t>(now - first), allowed);
    }
    void answered() { unanswered -= unanswered > 0 ? 1 : 0; }
};

/// The units that are asked nothing new.
class debts {
public:
    explicit debts(std::size_t places) : rows_(places) {}

    void hold(std::uint8_t unit, microseconds end, sendings const& without = {})
    {
        row* own = nullptr;
        for (row& each : rows_) {
            if (each.holds == some and each.unit == unit) {
                own = &each;
            }
        }
        for (std::size_t i = 0; own == nullptr and i < rows_.size(); ++i) {
            if (rows_[i].holds == nobody) {
                own = &rows_[i];
                *own = {some, unit, end, {}};
            }
        }
        if (own == nullptr) {
            own = &rows_.back();
            own->holds = everyone;
        }
        if (without.unanswered > 0) {
            bool const is_first = own->owes.unanswered == 0;
            own->owes.first = is_first ? without.first : own->owes.first;
            own->owes.allowed = limited((is_first ? 0 : own->owes.allowed) + without.allowed);
            own->owes.unanswered += without.unanswered;
        }
        own->put_off(end);
    }
    /// Rule 19: an answer that nobody waits for any more.
    void come_late(std::uint8_t unit, microseconds now, microseconds late)
    {
        auto const whose = std::find_if(rows_.begin(), rows_.end(), [&](row const& each) {
            return (each.holds == everyone or (each.holds == some and each.unit == unit)) and each.owes.unanswered > 0;
        });
        if (unit == 0 or whose == rows_.end()) {
            return;
        }
        whose->owes.answered();
        microseconds const once = whose->owes.allowed + late;
        microseconds const all = whose->owes.unanswered * limited(whose->owes.taken(now) + late);
        whose->put_off(now + limited(std::min(once, all)));
    }
    bool is_empty() const
    {
        return std::all_of(rows_.begin(), rows_.end(), [](row const& each) { return each.holds == nobody; });
    }
    bool covers(std::uint8_t unit) const
    {
        return unit != 0 and std::any_of(rows_.begin(), rows_.end(), [&](row const& each) {
                   return each.holds == everyone or (each.holds == some and each.unit == unit);
               });
    }
    /// Whether a time was over.
    bool advance(microseconds now)
    {
        bool ended = false;
        for (row& each : rows_) {
            if (each.holds != nobody and now >= each.end) {
                each = {};
                ended = true;
            }
        }
        return ended;
    }
    std::optional<microseconds> next() const
    {
        std::optional<microseconds> first;
        for (row const& each : rows_) {
            if (each.holds != nobody and (not first or each.end < *first)) {
                first = each.end;
            }
        }
        return first;
    }

private:
    enum whom { nobody, some, everyone };
    struct row {
        whom holds{nobody};
        std::uint8_t unit{0};
        microseconds end{0};
        sendings owes{};

        /// By the clock: an end that is over may look later, where no `advance` has ended it yet.
        void put_off(microseconds to) { end = static_cast<std::int32_t>(to - end) >= 0 ? to : end; }
    };
    std::vector<row> rows_;
};

} // namespace model
