// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
#include "monitor/keys.hpp"

#include <algorithm>
#include <iterator>

namespace tool {

namespace {

constexpr double periods[]{0.1, 0.2, 0.5, 1, 2, 5, 10, 30, 60};

std::size_t values_of_selected(shown_screen const& shown)
{
    return shown.selected < shown.units.size() ? shown.units[shown.selected].values.size() : 0;
}

void select(shown_screen& shown, std::size_t unit)
{
    if (unit < shown.units.size() and unit != shown.selected) {
        shown.selected = unit;
        shown.value = shown_screen::no_value;
    }
}

/// Of the chosen value; where none is, of the first that has a curve.
void turn_plot(shown_screen& shown)
{
    std::size_t const count = values_of_selected(shown);
    std::size_t which = shown.value;
    if (count > 0 and which >= count) {
        auto const& values = shown.units[shown.selected].values;
        auto const found =
            std::ranges::find_if(values, [](shown_value const& each) { return not each.samples.empty(); });
        which = static_cast<std::size_t>(found - values.begin());
    }
    if (which < count and not shown.turned.insert({shown.selected, which}).second) {
        shown.turned.erase({shown.selected, which});
    }
}

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
    case key::up: select(shown, shown.selected - 1); break;
    case key::down: select(shown, shown.selected + 1); break;
    case key::next_value: // behind "none" the first
        shown.value += shown.value + 1 < values_of_selected(shown) ? 1U : 0U;
        break;
    case key::value_before: shown.value -= shown.value != shown_screen::no_value ? 1U : 0U; break;
    case key::plot: turn_plot(shown); break;
    case key::changed: shown.has_changed_only = not shown.has_changed_only; break;
    case key::times: shown.has_times = not shown.has_times; break;
    case key::bell: shown.has_bell = not shown.has_bell; break;
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
