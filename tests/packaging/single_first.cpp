// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// One of two files of a program that include the single header: this one with all its parts.
#define RTUWIRE_PORT
#define RTUWIRE_PRINT
#define RTUWIRE_PARAMETERS
#include <rtuwire.hpp>

#include <iostream>

bool frame_is_right();

int main()
{
    rtuwire::posix_serial const closed;
    std::cout << rtuwire::errc::timed_out << '\n';
    return frame_is_right() and not closed.is_open() ? 0 : 1;
}
