// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// The device of a server that brings no port of its own: bytes as they are, 19200 bit/s.
#pragma once

#include <fcntl.h>
#include <termios.h>

/// The open device, below 0 where it cannot be opened.
inline int open_serial_line(char const* name)
{
    int const device = open(name, O_RDWR | O_NOCTTY | O_CLOEXEC);
    termios setting;
    if (device < 0 or tcgetattr(device, &setting) != 0) {
        return -1;
    }
    cfmakeraw(&setting);
    cfsetspeed(&setting, B19200);
    return tcsetattr(device, TCSANOW, &setting) == 0 ? device : -1;
}
