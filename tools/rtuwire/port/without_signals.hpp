// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Threads that get no signals.
#pragma once

#include <signal.h>

namespace tool {

/// While it lives, this thread and those that it starts get no signals: they are for the threads that the program knows.
class without_signals {
public:
    without_signals() noexcept
    {
        sigset_t all{};
        sigfillset(&all); // a macro on macOS
        ::pthread_sigmask(SIG_SETMASK, &all, &before_);
    }
    without_signals(without_signals const&) = delete;
    without_signals& operator=(without_signals const&) = delete;
    ~without_signals() { ::pthread_sigmask(SIG_SETMASK, &before_, nullptr); }

private:
    sigset_t before_{};
};

} // namespace tool
