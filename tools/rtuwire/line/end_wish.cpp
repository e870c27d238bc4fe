// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
#include "line/end_wish.hpp"

#include <csignal>
#include <initializer_list>

namespace tool {

namespace {

std::sig_atomic_t volatile noted = 0;

extern "C" void note(int number)
{
    noted = number;
    std::signal(number, SIG_DFL);
}

} // namespace

void note_signals()
{
    for (int const each : {SIGINT, SIGTERM, SIGHUP, SIGQUIT, SIGUSR1, SIGUSR2, SIGALRM}) {
        struct sigaction before {};
        // What was ignored when the program began stays so: `nohup` means it.
        if (sigaction(each, nullptr, &before) == 0 and before.sa_handler == SIG_DFL) {
            struct sigaction taken {};
            taken.sa_handler = note;
            sigaction(each, &taken, nullptr);
        }
    }
}

int noted_signal() { return noted; }

} // namespace tool
