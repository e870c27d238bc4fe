// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// What a key does to the screen of `monitor`.
#pragma once

#include "monitor/model.hpp"

namespace tool {

enum class key {
    none,
    up,
    down,
    next_value,
    value_before,
    plot,
    changed,
    times,
    bell,
    pause,
    help,
    longer,
    shorter,
    redraw,
    quit,
    gone
};

/// Changes what is shown; a key that leaves everything as it is, at an end of the list too, changes nothing.
void apply(key pressed, shown_screen& shown);

/// The next longer and shorter one of the periods that + and - go through, 0.1 s to 1 min.
double longer_period(double seconds);
double shorter_period(double seconds);

} // namespace tool
