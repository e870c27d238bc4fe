// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Whether somebody has asked the program to end: INT, TERM, HUP, QUIT, and what else ends it by itself. A command looks between two requests.
#pragma once

namespace tool {

/// From here on these signals are noted instead of ending the program; a second one ends it at once.
void note_signals();

/// The last one that was noted; 0 for none.
int noted_signal();

} // namespace tool
