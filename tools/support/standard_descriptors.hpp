// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// A program may be started with its standard input, output or error output closed. Whatever it opens first
// then gets that number, and its text would go there.
#pragma once

#include <fcntl.h>
#include <unistd.h>

namespace tool {

/// Puts something in each of the three places that is empty. Reading from it and writing to it fail, as they
/// would with the closed one: whoever prints is told that nobody gets it.
inline void keep_standard_descriptors() noexcept
{
    for (int const place : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) {
        if (::fcntl(place, F_GETFD) < 0) {
            // The lowest free number is this one: those below are taken.
            ::open("/dev/null", place == STDIN_FILENO ? O_WRONLY : O_RDONLY);
        }
    }
}

} // namespace tool
