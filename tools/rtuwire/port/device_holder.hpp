// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Why a serial device cannot be opened: who holds it, and who may.
#pragma once

#include <string>

namespace tool {

struct device_holder {
    std::string name{};   ///< "rtuwire (process 4711)"; empty: nobody, or nobody knows who
    bool is_start{false}; ///< of this tool: a motor stops with it
};

/// The program that has locked a device (flock), as Linux tells it in /proc/locks.
device_holder holder_of(std::string const& device);

/// "it belongs to the group dialout: `sudo usermod -aG dialout anna`, then log in anew": what opens a device to whoever runs the
/// program; empty where a group does not.
std::string words_of_group(std::string const& device);

} // namespace tool
