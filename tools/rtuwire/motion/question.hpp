// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// A question to whoever sits at the terminal, before something moves.
#pragma once

#include <string>

#include "choices.hpp"

namespace tool {

/// Whether somebody is asked: on a terminal only, and not after --yes. The answer may take any time, so what was read of a
/// drive before the question is read again behind it.
bool is_asked(permissions const& allowed);

/// Asks on the terminal, and waits for a line. "y" and "yes" are a yes, in capitals as well; every other line is a no, and so
/// is a signal that asks for an end. What was typed before the question could be read, or together with the answer, is thrown
/// away: it is no answer, no order to the motor, and no command for the shell.
bool is_answered_yes(char const* question);

/// Says what will happen on the error output. Whether it may: where somebody is asked, by the answer.
bool may_go_on(permissions const& allowed, std::string const& what, char const* question);

} // namespace tool
