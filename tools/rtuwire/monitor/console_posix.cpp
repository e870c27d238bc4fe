// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
#ifndef _WIN32

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <iterator>
#include <string>
#include <string_view>

#include <sys/ioctl.h>
#include <sys/select.h>
#include <termios.h>
#include <unistd.h>

#include "exit_status.hpp"
#include "line/end_wish.hpp"
#include "monitor/console.hpp"
#include "monitor/terminal.hpp"

namespace tool {

namespace {

std::sig_atomic_t volatile shall_suspend = 0, has_changed = 0;

extern "C" void note_console_signal(int number) { (number == SIGTSTP ? shall_suspend : has_changed) = 1; }

/// Where nobody has it: what was ignored when the program began stays so.
void take_console_signal(int number)
{
    struct sigaction before {};
    if (::sigaction(number, nullptr, &before) == 0 and before.sa_handler == SIG_DFL) {
        struct sigaction taken {};
        taken.sa_handler = note_console_signal;
        taken.sa_flags = SA_RESTART;
        ::sigaction(number, &taken, nullptr);
    }
}

void give_back_console_signal(int number)
{
    struct sigaction now {};
    if (::sigaction(number, nullptr, &now) == 0 and now.sa_handler == note_console_signal) {
        std::signal(number, SIG_DFL);
    }
}

std::string variable(char const* name)
{
    char const* const value = std::getenv(name);
    return value == nullptr ? "" : value;
}

/// The first word of a name: of xterm-256color, screen.xterm, vt220+keypad.
std::string family_of(std::string const& name) { return name.substr(0, name.find_first_of("-.+")); }

/// vt100 to vt525, not the vt52: no colours.
bool is_numbered_vt(std::string_view family) { return family.starts_with("vt") and family.size() == 5; }

/// Whether terminals of this family take the sequences of a VT100.
bool takes_sequences(std::string_view family)
{
    constexpr std::string_view known[]{"Eterm",      "alacritty",   "ansi",  "contour", "cygwin", "dtterm",  "fbterm",
                                       "foot",       "ghostty",     "gnome", "iTerm",   "iTerm2", "iterm",   "iterm2",
                                       "kitty",      "konsole",     "linux", "mintty",  "mlterm", "ms",      "nsterm",
                                       "pcvt",       "putty",       "rio",   "rxvt",    "screen", "st",      "teraterm",
                                       "terminator", "terminology", "tmux",  "vscode",  "vte",    "wezterm", "wsvt25",
                                       "xfce",       "xterm",       "zellij"};
    return is_numbered_vt(family) or std::ranges::find(known, family) != std::end(known);
}

void set_modes(termios const& settings) { ::tcsetattr(STDIN_FILENO, TCSANOW, &settings); }

} // namespace

void check_terminal()
{
    if (::isatty(STDOUT_FILENO) != 1) {
        refuse_word("monitor draws a screen, and standard output is no terminal");
    }
    if (::isatty(STDIN_FILENO) != 1) {
        refuse_word("monitor needs keys, and standard input is no terminal");
    }
    if (std::string const name = variable("TERM"); not takes_sequences(family_of(name))) {
        refuse_word("TERM is '" + name + "', no terminal with a screen that monitor knows; most are TERM=xterm");
    }
}

struct console::system_state {
    termios before{};
    bool is_gone{false};
};

console::console() : state_{std::make_unique<system_state>()}
{
    ::tcgetattr(STDIN_FILENO, &state_->before);
    for (int const each : {SIGTSTP, SIGCONT, SIGWINCH}) {
        take_console_signal(each);
    }
    enter();
}

console::~console()
{
    leave();
    for (int const each : {SIGTSTP, SIGCONT, SIGWINCH}) {
        give_back_console_signal(each);
    }
}

void console::enter()
{
    termios settings = state_->before;
    settings.c_lflag &= ~static_cast<tcflag_t>(ICANON | ECHO | ECHONL);
    settings.c_lflag |= ISIG;
    settings.c_cc[VMIN] = 1;
    settings.c_cc[VTIME] = 0;
    // The key that would end the program with a core file, and leave the terminal as it is, does nothing.
    settings.c_cc[VQUIT] = _POSIX_VDISABLE;
    set_modes(settings);
    write(enter_screen);
}

void console::leave()
{
    // First: a terminal that takes no bytes may be left by another signal.
    set_modes(state_->before);
    write(leave_screen);
}

console_size console::size() const
{
    winsize found{};
    if (::ioctl(STDOUT_FILENO, TIOCGWINSZ, &found) != 0 or found.ws_col == 0 or found.ws_row == 0) {
        return {80, 24}; // a serial line has none
    }
    return {found.ws_col, found.ws_row};
}

bool console::has_utf8() const
{
    // By its name: a static program or a bare system may lack the locale itself.
    std::string locale;
    for (char const* const each : {"LANG", "LC_CTYPE", "LC_ALL"}) {
        std::string const set = variable(each);
        locale = set.empty() ? locale : set;
    }
    auto const is_in = [&locale](std::string_view name) { return locale.find(name) != locale.npos; };
    return is_in("UTF-8") or is_in("utf8") or is_in("utf-8") or is_in("UTF8");
}

bool console::has_colours() const
{
    return std::getenv("NO_COLOR") == nullptr and not is_numbered_vt(family_of(variable("TERM")));
}

bool console::write(std::string_view bytes)
{
    while (not bytes.empty() and not state_->is_gone) {
        auto const written = ::write(STDOUT_FILENO, bytes.data(), bytes.size());
        if (written > 0) {
            bytes.remove_prefix(static_cast<std::size_t>(written));
        } else if (written < 0 and errno == EINTR and noted_signal() != 0) {
            return false;
        } else if (written < 0 and errno == EAGAIN) {
            fd_set screen;
            FD_ZERO(&screen);
            FD_SET(STDOUT_FILENO, &screen);
            ::select(STDOUT_FILENO + 1, nullptr, &screen, nullptr, nullptr);
        } else {
            state_->is_gone = written == 0 or errno != EINTR;
        }
    }
    return bytes.empty();
}

console_event console::read(std::chrono::milliseconds limit, std::string& bytes)
{
    fd_set keyboard;
    FD_ZERO(&keyboard);
    FD_SET(STDIN_FILENO, &keyboard);
    timeval left{};
    left.tv_sec = limit / std::chrono::seconds{1};
    left.tv_usec =
        static_cast<decltype(left.tv_usec)>((limit % std::chrono::seconds{1}) / std::chrono::microseconds{1});
    int const ready = ::select(STDIN_FILENO + 1, &keyboard, nullptr, nullptr, &left);
    if (shall_suspend != 0) {
        leave();
        std::signal(SIGTSTP, SIG_DFL);
        std::raise(SIGTSTP);
        shall_suspend = 0;
        take_console_signal(SIGTSTP);
        has_changed = 1;
    }
    if (has_changed != 0) {
        has_changed = 0;
        enter(); // what was suspended finds what its shell left
        return console_event::changed;
    }
    char typed[256];
    auto const count = ready > 0 ? ::read(STDIN_FILENO, typed, sizeof typed) : 0;
    bool const is_at_end = ready > 0 and (count == 0 or (count < 0 and errno != EAGAIN and errno != EINTR));
    if (state_->is_gone or is_at_end) {
        return console_event::gone;
    }
    bytes.append(typed, count > 0 ? static_cast<std::size_t>(count) : 0);
    return count > 0 ? console_event::typed : console_event::none;
}

} // namespace tool

#endif
