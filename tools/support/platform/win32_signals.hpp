// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Windows has no signals: events of the console call a handler in a thread of their own. Ctrl-C and Ctrl-Break ask; a window
// that is closed, a log-off and a shutdown leave a program five seconds, and end it when its handler returns.
//
// A program that has loaded user32.dll or gdi32.dll hears nothing of log-off and shutdown: none may be among those it is linked
// with.
#pragma once

#include <atomic>
#include <chrono>
#include <csignal>
#include <string>

#include "../platform.hpp"

namespace tool {

/// Behind the numbers that the C library has.
constexpr int hang_up = 1; ///< the window was closed
constexpr int log_off = 9; ///< or the system shuts down

namespace platform {

/// What happens to a program whose end was asked for.
struct ending {
    std::atomic<void (*)(int)> note{nullptr};
    std::atomic<bool> ends_after_first{false}; ///< the second time nothing is noted
    std::atomic<void (*)()> last_chance{nullptr};
    std::atomic<HANDLE> main_thread{nullptr};
};

inline ending asked_end;

inline int number_of(DWORD event) noexcept
{
    switch (event) {
    case CTRL_C_EVENT: return SIGINT;
    case CTRL_BREAK_EVENT: return SIGTERM;
    case CTRL_CLOSE_EVENT: return hang_up;
    default: return log_off;
    }
}

/// The program goes on, and has so long to end by itself; then it is stopped where it is, and what must be done is done here.
inline void wait_for_end() noexcept
{
    constexpr std::chrono::milliseconds own_time{3'000};
    constexpr std::chrono::milliseconds longest{10'000};
    pause_for(own_time);
    if (auto* const act = asked_end.last_chance.load()) {
        ::SuspendThread(asked_end.main_thread);
        act();
        return;
    }
    pause_for(longest); // Windows ends it before
}

inline BOOL WINAPI on_console_event(DWORD event)
{
    auto* const note = asked_end.note.load();
    if (note == nullptr) {
        return FALSE;
    }
    if (asked_end.ends_after_first) {
        asked_end.note = nullptr;
    }
    note(number_of(event));
    if (event != CTRL_C_EVENT and event != CTRL_BREAK_EVENT) {
        wait_for_end();
    }
    return TRUE;
}

/// Called by the thread that minds the motor.
inline void hear_console(void (*note)(int), bool ends_after_first) noexcept
{
    static HANDLE const own = [] {
        HANDLE thread = nullptr;
        ::DuplicateHandle(::GetCurrentProcess(), ::GetCurrentThread(), ::GetCurrentProcess(), &thread, 0, FALSE,
                          DUPLICATE_SAME_ACCESS);
        ::SetConsoleCtrlHandler(on_console_event, TRUE);
        return thread;
    }();
    asked_end.main_thread = own;
    asked_end.ends_after_first = ends_after_first;
    asked_end.note = note;
}

} // namespace platform

inline void note_signal(int number)
{
    noted.interrupts += number == SIGINT ? 1 : 0;
    noted.end = number;
}

inline void take_suspension() {}
inline void suspend() {}

inline void take_signals() { platform::hear_console(note_signal, false); }

inline void note_first_end(void (*note)(int)) { platform::hear_console(note, true); }

inline void call_before_end(void (*say)(int)) { platform::hear_console(say, true); }

inline void end_by(int) { ::ExitProcess(static_cast<UINT>(STATUS_CONTROL_C_EXIT)); }

inline bool is_meant(int number) { return number == SIGINT or number == SIGTERM; }

inline std::string words_of_signal(int number)
{
    switch (number) {
    case SIGINT: return "Interrupt";
    case SIGTERM: return "Terminated";
    case hang_up: return "the window was closed";
    default: return "log-off or shutdown";
    }
}

inline void ignore_failed_writes() {}

inline void call_before_dying(void (*act)())
{
    static void (*action)() = act;
    // For the filter, where the stack is used up.
    ULONG rest = 32'768;
    ::SetThreadStackGuarantee(&rest);
    ::SetUnhandledExceptionFilter([](EXCEPTION_POINTERS*) -> LONG {
        action();
        return EXCEPTION_CONTINUE_SEARCH;
    });
    std::signal(SIGABRT, [](int) {
        action();
        std::signal(SIGABRT, SIG_DFL);
    });
}

inline void call_before_closing(void (*act)()) { platform::asked_end.last_chance = act; }

} // namespace tool
