// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// The terminal: lines of text onto its screen, keys from its keyboard. All that knows ncurses is here.
#pragma once

#include <chrono>
#include <cstddef>
#include <vector>

#include "monitor/keys.hpp"
#include "monitor/text_line.hpp"

namespace tool {

/// Ends (`usage`) where standard output or input is no terminal, or one that cannot show a screen: TERM.
void check_terminal();

/// The whole screen, while it lives; its destructor restores the terminal.
class full_screen {
public:
    full_screen();
    full_screen(full_screen const&) = delete;
    full_screen& operator=(full_screen const&) = delete;
    ~full_screen();

    std::size_t width() const;
    std::size_t height() const;
    /// Whether it shows UTF-8, as the locale says.
    bool has_blocks() const { return has_utf8_; }

    void show(std::vector<text_line> const& lines);
    /// The terminal's bell.
    static void ring();

    /// The next key; `none` behind the time limit, and at once where a signal came; `gone` where the terminal is.
    /// A change of the terminal's size is a `redraw`.
    key next_key(std::chrono::milliseconds limit);

private:
    void put(text_piece const& piece, bool is_selected) const;

    bool has_utf8_;
    bool has_colours_{false};
};

} // namespace tool
