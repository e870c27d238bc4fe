// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Runs a program in a console of its own, and does to that what a person does, or Windows:
//
//     console_program EVENT COMMAND-LINE
//
// Behind each line on its own input: c (Ctrl-C), break (Ctrl-Break), close (the window), logoff, shutdown. Its status is the
// program's; its outputs are this one's.
//
// Wine 8 knows Ctrl-C alone, and ends a program whose window is closed without a word. So the others are given as Windows gives
// them: a thread in the program that begins at CtrlRoutine, and an end behind it, or behind five seconds.
#include <cstdint>
#include <cstdio>
#include <string>

#include <windows.h>

namespace {

HANDLE program = nullptr;

DWORD number_of(std::wstring const& event)
{
    return event == L"break"    ? CTRL_BREAK_EVENT
           : event == L"close"  ? CTRL_CLOSE_EVENT
           : event == L"logoff" ? CTRL_LOGOFF_EVENT
                                : CTRL_SHUTDOWN_EVENT;
}

/// False where it cannot be done here.
bool send(std::wstring const& event)
{
    if (event == L"c") {
        return ::GenerateConsoleCtrlEvent(CTRL_C_EVENT, 0) != 0;
    }
    FARPROC const routine = ::GetProcAddress(::GetModuleHandleW(L"kernelbase.dll"), "CtrlRoutine");
    auto const begin = reinterpret_cast<LPTHREAD_START_ROUTINE>(reinterpret_cast<void*>(routine));
    DWORD const number = number_of(event);
    HANDLE const thread =
        ::CreateRemoteThread(program, nullptr, 0, begin, reinterpret_cast<void*>(std::uintptr_t{number}), 0, nullptr);
    if (thread != nullptr and number != CTRL_BREAK_EVENT) {
        constexpr DWORD longest = 5'000;
        ::WaitForSingleObject(thread, longest);
        ::TerminateProcess(program, 98);
    }
    return thread != nullptr;
}

DWORD WINAPI send_at_each_line(void* event)
{
    for (int letter = std::getchar(); letter != EOF; letter = std::getchar()) {
        if (letter == '\n' and not send(*static_cast<std::wstring*>(event))) {
            std::fprintf(stderr, "console_program: Windows error %lu\n", ::GetLastError());
        }
    }
    return 0;
}

} // namespace

int main()
{
    // The words as the shell gave them: the first two are this program's.
    std::wstring line = ::GetCommandLineW();
    auto const next_word = [&line] {
        std::size_t end = line.find(line.front() == L'"' ? L'"' : L' ', 1);
        end += line.front() == L'"' ? 1U : 0U;
        std::wstring word = line.substr(0, end);
        line.erase(0, line.find_first_not_of(L' ', end));
        return word;
    };
    next_word();
    std::wstring event = next_word();
    STARTUPINFOW start{};
    start.cb = sizeof start;
    start.dwFlags = STARTF_USESTDHANDLES | STARTF_USESHOWWINDOW;
    start.wShowWindow = SW_HIDE;
    SECURITY_ATTRIBUTES inherited{sizeof inherited, nullptr, TRUE};
    start.hStdInput = ::CreateFileW(L"NUL", GENERIC_READ, 0, &inherited, OPEN_EXISTING, 0, nullptr);
    start.hStdOutput = ::GetStdHandle(STD_OUTPUT_HANDLE);
    start.hStdError = ::GetStdHandle(STD_ERROR_HANDLE);
    PROCESS_INFORMATION made{};
    if (::CreateProcessW(nullptr, line.data(), nullptr, nullptr, TRUE, CREATE_NEW_CONSOLE, nullptr, nullptr, &start,
                         &made) == 0) {
        std::fprintf(stderr, "console_program: Windows error %lu\n", ::GetLastError());
        return 99;
    }
    program = made.hProcess;
    ::FreeConsole();
    for (int i = 0; i < 100 and ::AttachConsole(made.dwProcessId) == 0; ++i) {
        ::Sleep(50);
    }
    ::SetConsoleCtrlHandler(
        [](DWORD) -> BOOL {
            ::Sleep(INFINITE);
            return TRUE;
        },
        TRUE); // outlives the events
    ::CloseHandle(::CreateThread(nullptr, 0, send_at_each_line, &event, 0, nullptr));
    ::WaitForSingleObject(made.hProcess, INFINITE);
    DWORD status = 0;
    ::GetExitCodeProcess(made.hProcess, &status);
    ::ExitProcess(status);
}
