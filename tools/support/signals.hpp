// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Every signal that would end or suspend a program by itself: noted, so that the motor can be stopped first.
#pragma once

#include <csignal>

namespace tool {

/// What signals have said since the program began.
struct signal_notes {
    std::sig_atomic_t volatile end{0};        ///< the last one that asks for an end, 0 for none
    std::sig_atomic_t volatile interrupts{0}; ///< how often somebody pressed Ctrl-C
    std::sig_atomic_t volatile suspend{0};    ///< somebody pressed Ctrl-Z
    std::sig_atomic_t volatile resumed{0};    ///< the program was suspended, however, and goes on
};

inline signal_notes noted;

/// Whether a program that does nothing about it is ended by this signal, and can still do something. Not those of
/// a broken program (`stop_motor_before_dying`) nor those that `take_signals` ignores.
inline bool asks_for_an_end(int number)
{
    switch (number) {
    case SIGKILL:
    case SIGSTOP:
    case SIGCHLD:
    case SIGURG:
    case SIGWINCH:
    case SIGCONT:
    case SIGTSTP:
    case SIGTTIN:
    case SIGTTOU:
    case SIGXFSZ:
    case SIGABRT:
    case SIGSEGV:
    case SIGBUS:
    case SIGFPE:
    case SIGILL:
    case SIGTRAP:
    case SIGSYS: return false;
    default: return true;
    }
}

extern "C" inline void note_signal(int number)
{
    if (number == SIGTSTP) {
        noted.suspend = 1;
    } else if (number == SIGCONT) {
        noted.resumed = 1;
    } else {
        noted.end = number;
        noted.interrupts = noted.interrupts + (number == SIGINT ? 1 : 0);
    }
}

inline void note_from_now_on(int number)
{
    struct sigaction taken {};
    taken.sa_handler = note_signal;
    taken.sa_flags = SA_RESTART;
    sigaction(number, &taken, nullptr);
}

/// What was ignored when the program began stays so: `nohup` means it.
inline void take_signal(int number)
{
    struct sigaction before {};
    if (sigaction(number, nullptr, &before) == 0 and before.sa_handler == SIG_DFL) {
        note_from_now_on(number);
    }
}

inline void take_signals()
{
    for (int number = 1; number <= SIGRTMAX; ++number) {
        if (asks_for_an_end(number)) {
            take_signal(number);
        }
    }
    take_signal(SIGTSTP);
    take_signal(SIGCONT);
    // Where somebody sends it. What is written to a reader that went away fails, and says so: see `printer`.
    note_from_now_on(SIGPIPE);
    // What is written then fails, and says so. A program in the background may write to its terminal; what it
    // reads from there has ended.
    for (int const each : {SIGXFSZ, SIGTTOU, SIGTTIN}) {
        std::signal(each, SIG_IGN);
    }
}

/// Suspends the program as Ctrl-Z does where nobody takes the signal; returns when it goes on.
inline void suspend()
{
    std::signal(SIGTSTP, SIG_DFL);
    std::raise(SIGTSTP);
    noted.suspend = 0;
    take_signal(SIGTSTP);
}

} // namespace tool
