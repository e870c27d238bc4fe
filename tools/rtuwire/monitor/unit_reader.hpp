// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Asks one unit what `monitor` shows of it. It only reads; a silent unit costs one request's time, and that less and
// less often.
#pragma once

#include <chrono>
#include <optional>
#include <string>
#include <vector>

#include "line/asked_less.hpp"
#include "line/line_words.hpp"
#include "line/register_reader.hpp"
#include "monitor/limits.hpp"
#include "monitor/model.hpp"

namespace tool {

/// What is asked of one unit.
struct unit_wish {
    named_unit unit;
    std::vector<std::string> words{}; ///< none: what its type shows by itself
    std::vector<std::string> plots{}; ///< words of what is plotted
    std::vector<value_limit> limits{};
    unsigned misses{2}; ///< so many rounds without a response in a row are a lost link
};

class unit_reader {
public:
    using clock = asked_less::clock;

    explicit unit_reader(unit_wish wish);

    /// One round, if it is due: a silent unit waits twice as long each time, up to 8 s. Throws `ended` where
    /// the port fails.
    void round(open_line& line, clock::time_point now);

    /// What there is to show.
    shown_unit const& shown() const { return shown_; }

private:
    void begin(drive_catalog const* drive);
    /// Of a unit that did not say who it is: why they are left out; empty where there is none.
    std::string leave_out_menu_numbers();
    /// False where it is silent.
    bool identify(open_line& line);
    bool read_state(open_line& line);
    void read_values(open_line& line);
    void miss_values();
    /// What all of them have by themselves, then what is typed, plotted and limited.
    void choose_all();
    /// Where they stand among the registers; none where it has none of that word.
    std::vector<std::size_t> choose_registers(std::string const& word);
    void note_lack(std::string const& word);
    void note_value(std::size_t which);
    void note_response(bool has_responded, clock::time_point now);

    /// A value, and since when its text is what it is.
    struct shown_before {
        std::string text{};
        std::optional<clock::time_point> changed{};
        std::optional<value_limit> limit{};
    };

    unit_wish wish_;
    asked_less patience_;
    bool is_known_{false};
    drive_catalog const* drive_{nullptr};
    std::vector<chosen_register> registers_{};
    std::vector<shown_before> before_{};
    std::optional<register_reader> state_reader_{};
    std::optional<register_reader> reader_{};
    clock::time_point began_{clock::now()};
    clock::time_point last_response_{clock::now()};
    shown_unit shown_{};
};

} // namespace tool
