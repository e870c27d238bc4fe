// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// The console of Windows 10 and later, which takes the sequences of a VT100.
#ifdef _WIN32

#include <algorithm>
#include <cstdlib>
#include <span>
#include <string>
#include <string_view>

#ifndef WIN32_LEAN_AND_MEAN
#define WIN32_LEAN_AND_MEAN
#endif
#ifndef NOMINMAX
#define NOMINMAX
#endif
#include <windows.h>

#include "exit_status.hpp"
#include "monitor/console.hpp"
#include "monitor/terminal.hpp"

namespace tool {

namespace {

HANDLE keyboard() { return ::GetStdHandle(STD_INPUT_HANDLE); }
HANDLE screen() { return ::GetStdHandle(STD_OUTPUT_HANDLE); }

/// What a terminal elsewhere sends for a key; of letters only ASCII means something.
std::string bytes_of(KEY_EVENT_RECORD const& key)
{
    switch (key.wVirtualKeyCode) {
    case VK_UP: return "\x1b[A";
    case VK_DOWN: return "\x1b[B";
    case VK_RIGHT: return "\x1b[C";
    case VK_LEFT: return "\x1b[D";
    default: break;
    }
    wchar_t const letter = key.uChar.UnicodeChar;
    return letter > 0 and letter < 0x80 ? std::string(1, static_cast<char>(letter)) : std::string{};
}

} // namespace

struct console::system_state {
    DWORD keyboard_mode{0}, screen_mode{0};
    bool is_gone{false};
};

void check_terminal()
{
    DWORD mode = 0;
    if (::GetConsoleMode(screen(), &mode) == 0) {
        refuse_word("monitor draws a screen, and standard output is no console");
    }
    if (::SetConsoleMode(screen(), mode | ENABLE_PROCESSED_OUTPUT | ENABLE_VIRTUAL_TERMINAL_PROCESSING) == 0) {
        refuse_word("monitor draws a screen, and this console cannot: it is older than Windows 10");
    }
    ::SetConsoleMode(screen(), mode);
    if (::GetConsoleMode(keyboard(), &mode) == 0) {
        refuse_word("monitor needs keys, and standard input is no console");
    }
}

console::console() : state_{std::make_unique<system_state>()}
{
    ::GetConsoleMode(keyboard(), &state_->keyboard_mode);
    ::GetConsoleMode(screen(), &state_->screen_mode);
    enter();
}

console::~console() { leave(); }

void console::enter()
{
    // Ctrl-C stays an event. With its own selection by the mouse, which stops all output, as the user has it.
    DWORD const unwanted = ENABLE_LINE_INPUT | ENABLE_ECHO_INPUT | ENABLE_MOUSE_INPUT | ENABLE_VIRTUAL_TERMINAL_INPUT;
    ::SetConsoleMode(keyboard(), (state_->keyboard_mode & ~unwanted) | ENABLE_PROCESSED_INPUT | ENABLE_WINDOW_INPUT);
    ::SetConsoleMode(screen(), state_->screen_mode | ENABLE_PROCESSED_OUTPUT | ENABLE_VIRTUAL_TERMINAL_PROCESSING |
                                   DISABLE_NEWLINE_AUTO_RETURN);
    write(enter_screen);
}

void console::leave()
{
    write(leave_screen);
    ::SetConsoleMode(screen(), state_->screen_mode);
    ::SetConsoleMode(keyboard(), state_->keyboard_mode);
}

console_size console::size() const
{
    CONSOLE_SCREEN_BUFFER_INFO found{};
    if (::GetConsoleScreenBufferInfo(screen(), &found) == 0) {
        return {80, 24};
    }
    auto const span = [](SHORT first, SHORT last) { return static_cast<std::size_t>(std::max(last - first + 1, 1)); };
    return {span(found.srWindow.Left, found.srWindow.Right), span(found.srWindow.Top, found.srWindow.Bottom)};
}

bool console::has_utf8() const { return true; }
bool console::has_colours() const { return std::getenv("NO_COLOR") == nullptr; }

bool console::write(std::string_view bytes)
{
    // Not as bytes: those would be of the console's code page, which outlives the program.
    auto const size = static_cast<int>(bytes.size());
    std::wstring wide(bytes.size(), L'\0');
    wide.resize(static_cast<std::size_t>(::MultiByteToWideChar(CP_UTF8, 0, bytes.data(), size, wide.data(), size)));
    for (std::wstring_view left = wide; not left.empty() and not state_->is_gone;) {
        DWORD written = 0;
        state_->is_gone =
            ::WriteConsoleW(screen(), left.data(), static_cast<DWORD>(left.size()), &written, nullptr) == 0;
        left.remove_prefix(written);
    }
    return not state_->is_gone;
}

console_event console::read(std::chrono::milliseconds limit, std::string& bytes)
{
    DWORD const ready = ::WaitForSingleObject(keyboard(), static_cast<DWORD>(limit.count()));
    INPUT_RECORD events[64];
    DWORD count = 0;
    bool const is_lost =
        ready == WAIT_FAILED or (ready == WAIT_OBJECT_0 and ::ReadConsoleInputW(keyboard(), events, 64, &count) == 0);
    if (state_->is_gone or is_lost) {
        return console_event::gone;
    }
    auto found = console_event::none;
    for (INPUT_RECORD const& each : std::span{events, count}) {
        if (each.EventType == WINDOW_BUFFER_SIZE_EVENT) {
            found = console_event::changed;
        } else if (each.EventType == KEY_EVENT and each.Event.KeyEvent.bKeyDown != 0) {
            bytes += bytes_of(each.Event.KeyEvent);
            found = found == console_event::none ? console_event::typed : found;
        }
    }
    return found;
}

} // namespace tool

#endif
