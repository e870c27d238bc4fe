// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
#include "monitor/terminal.hpp"

#include <algorithm>

namespace tool {

namespace {

/// What follows a byte of Esc later than this is no part of a sequence.
constexpr std::chrono::milliseconds escape_time{50};

} // namespace

void full_screen::show(std::vector<text_line> const& lines)
{
    if (not console_.write(painter_.paint(lines, width(), height()))) {
        painter_.forget();
    }
}

key full_screen::next_key(std::chrono::milliseconds limit)
{
    auto event = console_event::typed;
    if (typed_.empty()) {
        event = console_.read(keys_.is_within() ? std::min(limit, escape_time) : limit, typed_);
    }
    if (event == console_event::none) {
        keys_.give_up();
    }
    bool const is_other = size_ != console_.size();
    size_ = console_.size();
    key const pressed = event == console_event::gone                  ? key::gone
                        : event == console_event::changed or is_other ? key::redraw
                                                                      : next_typed();
    if (pressed == key::redraw) {
        painter_.forget();
    }
    return pressed;
}

key full_screen::next_typed()
{
    key pressed = key::none;
    std::size_t used = 0;
    while (used < typed_.size() and pressed == key::none) {
        pressed = keys_.push(typed_[used++]);
    }
    typed_.erase(0, used);
    return pressed;
}

} // namespace tool
