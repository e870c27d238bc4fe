// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
#include "monitor/painter.hpp"

#include <algorithm>
#include <string_view>
#include <utility>

#include "output/plain_text.hpp"
#include "output/width.hpp"

namespace tool {

painter::cells painter::cells_of(text_line const& line, std::size_t width) const
{
    cells all;
    std::size_t used = 0;
    for (text_piece const& piece : line.pieces()) {
        for (std::string_view left = piece.text; not left.empty();) {
            std::string_view const character = first_character(left);
            left.remove_prefix(character.size());
            bool const is_shown = (character.size() == 1 or has_utf8_) and plain_text(character) == character;
            std::string const text{is_shown ? character : "?"};
            used += width_of(text);
            if (used > width) {
                return all;
            }
            if (width_of(text) == 0 and not all.empty()) {
                all.back().text += text;
            } else {
                all.push_back({text, piece.how, line.is_selected()});
            }
        }
    }
    while (not all.empty() and all.back() == cell{" ", look::plain, false}) {
        all.pop_back();
    }
    return all;
}

std::string painter::look_of(cell const& one) const
{
    bool const is_alarm = one.how == look::alarm;
    std::string const weight = is_alarm or one.how == look::strong ? ";1" : one.how == look::faint ? ";2" : "";
    bool const is_reverse = one.is_selected != (is_alarm and not has_colours_);
    return "\x1b[0" + weight + (is_alarm and has_colours_ ? ";31" : "") + (is_reverse ? ";7" : "") + "m";
}

std::string painter::change(std::size_t row, cells const& before, cells const& now) const
{
    // How wide others than ASCII are, terminals see in different ways: behind one of them a column is not known.
    auto const is_ascii = [](cell const& each) { return each.text.size() == 1; };
    auto const same = std::mismatch(before.begin(), before.end(), now.begin(), now.end()).second;
    auto first = std::find_if_not(now.begin(), same, is_ascii);
    auto last = now.end();
    bool const is_inside =
        before.size() == now.size() and std::ranges::all_of(before, is_ascii) and std::ranges::all_of(now, is_ascii);
    if (is_inside) {
        auto const rest = std::mismatch(before.rbegin(), before.rend(), now.rbegin());
        last = rest.second.base();
    }
    std::string bytes = "\x1b[" + std::to_string(row + 1) + ';' + std::to_string(first - now.begin() + 1) + 'H';
    std::string how = "\x1b[0m";
    bytes += how + (is_inside ? "" : "\x1b[K");
    for (; first != last; ++first) {
        if (std::string const wanted = look_of(*first); wanted != how) {
            bytes += how = wanted;
        }
        bytes += first->text;
    }
    return bytes;
}

std::string painter::paint(std::vector<text_line> const& lines, std::size_t width, std::size_t height)
{
    std::string bytes;
    if (width != width_ or height != rows_.size()) {
        bytes = "\x1b[0m\x1b[2J";
        width_ = width;
        rows_.assign(height, {});
    }
    for (std::size_t row = 0; row < height; ++row) {
        cells now = row < lines.size() ? cells_of(lines[row], width) : cells{};
        if (now != rows_[row]) {
            bytes += change(row, rows_[row], now);
            rows_[row] = std::move(now);
        }
    }
    return bytes;
}

} // namespace tool
