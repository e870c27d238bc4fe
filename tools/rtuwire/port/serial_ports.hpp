// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// The serial ports of this system, as Linux tells of them in /sys, and Windows in its registry. None is opened: that would
// move DTR and RTS, and reset some boards.
#pragma once

#include <string>
#include <vector>

namespace tool {

struct serial_port {
    std::string device{}; ///< "/dev/ttyUSB0", "COM3"
    std::string stable{}; ///< a name that stays: "/dev/serial/by-id/usb-..."; empty where there is none, as on Windows
    std::string driver{}; ///< "ftdi_sio", "FTSER2K"
    std::string maker{};  ///< of an adapter on USB, as it says itself
    std::string product{};
    std::string serial{};
};

/// Those that have hardware, by name. `root` is in front of /sys and /dev; on Windows nothing.
std::vector<serial_port> serial_ports(std::string const& root = {});

} // namespace tool
