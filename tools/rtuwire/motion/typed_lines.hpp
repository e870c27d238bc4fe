// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Lines that somebody types while something else goes on.
#pragma once

#include <optional>
#include <string>

namespace tool {

/// Throws away what was typed on the terminal of the standard input, and nobody has read. In the background the terminal is
/// somebody else's, and what a script has on its standard input is no typing: both stay.
void forget_typed() noexcept;

/// From a terminal alone: what a script has on its standard input is not meant for a motor.
class typed_lines {
public:
    typed_lines();

    /// The next line that was typed, without its end; never waits.
    std::optional<std::string> next();

    /// Throws away what was typed so far.
    void forget();

private:
    std::string typed_{};
    bool is_open_;
};

} // namespace tool
