// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Whether several units answer at one address.
#pragma once

#include <string>

#include "line/open_line.hpp"

namespace tool {

/// Asks a unit who it is, and hears all that comes: two answers to one request, or again and again one that begins right and
/// is damaged, as where two speak at once. What that means, in words; empty where one unit answers, or nobody. On a real line
/// only: it takes a quarter of a second.
std::string why_shared(open_line& line, unit_address unit);

} // namespace tool
