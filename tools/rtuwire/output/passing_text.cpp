// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
#include "output/passing_text.hpp"

#include <algorithm>
#include <cerrno>
#include <cstddef>
#include <string>

#include <limits.h>
#include <poll.h>
#include <sys/stat.h>
#include <unistd.h>

namespace tool {

namespace {

/// A pipe that can be written takes PIPE_BUF bytes; of a terminal only the next character is known to be taken.
std::size_t taken_by(int descriptor) noexcept
{
    struct stat found {};
    bool const is_terminal = ::fstat(descriptor, &found) == 0 and S_ISCHR(found.st_mode);
    return is_terminal ? 1 : PIPE_BUF;
}

std::size_t dropped = 0;

} // namespace

bool write_at_once(int descriptor, std::string_view text) noexcept
{
    std::size_t const most = taken_by(descriptor);
    while (not text.empty()) {
        pollfd watched{descriptor, POLLOUT, 0};
        int const ready = ::poll(&watched, 1, 0);
        bool const is_interrupted = ready < 0 and errno == EINTR;
        if (not is_interrupted and (ready <= 0 or (watched.revents & POLLOUT) == 0)) {
            return false;
        }
        ssize_t const count = is_interrupted ? 0 : ::write(descriptor, text.data(), std::min(text.size(), most));
        if (count < 0 and errno != EINTR) {
            return false;
        }
        text.remove_prefix(count < 0 ? 0 : static_cast<std::size_t>(count));
    }
    return true;
}

void tell_at_once(std::string_view text)
{
    tell_dropped();
    bool const is_told = dropped == 0 and write_at_once(STDERR_FILENO, text);
    dropped += is_told ? 0 : 1;
}

void tell_dropped()
{
    if (dropped > 0 and write_at_once(STDERR_FILENO, "\nrtuwire: the standard error was blocked: " +
                                                         std::to_string(dropped) + " lines were dropped\n")) {
        dropped = 0;
    }
}

} // namespace tool
