// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Why a program that runs a motor has to stop it and end, whatever else it was about to do.
#pragma once

#include <cstring>
#include <optional>
#include <string>

#include "missed_time.hpp"
#include "say.hpp"
#include "signals.hpp"

namespace tool {

class reason_to_end {
public:
    /// More than `longest_pause` between two looks means that nobody minded the drive.
    explicit reason_to_end(std::chrono::nanoseconds longest_pause) : pause_{longest_pause} {}

    /// To be called in each pass, before anything is sent; true where it finds a reason. Once there is one, it stays.
    bool look()
    {
        bool const has_paused = pause_.is_too_long();
        if (why_) {
            return false;
        }
        if (noted.end != 0) {
            why_ = words_of_signal(noted.end);
        } else if (noted.suspend != 0) {
            why_ = "to be suspended";
        } else if (has_paused) {
            why_ = "this program did not run for a while: the order to run is gone";
        } else if (noted.resumed != 0) { // how long it was suspended does not matter; no signal but this tells
            why_ = "this program was suspended, or its terminal was closed: the order to run is gone";
        } else if (int const failure = standard_output.failure(); failure != 0) {
            why_ = std::string{"standard output: "} + std::strerror(failure);
        }
        return why_.has_value();
    }

    explicit operator bool() const { return why_.has_value(); }

    /// It in words; empty where there is none.
    std::string text() const { return why_.value_or(std::string{}); }

private:
    missed_time pause_;
    std::optional<std::string> why_{};
};

/// The status that a shell expects of a program that a signal ended; `otherwise` where none did.
inline int status_of_end(int otherwise) { return noted.end != 0 ? 128 + noted.end : otherwise; }

} // namespace tool
