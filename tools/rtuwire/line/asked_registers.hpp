// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// The registers that the words of the command line mean, on the units that they mean.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "exit_status.hpp"
#include "line/line_words.hpp"
#include "line/open_line.hpp"
#include "words/register_words.hpp"

namespace tool {

struct asked_registers {
    named_unit unit;
    drive_catalog const* drive{
        nullptr}; ///< null where only places were typed and no drive was chosen, and where --drive says none
    std::vector<chosen_register> registers{};
    std::vector<refusal> lacks{};   ///< of several units: the words that this one does not know
    std::optional<ended> failure{}; ///< of several units: why this one is not read
    std::string unknown{};          ///< of several units: why nobody knows what this one is; its places are read
};

/// Of each unit. Asks a unit what it is only where a word needs its table, or is a number of some drive's menu. Refuses words
/// that name nothing: of several units, on any of them.
std::vector<asked_registers> registers_asked(std::vector<std::string> const& words,
                                             std::vector<named_unit> const& units, open_line& line);

/// Refuses words that none of the units can know, before anything is sent: one of which nobody said what it is may be any
/// drive.
void check_register_words(std::vector<std::string> const& words, std::vector<named_unit> const& units);

/// Whether a word means something on a unit of which somebody said what it is.
bool is_known_to(named_unit const& unit, std::string const& word);

/// Says on standard error which of several units are not read, and which words are not asked of whom.
void tell_left_out(std::vector<asked_registers> const& all);

/// The registers that words mean; refuses those that name nothing.
std::vector<chosen_register> registers_in(std::vector<std::string> const& words, vocabulary const& known);

/// Ends with a refusal's sentence.
[[noreturn]] void refuse(refusal const& why);

} // namespace tool
