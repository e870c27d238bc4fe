// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// The words of a command line: flags, some with a value. What is wrong with one is said with its name.
#pragma once

#include <cstdint>
#include <cstdio>
#include <string>

#include "../../tools/rtuwire/port/usage_error.hpp"

namespace examples {

using tool::number_in;
using tool::usage_error;

/// Flags one by one, each with the word behind it where it wants one.
class arguments {
public:
    arguments(int count, char** words) : count_{count}, words_{words} {}

    /// Goes to the next flag; false behind the last.
    bool next()
    {
        if (at_ >= count_) {
            return false;
        }
        flag_ = words_[at_++];
        return true;
    }

    std::string const& flag() const { return flag_; }

    /// The value of this flag, to be asked for once.
    std::string value()
    {
        bool const is_there = at_ < count_ and std::string{words_[at_]}.rfind("--", 0) != 0;
        if (not is_there or *words_[at_] == '\0') {
            throw usage_error{flag_ + " needs a value"};
        }
        return words_[at_++];
    }

    /// The value as a whole number.
    std::uint32_t number()
    {
        std::string const word = value();
        auto const found = number_in(word);
        if (not found) {
            throw usage_error{flag_ + " " + word + ": not a whole number"};
        }
        return *found;
    }

    /// Refuses this flag.
    [[noreturn]] void refuse() const
    {
        bool const is_flag = flag_.rfind('-', 0) == 0;
        throw usage_error{(is_flag ? "unknown flag " : "unexpected word ") + flag_};
    }

private:
    int count_;
    char** words_;
    int at_{1};
    std::string flag_{};
};

/// Whether somebody asks for help before anything else is looked at.
inline bool asks_for_help(int count, char** words)
{
    for (int i = 1; i < count; ++i) {
        if (std::string{words[i]} == "--help") {
            return true;
        }
    }
    return false;
}

/// A program's status: 0 with its usage on standard output for --help, 2 behind a usage error, otherwise that of
/// `run`.
template <typename Run> int with_usage(char const* program, std::string const& usage, int count, char** words, Run run)
{
    std::string const line = std::string{"usage: "} + program + " " + usage + "\n";
    if (asks_for_help(count, words)) {
        bool const is_written = std::fputs(line.c_str(), stdout) >= 0 and std::fflush(stdout) == 0;
        if (not is_written) {
            std::perror((std::string{program} + ": standard output").c_str());
        }
        return is_written ? 0 : 1;
    }
    try {
        return run();
    } catch (usage_error const& error) {
        std::fprintf(stderr, "%s: %s\n%s", program, error.what(), line.c_str());
        return 2;
    }
}

} // namespace examples
