// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// The terminal: lines of text onto its screen, keys from its keyboard.
#pragma once

#include <chrono>
#include <cstddef>
#include <string>
#include <vector>

#include "monitor/console.hpp"
#include "monitor/keys.hpp"
#include "monitor/painter.hpp"
#include "monitor/text_line.hpp"
#include "monitor/typed_keys.hpp"

namespace tool {

/// Ends (`usage`) where standard output or input is no terminal, or one that cannot show a screen: TERM.
void check_terminal();

/// The whole screen, while it lives; its destructor restores the terminal.
class full_screen {
public:
    std::size_t width() const { return size_.width; }
    std::size_t height() const { return size_.height; }
    /// Whether it shows UTF-8, as the locale says.
    bool has_blocks() const { return console_.has_utf8(); }

    /// Sends what has changed since the last time.
    void show(std::vector<text_line> const& lines);
    /// The terminal's bell.
    void ring() { console_.write("\a"); }

    /// The next key; `none` behind the time limit, and at once where a signal came; `gone` where the terminal is.
    /// A change of the terminal's size is a `redraw`.
    key next_key(std::chrono::milliseconds limit);

private:
    key next_typed();

    console console_{};
    console_size size_{console_.size()};
    painter painter_{console_.has_utf8(), console_.has_colours()};
    typed_keys keys_{};
    std::string typed_{};
};

} // namespace tool
