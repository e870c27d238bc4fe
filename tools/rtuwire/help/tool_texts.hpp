// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// What the command line is made of, as help, completion and the man page say it. The command line itself is asked: nothing
// is written down twice.
#pragma once

#include <string>
#include <vector>

namespace tool {

struct option_text {
    std::vector<std::string> names; ///< "-p", "--port"
    std::string what;
    bool takes_value{false};
};

struct command_text {
    std::string name;
    std::string what;
    std::string operand{}; ///< "REG"; empty where it takes none
    std::string operand_what{};
    std::vector<option_text> options{};
    std::string example{};
};

struct tool_texts {
    std::string what;
    std::string version;
    std::vector<option_text> options; ///< of every command
    std::vector<command_text> commands;
};

/// A command line that does something sensible, and what it does; empty for no command.
[[nodiscard]] std::string example_of(std::string const& command);

/// What to type for a device of which nothing is known, in lines.
[[nodiscard]] std::string first_steps_text();

/// How a place of any device is typed, in lines.
[[nodiscard]] std::string places_text();

/// How a register file is written, in lines.
[[nodiscard]] std::string register_file_text();

/// A script for a shell: "bash" or "zsh"; empty for another one. After --drive it knows the drive's registers.
[[nodiscard]] std::string completion_script(tool_texts const& texts, std::string const& shell);

/// A page for man(1), in troff.
[[nodiscard]] std::string man_page(tool_texts const& texts);

} // namespace tool
