// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// The program of a client that is checked: started with its requests as words, and what it prints of them.
#pragma once

#include <chrono>
#include <optional>
#include <string>
#include <vector>

#include <sys/types.h>

namespace tool {

/// What it printed of one request: values, "ok", "error: no answer".
struct printed_line {
    std::chrono::steady_clock::time_point at;
    std::string text;
};

class client_process {
public:
    /// Ends where there is no such program. It is alone in a group of processes, and ended with all of it.
    explicit client_process(std::vector<std::string> const& words);
    client_process(client_process const&) = delete;
    client_process& operator=(client_process const&) = delete;
    ~client_process();

    /// Takes what it has printed, without a wait. False where it has ended, with all that it left running, and all was taken.
    bool look();

    /// Its lines that are an answer; others, of its own, are left out.
    std::vector<printed_line> const& printed() const { return printed_; }
    /// The last line of its standard error.
    std::string last_complaint() const;
    /// "ended with status 3", "was ended by signal 11"; empty where it ended with 0, or runs.
    std::string end() const;

private:
    static bool take(int& pipe, std::string& text);
    void end_group();

    pid_t pid_{-1};
    int output_{-1}, errors_{-1};
    std::string line_{}, complaints_{};
    std::vector<printed_line> printed_{};
    std::optional<int> status_{};
};

} // namespace tool
