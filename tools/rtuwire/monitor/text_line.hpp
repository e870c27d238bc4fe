// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// A line of a screen before a terminal shows it: pieces of text, each with a look, never longer than its width.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace tool {

enum class look { plain, strong, faint, alarm };

struct text_piece {
    std::string text;
    look how;
};

/// A text cut to a width, with a mark at its end where it was cut; control characters become '?'.
std::string cut_to(std::string_view text, std::size_t width, bool has_blocks);

/// A text in lines of at most a width, broken at spaces.
std::vector<std::string> wrapped(std::string_view text, std::size_t width);

class text_line {
public:
    explicit text_line(std::size_t width, bool has_blocks = true) : width_{width}, has_blocks_{has_blocks} {}

    /// Adds as much of a text as fits.
    text_line& add(std::string_view text, look how = look::plain) { return column(text, width_ - used_, how, false); }
    /// Adds a column of a width, filled with spaces.
    text_line& column(std::string_view text, std::size_t width, look how = look::plain, bool is_filled = true);
    /// Adds a text at the right end, if there is room.
    text_line& at_right(std::string_view text, look how = look::plain);
    /// The whole line, in reverse.
    text_line& select()
    {
        is_selected_ = true;
        return *this;
    }

    std::vector<text_piece> const& pieces() const { return pieces_; }
    bool is_selected() const { return is_selected_; }
    /// Without looks.
    std::string text() const;

private:
    std::size_t width_;
    bool has_blocks_;
    std::size_t used_{0};
    bool is_selected_{false};
    std::vector<text_piece> pieces_{};
};

} // namespace tool
