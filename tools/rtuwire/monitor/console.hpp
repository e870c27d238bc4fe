// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// What a terminal is to the operating system: its modes, its size, its bytes. One file for each system.
#pragma once

#include <chrono>
#include <cstddef>
#include <memory>
#include <string>
#include <string_view>

namespace tool {

/// In characters, at least one of each.
struct console_size {
    std::size_t width;
    std::size_t height;
    bool operator==(console_size const&) const = default;
};

enum class console_event {
    none,
    typed,
    changed, ///< something else may have been drawn on it, or its size is another one
    gone
};

/// Standard input and output, the other screen of the terminal, without echo and cursor; the destructor restores them.
class console {
public:
    console();
    console(console const&) = delete;
    console& operator=(console const&) = delete;
    ~console();

    console_size size() const;
    bool has_utf8() const;
    bool has_colours() const;

    /// False where not all was written: an end of the program is asked for, or the terminal is gone.
    bool write(std::string_view bytes);
    /// Adds what was typed. `none` behind the time limit, and at once where a signal came. Ctrl-Z is done here.
    console_event read(std::chrono::milliseconds limit, std::string& bytes);

private:
    void enter();
    void leave();

    struct system_state;
    std::unique_ptr<system_state> state_;
};

// The other screen, no cursor, and what is too long is cut at the right; a terminal without another screen is left at its end.
inline constexpr std::string_view enter_screen = "\x1b[?1049h\x1b[?25l\x1b[?7l";
inline constexpr std::string_view leave_screen = "\x1b[0m\x1b[9999;1H\x1b[K\x1b[?7h\x1b[?25h\x1b[?1049l";

} // namespace tool
