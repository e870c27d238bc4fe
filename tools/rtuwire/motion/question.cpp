// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
#include "motion/question.hpp"

#include <chrono>

#include <poll.h>
#include <unistd.h>

#include "../support/say.hpp"
#include "../support/signals.hpp"
#include "output/plain_text.hpp"

namespace tool {

bool is_asked(permissions const& allowed) { return not allowed.is_confirmed and ::isatty(STDIN_FILENO) == 1; }

bool may_go_on(permissions const& allowed, std::string const& what, char const* question)
{
    constexpr int look_every = 100; // ms
    bool const asks = is_asked(allowed);
    // A terminal that was stopped (Ctrl-S) must not keep this program from ending.
    error_output.put(plain_text(what) + "\n" + (asks ? std::string{question} + " (y/n) " : std::string{}));
    error_output.finish(std::chrono::milliseconds{300});
    if (not asks) {
        return noted.end == 0;
    }
    pollfd watched{STDIN_FILENO, POLLIN, 0};
    while (noted.end == 0 and noted.suspend == 0) {
        if (::poll(&watched, 1, look_every) > 0) {
            char answer = 0;
            return ::read(STDIN_FILENO, &answer, 1) == 1 and (answer == 'y' or answer == 'Y');
        }
    }
    return false;
}

} // namespace tool
