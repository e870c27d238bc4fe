// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// What is counted while clients are served, and its text for Prometheus (text format 0.0.4).
#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <utility>

namespace tool {

/// What was asked for clients of a line.
struct client_counts {
    std::uint64_t requests{0}; ///< that were sent, repetitions counted
    std::uint64_t silences{0}; ///< that had no response in the end
};

class serve_counts {
public:
    std::size_t clients{0}; ///< that are connected
    std::size_t queue{0};   ///< requests that wait
    bool is_port_up{false};
    std::uint64_t connections{0};
    std::uint64_t port_losses{0};

    void note_request(std::uint8_t unit, std::uint8_t function) { ++requests_[{unit, function}]; }
    void note_exception(std::uint8_t unit, std::uint8_t code) { ++exceptions_[{unit, code}]; }
    void note_refused(std::string const& why) { ++refused_[why]; }
    void note_silence(std::uint8_t unit) { ++silences_[unit]; }
    /// A response has come, so long behind its request.
    void note_round_trip(std::uint8_t unit, std::chrono::duration<double> took)
    {
        auto& [sum, count] = round_trips_[unit];
        sum += took.count();
        ++count;
    }

    [[nodiscard]] std::string text() const;

    [[nodiscard]] std::uint64_t silences() const
    {
        std::uint64_t all = 0;
        for (auto const& [unit, count] : silences_) {
            all += count;
        }
        return all;
    }

private:
    using pair_counts = std::map<std::pair<std::uint8_t, std::uint8_t>, std::uint64_t>;

    pair_counts requests_{};   ///< by unit and function
    pair_counts exceptions_{}; ///< by unit and code
    std::map<std::string, std::uint64_t> refused_{};
    std::map<std::uint8_t, std::uint64_t> silences_{};
    std::map<std::uint8_t, std::pair<double, std::uint64_t>> round_trips_{}; ///< seconds, and how many
};

} // namespace tool
