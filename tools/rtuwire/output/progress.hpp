// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// How far a long command is, on the error output: one line that changes on a terminal, a line now and then elsewhere.
#pragma once

#include <chrono>
#include <cstddef>
#include <string>

namespace tool {

class progress {
public:
    explicit progress(std::size_t steps);
    progress(progress const&) = delete;
    progress& operator=(progress const&) = delete;
    ~progress();

    /// So many steps are done; `note` stands behind them.
    void show(std::size_t done, std::string const& note);
    /// Takes the line away, before something else is written to the terminal.
    void clear();

private:
    std::string line_of(std::size_t done, std::string const& note) const;

    std::size_t steps_;
    std::size_t first_{0}; ///< steps that were done before this program began
    bool has_begun_{false};
    std::size_t shown_tenths_{0};
    bool is_terminal_;
    bool is_on_screen_{false};
    std::chrono::steady_clock::time_point began_{}; ///< when it was shown first
};

/// "1 h 5 min", "2 min 5 s", "7 s".
std::string time_in_words(std::chrono::seconds time);

} // namespace tool
