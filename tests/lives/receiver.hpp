// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// What a controller's receiver makes of the responses on the line: its program gets them whole, in parts, late, with the one
// before or damaged. Bytes keep their order.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "lives/events.hpp"
#include "lives/judge.hpp"
#include "lives/setting.hpp"

namespace rtuwire::lives {

/// What the program gets of a response at once.
struct lump {
    moment due{0};
    std::size_t unit{0};
    std::uint16_t status{0}; ///< of the drive when it made the response
    std::vector<std::byte> response{};
    std::size_t begin{0}, end{0}; ///< of these bytes in it
    bool is_damaged{false};
    bool is_late{false};

    bool completes() const { return end == response.size() and not is_damaged; }
};

class receiver {
public:
    receiver(life_setting const& how, tally& counts)
        : how_{how}, counts_{counts}, chance_{how.seed * 3'266'489'917U + 5U}
    {}

    /// A response has come. What came before it is no longer kept.
    void take(std::size_t unit, std::uint16_t status, byte_view frame, moment now)
    {
        hold_back(now);
        lump all{now, unit, status, {frame.begin(), frame.end()}, 0, frame.size()};
        if (not chance_.happens(how_.in_parts_in_a_million)) {
            return lumps_.push_back(all);
        }
        constexpr moment never = ~moment{0};
        std::uint32_t const which = chance_.below(6);
        auto const size = static_cast<std::uint32_t>(frame.size());
        std::size_t const first = 1 + chance_.below(size - 1);
        moment const behind = now + (size - first) * 11'000'000ULL / how_.bits_per_second;
        moment const later = now + chance_.below(how_.longest_lateness());
        // The events are in the order of these.
        counts_.note(static_cast<event>(static_cast<unsigned>(event::answer_in_two_parts) + which));
        switch (which) {
        case 0: return put_in_two(all, first, now, behind);
        case 1: return put(all, 0, first, now);
        case 2: all.is_late = true; return put_in_two(all, first, now, later);
        case 3: all.is_late = true; return put(all, 0, size, later);
        case 4: return put(all, 0, first, never);
        default:
            all.is_damaged = true;
            all.response[first + chance_.below(size - static_cast<std::uint32_t>(first))] ^= std::byte{1}
                                                                                             << chance_.below(8);
            return put_in_two(all, first, now, behind);
        }
    }

    /// The program looks. It gets all of these at once.
    std::vector<lump> give(moment now)
    {
        auto const end = std::find_if(lumps_.begin(), lumps_.end(), [&](lump const& each) { return each.due > now; });
        std::vector<lump> given{lumps_.begin(), end};
        lumps_.erase(lumps_.begin(), end);
        return given;
    }
    static std::vector<std::byte> bytes_of(std::vector<lump> const& given)
    {
        std::vector<std::byte> bytes;
        for (lump const& each : given) {
            auto const from = each.response.begin();
            bytes.insert(bytes.end(), from + static_cast<std::ptrdiff_t>(each.begin),
                         from + static_cast<std::ptrdiff_t>(each.end));
        }
        return bytes;
    }

    /// A program that was not scheduled: half of them look at the time before they look here.
    void note_waking(moment now)
    {
        if (not is_empty()) {
            hold_back(now + chance_.below(2));
        }
    }
    /// It was switched off and on.
    void clear() { lumps_.clear(); }

    bool is_empty() const { return lumps_.empty(); }
    moment due() const { return is_empty() ? ~moment{0} : lumps_.front().due; }

private:
    void hold_back(moment until)
    {
        for (lump& each : lumps_) {
            each.due = until;
        }
    }
    void put(lump const& all, std::size_t begin, std::size_t end, moment due)
    {
        lumps_.push_back(all);
        lumps_.back().due = due;
        lumps_.back().begin = begin;
        lumps_.back().end = end;
    }
    void put_in_two(lump const& all, std::size_t first, moment due, moment rest_due)
    {
        put(all, 0, first, due);
        put(all, first, all.response.size(), rest_due);
    }

    life_setting const& how_;
    tally& counts_;
    detail::random_source chance_;
    std::vector<lump> lumps_{};
};

} // namespace rtuwire::lives
