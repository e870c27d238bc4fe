// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// The words that the command line knows: options of every command, commands, and the options of each.
#pragma once

#include "choices.hpp"

namespace CLI {
class App;
}

namespace tool {

/// Adds all of them; what is typed goes to `chosen`.
void add_words(CLI::App& app, choices& chosen);

} // namespace tool
