// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// What the screen of `monitor` shows, as plain data: neither a line nor a terminal.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <deque>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "line/exchange_counts.hpp"

namespace tool {

/// One value of a unit, and what it was before.
struct shown_value {
    std::string label{}; ///< "RFR"
    std::string name{};  ///< "Output frequency"; empty where no table has it
    std::string text{};  ///< "50.0 Hz", or why it could not be read
    bool is_bad{false};  ///< it could not be read
    /// The oldest first; not a number where it could not be read. Empty for what is no number.
    std::deque<double> samples{};
    bool is_plotted{false};     ///< as --plot says; a key turns it round
    std::string outside{};      ///< by which limit it is too low or too high: "above 45 Hz"; empty where it is not
    double unchanged{HUGE_VAL}; ///< seconds since its text became another

    static constexpr std::size_t most_samples = 400;

    void add_sample(double sample)
    {
        samples.push_back(sample);
        if (samples.size() > most_samples) {
            samples.pop_front();
        }
    }
};

enum class link_state { waiting, linked, lost };

/// A unit of the line.
struct shown_unit {
    unsigned address{0};
    std::string name{};  ///< as the user calls it
    std::string drive{}; ///< "atv320"; empty while it is not known
    link_state link{link_state::waiting};
    double silent_seconds{0}; ///< since its last response, where the link is lost
    std::string state{};      ///< "operation enabled"; empty where it is no drive
    std::string fault{};      ///< "SLF1: Modbus interrupted"; empty without a fault
    std::string unread{};     ///< why a unit that responds does not tell its state; empty where it does
    bool is_local{false};     ///< its terminals or its keys command it
    std::string note{};       ///< what is wrong with it, or with what was asked of it
    std::string lacks{};      ///< which of the words that were typed are of other units
    std::vector<shown_value> values{};
    std::deque<double> times{}; ///< of the samples, in seconds
    exchange_counts counts{};

    void add_time(double seconds)
    {
        times.push_back(seconds);
        if (times.size() > shown_value::most_samples) {
            times.pop_front();
        }
    }

    bool has_alarm() const
    {
        return link == link_state::lost or is_local or not fault.empty() or not unread.empty() or not note.empty() or
               is_outside();
    }
    bool is_outside() const
    {
        return std::ranges::any_of(values, [](shown_value const& each) { return not each.outside.empty(); });
    }
};

/// All that is on the screen.
struct shown_screen {
    std::string port{};
    double period{0.5}; ///< seconds
    std::string time{}; ///< of the day
    std::vector<shown_unit> units{};
    std::size_t selected{0};
    std::size_t value{no_value};                            ///< of the selected unit
    std::set<std::pair<std::size_t, std::size_t>> turned{}; ///< units and values of which a key began or ended the plot
    bool is_paused{false};
    bool has_changed_only{false};
    bool has_times{false}; ///< of the responses, in the place of states
    bool has_bell{false};
    bool has_help{false};
    bool has_blocks{true}; ///< the terminal shows UTF-8
    std::string failure{}; ///< why the program ends; empty while it does not

    static constexpr std::size_t no_value = static_cast<std::size_t>(-1);

    bool is_plotted(std::size_t unit, std::size_t of) const
    {
        return units[unit].values[of].is_plotted != (turned.count({unit, of}) > 0);
    }
    std::size_t alarms() const
    {
        return static_cast<std::size_t>(std::ranges::count_if(units, &shown_unit::has_alarm));
    }
};

} // namespace tool
