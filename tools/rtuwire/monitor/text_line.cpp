// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
#include "monitor/text_line.hpp"

#include <algorithm>

#include "output/width.hpp"

namespace tool {

namespace {

/// The bytes of so many columns from the beginning.
std::size_t prefix_size(std::string_view text, std::size_t columns)
{
    std::size_t end = 0;
    while (end < text.size()) {
        std::string_view const character = first_character(text.substr(end));
        std::size_t const width = width_of(character);
        if (width > columns) {
            break;
        }
        columns -= width;
        end += character.size();
    }
    return end;
}

} // namespace

std::string cut_to(std::string_view text, std::size_t width, bool has_blocks)
{
    std::string shown{text};
    if (width_of(text) > width) {
        std::string_view const mark = has_blocks ? "…" : "~";
        shown = width == 0 ? std::string{} : shown.substr(0, prefix_size(text, width - 1)).append(mark);
    }
    auto const is_control = [](char each) { return static_cast<unsigned char>(each) < 0x20 or each == '\x7F'; };
    std::replace_if(shown.begin(), shown.end(), is_control, '?');
    return shown;
}

std::vector<std::string> wrapped(std::string_view text, std::size_t width)
{
    std::vector<std::string> lines;
    while (not text.empty() and width > 0) {
        std::size_t end = text.size();
        if (width_of(text) > width) {
            end = std::max(prefix_size(text, width), first_character(text).size());
            std::size_t const space = text.rfind(' ', end);
            end = space == std::string_view::npos or space == 0 ? end : space;
        }
        lines.emplace_back(text.substr(0, end));
        text.remove_prefix(std::min(text.size(), text.find_first_not_of(' ', end)));
    }
    return lines;
}

text_line& text_line::column(std::string_view text, std::size_t width, look how, bool is_filled)
{
    width = std::min(width, width_ - used_);
    std::string shown = cut_to(text, width, has_blocks_);
    if (is_filled) {
        shown.append(width - width_of(shown), ' ');
    }
    used_ += width_of(shown);
    if (not shown.empty()) {
        pieces_.push_back({std::move(shown), how});
    }
    return *this;
}

text_line& text_line::at_right(std::string_view text, look how)
{
    std::size_t const needed = width_of(text);
    if (used_ + needed <= width_) {
        column("", width_ - used_ - needed);
        add(text, how);
    }
    return *this;
}

std::string text_line::text() const
{
    std::string all;
    for (text_piece const& each : pieces_) {
        all += each.text;
    }
    return all;
}

} // namespace tool
