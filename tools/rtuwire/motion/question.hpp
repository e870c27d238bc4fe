// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// A question to whoever sits at the terminal, before something moves.
#pragma once

#include <string>

#include "choices.hpp"

namespace tool {

/// Says what will happen on the error output. Whether it may: asks only on a terminal, and not after --yes. A signal that
/// asks for an end is a no.
bool may_go_on(permissions const& allowed, std::string const& what, char const* question);

} // namespace tool
