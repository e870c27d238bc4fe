// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// What is said on the standard error between two frames: where that does not take it at once (a pipe that nobody reads, a
// terminal behind Ctrl-S), it is dropped, and no frame waits for it.
#pragma once

#include <string_view>

namespace tool {

/// To the standard error; says before it how many lines were dropped.
void tell_at_once(std::string_view text);

/// Behind the last frame: says how many lines were dropped, where that is taken.
void tell_dropped();

} // namespace tool
