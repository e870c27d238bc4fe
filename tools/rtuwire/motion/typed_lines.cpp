// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
#include "motion/typed_lines.hpp"

#include <poll.h>
#include <termios.h>
#include <unistd.h>

namespace tool {

namespace {

/// In the background the terminal is somebody else's. One that controls nothing has no foreground.
bool is_terminal_own() noexcept
{
    pid_t const foreground = ::tcgetpgrp(STDIN_FILENO);
    return foreground == -1 or foreground == ::getpgrp();
}

} // namespace

void forget_typed() noexcept
{
    if (::isatty(STDIN_FILENO) == 1 and is_terminal_own()) {
        ::tcflush(STDIN_FILENO, TCIFLUSH);
    }
}

typed_lines::typed_lines() : is_open_{::isatty(STDIN_FILENO) == 1} {}

std::optional<std::string> typed_lines::next()
{
    constexpr std::size_t longest = 256;
    pollfd watched{STDIN_FILENO, POLLIN, 0};
    if (is_open_ and is_terminal_own() and ::poll(&watched, 1, 0) > 0) {
        char place[longest];
        auto const size = ::read(STDIN_FILENO, place, sizeof place);
        is_open_ = size > 0;
        typed_.append(place, size > 0 ? static_cast<std::size_t>(size) : 0);
    }
    std::size_t const end = typed_.find('\n');
    if (end == std::string::npos) {
        typed_.erase(0, typed_.size() > longest ? typed_.size() : 0);
        return std::nullopt;
    }
    std::string const line = typed_.substr(0, end);
    typed_.erase(0, end + 1);
    return line;
}

void typed_lines::forget()
{
    forget_typed();
    typed_.clear();
}

} // namespace tool
