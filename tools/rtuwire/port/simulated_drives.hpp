// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// Simulated drives in real time, on a pseudo-terminal, in a thread of this program: they end with it in every case, be it
// killed.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "port/port_word.hpp"

namespace tool {

/// A line of simulated drives. Ends them when it is destroyed: they fall silent, as without power. Can be moved.
class simulated_drives {
public:
    simulated_drives() noexcept;
    simulated_drives(simulated_drives&& other) noexcept;
    simulated_drives& operator=(simulated_drives&& other) noexcept;
    ~simulated_drives();

    /// Starts them, and returns when they hear: some 10 ms later. False where the system has no pseudo-terminal or thread
    /// to give; `failure()` says it.
    bool start(simulated_drives_choice const& choice);

    /// Ends them.
    void stop() noexcept;

    [[nodiscard]] bool is_running() const noexcept { return line_ != nullptr; }

    /// The addresses that somebody has there, in their order; empty where it was never started.
    [[nodiscard]] std::vector<std::uint8_t> const& units() const noexcept { return units_; }

    /// The serial device on which they answer; another program may open it.
    [[nodiscard]] std::string const& device() const noexcept { return device_; }

    [[nodiscard]] std::string const& failure() const noexcept { return failure_; }

private:
    class running_line;

    std::unique_ptr<running_line> line_{};
    std::vector<std::uint8_t> units_{};
    std::string device_{};
    std::string failure_{};
};

} // namespace tool
