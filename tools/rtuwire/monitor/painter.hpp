// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// What a terminal has to be sent to show lines of text: VT sequences, and of the lines what has changed.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "monitor/text_line.hpp"

namespace tool {

class painter {
public:
    /// Without UTF-8 a '?' stands for each character that is no ASCII; without colours an alarm is in reverse.
    painter(bool has_utf8, bool has_colours) : has_utf8_{has_utf8}, has_colours_{has_colours} {}

    /// Nothing where the screen shows these lines already. What is beyond width or height is not shown.
    std::string paint(std::vector<text_line> const& lines, std::size_t width, std::size_t height);

    /// The screen may show anything by now: the next lines are sent whole.
    void forget() { rows_.clear(); }

private:
    struct cell {
        std::string text;
        look how;
        bool is_selected;
        bool operator==(cell const&) const = default;
    };
    using cells = std::vector<cell>;

    cells cells_of(text_line const& line, std::size_t width) const;
    std::string look_of(cell const& one) const;
    std::string change(std::size_t row, cells const& before, cells const& now) const;

    bool has_utf8_;
    bool has_colours_;
    std::size_t width_{0};
    std::vector<cells> rows_{};
};

} // namespace tool
