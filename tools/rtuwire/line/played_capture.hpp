// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// A capture that is played again. What was decided of a frame when it passed is what is said of it; frames of which a
// file says nothing, as another program's may be, go through the same listener as those of a line.
#pragma once

#include <string>

#include "line/open_line.hpp"
#include "line/tap.hpp"

namespace tool {

/// Plays a file: pcapng or pcap. The bit rate that the file says goes before that of `how`. Ends where it cannot be
/// read, or says where it is wrong.
void play_capture(std::string const& file, line_setting how, take_frame const& take);

/// Whether --port names a capture.
bool is_capture(choices const& chosen);

/// The capture that the command or --port names; refuses where neither does.
std::string capture_in(choices const& chosen);

} // namespace tool
