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

/// Asks on the terminal, and waits. What was typed before the question could be read is no answer to it, and is thrown away;
/// a signal that asks for an end is a no.
bool is_answered_yes(char const* question);

/// Says what will happen on the error output. Whether it may: where somebody is asked, by the answer.
bool may_go_on(permissions const& allowed, std::string const& what, char const* question);

} // namespace tool
