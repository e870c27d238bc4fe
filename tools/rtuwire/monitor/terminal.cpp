// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
#include "monitor/terminal.hpp"

#include <cerrno>
#include <clocale>
#include <cstdlib>
#include <string>

#include <langinfo.h>
#include <poll.h>
#include <termios.h>
#include <unistd.h>

// No macros named `clear` or `move`, and wide characters.
#define NCURSES_NOMACROS 1
#define NCURSES_WIDECHAR 1
#include <ncurses.h>
#include <term.h>
#undef lines
#undef columns
#undef bell

#include "exit_status.hpp"

namespace tool {

namespace {

constexpr short alarm_pair = 1;

key key_of_code(wint_t code)
{
    switch (code) {
    case KEY_UP: return key::up;
    case KEY_DOWN: return key::down;
    case KEY_RIGHT: return key::next_value;
    case KEY_LEFT: return key::value_before;
    case KEY_RESIZE: return key::redraw;
    default: return key::none;
    }
}

key key_of_letter(wint_t letter)
{
    switch (letter) {
    case L'k': return key::up;
    case L'j': return key::down;
    case L'>': return key::next_value;
    case L'<': return key::value_before;
    case L'g': return key::plot;
    case L'c': return key::changed;
    case L't': return key::times;
    case L'b': return key::bell;
    case L'p': return key::pause;
    case L'?':
    case L'h': return key::help;
    case L'+':
    case L'=': return key::longer;
    case L'-': return key::shorter;
    case L'q':
    case L'Q': return key::quit;
    case L'\f': return key::redraw; // Ctrl-L
    default: return key::none;
    }
}

/// What a terminal without UTF-8 can show.
std::string in_ascii(std::string const& text)
{
    std::string shown;
    for (char const each : text) {
        auto const byte = static_cast<unsigned char>(each);
        if ((byte & 0xC0U) != 0x80U) {
            shown += byte < 0x80U ? each : '?';
        }
    }
    return shown;
}

/// The key that would end the program with a core file, and leave the terminal as it is, does nothing.
void take_quit_key_away()
{
    termios settings{};
    if (::tcgetattr(STDIN_FILENO, &settings) == 0) {
        settings.c_cc[VQUIT] = _POSIX_VDISABLE;
        ::tcsetattr(STDIN_FILENO, TCSANOW, &settings);
        ::def_prog_mode();
    }
}

} // namespace

void check_terminal()
{
    if (::isatty(STDOUT_FILENO) != 1) {
        refuse_word("monitor draws a screen, and standard output is no terminal");
    }
    if (::isatty(STDIN_FILENO) != 1) {
        refuse_word("monitor needs keys, and standard input is no terminal");
    }
    char const* const name = std::getenv("TERM");
    std::string const shown = name == nullptr ? "" : name;
    int found = 0;
    if (shown.empty() or ::setupterm(shown.c_str(), STDOUT_FILENO, &found) != OK) {
        refuse_word("TERM is '" + shown + "', which this system does not know");
    }
    if (::tigetstr("cup") == nullptr or ::tigetstr("clear") == nullptr) {
        refuse_word("TERM is '" + shown + "', a terminal that cannot show a screen");
    }
}

full_screen::full_screen()
    // Only what a character is: numbers keep their point.
    : has_utf8_{std::setlocale(LC_CTYPE, "") != nullptr and std::string{::nl_langinfo(CODESET)} == "UTF-8"}
{
    check_terminal();
    if (::newterm(nullptr, stdout, stdin) == nullptr) {
        refuse_word("TERM: this terminal cannot show a screen");
    }
    ::cbreak();
    ::noecho();
    ::nonl();
    ::keypad(stdscr, TRUE);
    ::nodelay(stdscr, TRUE);
    ::set_escdelay(50);
    ::curs_set(0);
    take_quit_key_away();
    if (std::getenv("NO_COLOR") == nullptr and ::has_colors() and ::start_color() == OK) {
        has_colours_ = ::use_default_colors() == OK and ::init_pair(alarm_pair, COLOR_RED, -1) == OK;
    }
}

full_screen::~full_screen() { ::endwin(); }

std::size_t full_screen::width() const { return static_cast<std::size_t>(::getmaxx(stdscr)); }
std::size_t full_screen::height() const { return static_cast<std::size_t>(::getmaxy(stdscr)); }

void full_screen::put(text_piece const& piece, bool is_selected) const
{
    attr_t how = is_selected ? A_REVERSE : A_NORMAL;
    how |= piece.how == look::strong ? A_BOLD : A_NORMAL;
    how |= piece.how == look::faint ? A_DIM : A_NORMAL;
    bool const is_alarm = piece.how == look::alarm;
    // Without colours an alarm is told by its own reverse.
    how |= is_alarm ? A_BOLD : A_NORMAL;
    how ^= is_alarm and not has_colours_ ? A_REVERSE : A_NORMAL;
    ::attr_set(how, is_alarm and has_colours_ ? alarm_pair : 0, nullptr);
    ::addstr(has_utf8_ ? piece.text.c_str() : in_ascii(piece.text).c_str());
}

void full_screen::show(std::vector<text_line> const& lines)
{
    ::erase();
    for (std::size_t row = 0; row < lines.size() and row < height(); ++row) {
        ::move(static_cast<int>(row), 0);
        for (text_piece const& each : lines[row].pieces()) {
            put(each, lines[row].is_selected());
        }
    }
    ::refresh();
}

void full_screen::ring() { ::beep(); }

key full_screen::next_key(std::chrono::milliseconds limit)
{
    pollfd keyboard{STDIN_FILENO, POLLIN, 0};
    int const ready = ::poll(&keyboard, 1, static_cast<int>(limit.count()));
    bool const is_gone = ready > 0 and (keyboard.revents & (POLLHUP | POLLERR | POLLNVAL)) != 0;
    wint_t typed = 0;
    int const kind = ::get_wch(&typed);
    if (kind != ERR) {
        key const pressed = kind == KEY_CODE_YES ? key_of_code(typed) : key_of_letter(typed);
        ::clearok(stdscr, pressed == key::redraw ? TRUE : FALSE);
        return pressed;
    }
    // Readable, and nothing to read: the other end is closed.
    int const why = errno;
    bool const is_at_end = ready > 0 and why != EAGAIN and why != EINTR;
    return is_gone or is_at_end ? key::gone : key::none;
}

} // namespace tool
