// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// The signals of POSIX.
#pragma once

#include <array>
#include <csignal>
#include <cstddef>
#include <cstring>
#include <initializer_list>
#include <string>

namespace tool {

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
        noted.interrupts += number == SIGINT ? 1 : 0;
    }
}

inline void call_from_now_on(int number, void (*handler)(int), int flags)
{
    struct sigaction taken {};
    taken.sa_handler = handler;
    taken.sa_flags = flags;
    sigaction(number, &taken, nullptr);
}

/// What was ignored when the program began stays so: `nohup` means it.
inline void call_unless_ignored(int number, void (*handler)(int), int flags)
{
    struct sigaction before {};
    if (sigaction(number, nullptr, &before) == 0 and before.sa_handler == SIG_DFL) {
        call_from_now_on(number, handler, flags);
    }
}

inline void take_signal(int number) { call_unless_ignored(number, note_signal, SA_RESTART); }

/// From here on what asks for an end calls this, and a wait for the port ends at once; a second time it ends the program.
inline void note_first_end(void (*note)(int))
{
    for (int const each : {SIGINT, SIGTERM, SIGHUP, SIGQUIT, SIGUSR1, SIGUSR2, SIGALRM}) {
        call_unless_ignored(each, note, static_cast<int>(SA_RESETHAND));
    }
}

/// From here on this is called before the program is ended by a person or its terminal. It may do what a signal handler may.
inline void call_before_end(void (*say)(int))
{
    for (int const each : {SIGINT, SIGTERM, SIGHUP}) {
        call_unless_ignored(each, say, SA_RESTART);
    }
}

/// What the signal would have done.
inline void end_by(int number)
{
    std::signal(number, SIG_DFL);
    std::raise(number);
}

/// The end that a person asked for: Ctrl-C, or the usual signal.
inline bool is_meant(int number) { return number == SIGINT or number == SIGTERM; }

/// That of a terminal that is gone.
constexpr int hang_up = SIGHUP;

inline std::string words_of_signal(int number) { return ::strsignal(number); }

/// A write to a reader that went away, or to a file that may not grow, fails and says so, and ends nobody.
inline void ignore_failed_writes()
{
    std::signal(SIGPIPE, SIG_IGN);
    std::signal(SIGXFSZ, SIG_IGN);
}

/// From here on this is called before an error of this program ends it: a trap, a wrong address, a stack that is used up.
inline void call_before_dying(void (*act)())
{
    static void (*action)() = act;
    // The program's own may be what is used up.
    alignas(16) static std::array<std::byte, 32'768> stack;
    stack_t other{};
    other.ss_sp = stack.data();
    other.ss_size = stack.size();
    ::sigaltstack(&other, nullptr);
    for (int const each : {SIGABRT, SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGTRAP, SIGSYS}) {
        call_from_now_on(
            each,
            [](int number) {
                action();
                std::raise(number); // lets the signal do what it does
            },
            static_cast<int>(SA_RESETHAND) | SA_NODEFER | SA_ONSTACK);
    }
}

/// Nothing here ends a program but what it was told of: the last chance is Windows' own.
inline void call_before_closing(void (*)()) {}

/// Ctrl-Z alone.
inline void take_suspension() { take_signal(SIGTSTP); }

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
    call_from_now_on(SIGPIPE, note_signal, SA_RESTART);
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
