// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
#include "monitor/keys.hpp"

#include <algorithm>
#include <iterator>

namespace tool {

namespace {

constexpr double periods[]{0.1, 0.2, 0.5, 1, 2, 5, 10, 30, 60};

} // namespace

double longer_period(double seconds)
{
    auto const next = std::upper_bound(std::begin(periods), std::end(periods), seconds);
    return next != std::end(periods) ? *next : seconds;
}

double shorter_period(double seconds)
{
    auto const same = std::lower_bound(std::begin(periods), std::end(periods), seconds);
    return same != std::begin(periods) ? *std::prev(same) : seconds;
}

void apply(key pressed, shown_screen& shown)
{
    switch (pressed) {
    case key::up: shown.selected -= shown.selected > 0 ? 1U : 0U; break;
    case key::down: shown.selected += shown.selected + 1 < shown.units.size() ? 1U : 0U; break;
    case key::pause: shown.is_paused = not shown.is_paused; break;
    case key::help: shown.has_help = not shown.has_help; break;
    case key::longer: shown.period = longer_period(shown.period); break;
    case key::shorter: shown.period = shorter_period(shown.period); break;
    case key::none:
    case key::redraw:
    case key::quit:
    case key::gone: break;
    }
}

} // namespace tool
