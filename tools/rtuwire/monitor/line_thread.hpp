// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Reads the units of a line in a thread of its own, so that no silent unit holds up the keyboard or the screen.
#pragma once

#include <atomic>
#include <memory>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

#include "monitor/unit_reader.hpp"

namespace tool {

class line_thread {
public:
    /// Begins at once. `period` in seconds.
    line_thread(std::unique_ptr<open_line> line, std::vector<unit_reader> units, double period);
    line_thread(line_thread const&) = delete;
    line_thread& operator=(line_thread const&) = delete;
    /// Ends behind the request that is under way.
    ~line_thread();

    std::vector<shown_unit> units() const;
    /// Why it has ended; empty while it has not.
    std::string failure() const;
    std::string const& device() const { return device_; }

    void set_period(double seconds) { period_ = seconds; }
    /// Asks nothing while it is paused.
    void set_paused(bool is_paused) { is_paused_ = is_paused; }

private:
    void run();
    void rounds();
    void publish(std::size_t which);
    /// Reads what arrives late, so that it is not taken for a response; ends where the port does.
    void wait_for_next(unit_reader::clock::time_point began);

    std::unique_ptr<open_line> line_;
    std::string device_;
    std::vector<unit_reader> readers_;
    std::atomic<double> period_;
    std::atomic<bool> is_paused_{false};
    std::atomic<bool> shall_end_{false};
    mutable std::mutex guard_{};
    std::vector<shown_unit> shown_{};
    std::string failure_{};
    std::thread thread_{};
};

} // namespace tool
