// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// The registers that the words of the command line mean, on the unit that they mean.
#pragma once

#include <vector>

#include "choices.hpp"
#include "line/line_words.hpp"
#include "line/open_line.hpp"
#include "words/register_words.hpp"

namespace tool {

struct asked_registers {
    named_unit unit;
    drive_catalog const*
        drive; ///< null where only places were typed and no drive was chosen, and where --drive says none
    std::vector<chosen_register> registers;
};

/// Asks the unit what it is only where a word needs its table, or is a number of some drive's menu. Refuses words that
/// name nothing.
asked_registers registers_asked(choices const& chosen, open_line& line);

/// The registers that words mean; refuses those that name nothing.
std::vector<chosen_register> registers_in(std::vector<std::string> const& words, vocabulary const& known);

/// Ends with a refusal's sentence.
[[noreturn]] void refuse(refusal const& why);

} // namespace tool
