// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// How the tool ends, and the reasons that end it early. docs/tool.md lists the numbers for scripts.
#pragma once

#include <optional>
#include <stdexcept>
#include <string>

namespace tool {

enum class exit_status : int {
    done = 0,
    differs = 1,   ///< refused by the device, or not what was expected
    usage = 2,     ///< a word of the command line is wrong
    no_answer = 3, ///< nobody responded
    port = 4,      ///< the port, or the output, failed
    refused = 5,   ///< refused for safety
};

/// Ends the command; its text names the culprit.
class ended : public std::runtime_error {
public:
    ended(exit_status how, std::string const& why) : std::runtime_error{why}, status{how} {}

    exit_status status;
};

[[noreturn]] inline void refuse_word(std::string const& why) { throw ended{exit_status::usage, why}; }
[[noreturn]] inline void refuse_for_safety(std::string const& why) { throw ended{exit_status::refused, why}; }

/// What a judgement ends the command with, for who goes on all the same; nothing where it ends nothing.
template <typename Judge> [[nodiscard]] std::optional<ended> ended_by(Judge&& judge)
{
    try {
        judge();
    } catch (ended const& why) {
        return why;
    }
    return std::nullopt;
}

} // namespace tool
