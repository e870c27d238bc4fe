// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Who holds a serial device that is in use.
#pragma once

#include <string>

namespace tool {

/// "rtuwire (process 4711)": the program that has locked a device (flock), as Linux tells it in /proc/locks; empty where it
/// tells of none.
std::string holder_of(std::string const& device);

} // namespace tool
