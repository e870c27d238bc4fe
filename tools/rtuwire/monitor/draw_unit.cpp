// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
#include "monitor/draw_unit.hpp"

#include <algorithm>
#include <cstdio>

#include "monitor/plot.hpp"
#include "monitor/sparkline.hpp"

namespace tool {

namespace {

constexpr std::size_t name_width = 13;
constexpr std::size_t address_width = 5;
constexpr std::size_t drive_width = 13;
constexpr std::size_t state_width = 36;
constexpr std::size_t amount_width = 13;
constexpr std::size_t most_curve = 40;
constexpr std::size_t label_width = 12;
constexpr std::size_t value_width = 14;
constexpr std::size_t scale_width = 10; ///< of a plot, beside its curve

std::string lost_text(shown_unit const& unit)
{
    return "link lost, silent for " + std::to_string(static_cast<long>(unit.silent_seconds)) + " s";
}

/// The most important thing in few words.
std::string state_text(shown_unit const& unit)
{
    if (unit.link == link_state::lost) {
        return lost_text(unit);
    }
    if (unit.link == link_state::waiting) {
        return "not asked yet";
    }
    if (not unit.fault.empty()) {
        return unit.state + ", " + unit.fault;
    }
    if (not unit.unread.empty()) {
        return "state unknown: " + unit.unread;
    }
    std::string text = unit.state.empty() ? "responds" : unit.state;
    text += unit.is_local ? ", local" : "";
    for (shown_value const& each : unit.values) {
        text += each.outside.empty() ? "" : ", " + each.label + ' ' + each.outside;
    }
    return unit.note.empty() ? text : text + ", " + unit.note;
}

/// The first value with a curve.
shown_value const* main_value(shown_unit const& unit)
{
    auto const found = std::find_if(unit.values.begin(), unit.values.end(),
                                    [](shown_value const& each) { return not each.samples.empty(); });
    return found != unit.values.end() ? &*found : nullptr;
}

std::string label_with(shown_unit const& unit, shown_value const& value)
{
    return value.label + '@' + (unit.name.empty() ? std::to_string(unit.address) : unit.name);
}

std::string amount_text(double amount, char const* form = "%.1f")
{
    char text[32];
    std::snprintf(text, sizeof text, form, amount);
    return text;
}

/// How long ago the first of the samples is that a plot of so many has.
std::string span_text(shown_unit const& unit, std::size_t samples)
{
    std::size_t const count = std::min(samples, unit.times.size());
    double const span = count == 0 ? 0 : unit.times.back() - unit.times[unit.times.size() - count];
    return span < 120 ? amount_text(span, "%.0f s") : amount_text(span / 60, "%.1f min");
}

} // namespace

void put_unit_titles(text_line& line, bool has_times)
{
    line.column(" name", name_width, look::strong).column("unit", address_width, look::strong);
    if (has_times) {
        line.add("  last ms    mean  longest    asked  silent  refused  damaged", look::strong);
    } else {
        line.column("drive", drive_width, look::strong).add("state", look::strong);
    }
}

void put_times(text_line& line, shown_unit const& unit)
{
    look const how = unit.has_alarm() ? look::alarm : look::plain;
    exchange_counts const& counts = unit.counts;
    line.column(" " + unit.name, name_width - 1, how).column("", 1);
    line.column(std::to_string(unit.address), address_width, how);
    char text[96];
    std::snprintf(text, sizeof text, "%9.1f%8.1f%9.1f%9lu%8lu%9lu%9lu", counts.last, counts.mean(), counts.longest,
                  counts.asked, counts.silent, counts.refused, counts.damaged);
    line.add(text, how);
}

std::string counts_text(exchange_counts const& counts)
{
    return counts.asked == 0 ? std::string{}
                             : amount_text(counts.last) + " ms, longest " + amount_text(counts.longest) + "; " +
                                   std::to_string(counts.errors()) + " of " + std::to_string(counts.asked) + " failed";
}

void put_unit(text_line& line, shown_unit const& unit, std::size_t width, bool has_blocks)
{
    look const how = unit.has_alarm() ? look::alarm : look::plain;
    line.column(" " + unit.name, name_width - 1, how)
        .column("", 1)
        .column(std::to_string(unit.address), address_width, how);
    line.column(unit.drive, drive_width, how);
    std::size_t const room = width - name_width - address_width - drive_width;
    shown_value const* const value = unit.link == link_state::linked ? main_value(unit) : nullptr;
    if (value == nullptr) {
        line.add(state_text(unit), how);
        return;
    }
    // The rest behind the state and the value is the curve's.
    std::size_t const amount = std::min(room - state_width, amount_width);
    std::size_t const curve = std::min(room - state_width - amount, most_curve);
    line.column(state_text(unit), room - amount - curve - 1, how).column("", 1).column(value->text, amount);
    line.add(sparkline(value->samples, curve, has_blocks));
}

void put_value(text_line& line, shown_value const& value, value_marks marks, std::size_t width, bool has_blocks)
{
    bool const has_curve = not value.samples.empty();
    std::size_t const name_room = width * 2 / 5;
    line.add(marks.is_chosen ? ">" : " ", look::strong);
    line.column(value.label, label_width - 2, look::strong).column(marks.is_plotted ? "~" : "", 1);
    line.column(value.name, name_room - 1, look::faint).column("", 1);
    look const how = value.is_bad or not value.outside.empty() ? look::alarm : look::plain;
    if (not has_curve) {
        line.add(value.text, how);
        return;
    }
    line.column(value.text, value_width - 1, how).column("", 1);
    std::size_t const taken = label_width + name_room + value_width;
    line.add(sparkline(value.samples, width - taken, has_blocks));
}

void put_changed(text_line& line, shown_unit const& unit, shown_value const& value, std::size_t width, bool has_blocks)
{
    constexpr double new_for = 2;
    constexpr double plain_for = 5;
    look const how = value.is_bad or not value.outside.empty() ? look::alarm
                     : value.unchanged < new_for               ? look::strong
                     : value.unchanged < plain_for             ? look::plain
                                                               : look::faint;
    std::size_t const name_room = width * 2 / 5 + label_width;
    line.column(' ' + label_with(unit, value), name_room - 1, how).column("", 1);
    line.column(value.text, value.samples.empty() ? width : value_width - 1, how, not value.samples.empty());
    line.column("", 1).add(
        sparkline(value.samples, width > name_room + value_width ? width - name_room - value_width : 0, has_blocks),
        how);
}

std::vector<text_line> plot_of(shown_unit const& unit, shown_value const& value, std::size_t width, std::size_t height,
                               bool has_blocks)
{
    std::size_t const curve = width - scale_width;
    std::size_t const count = std::min(samples_of_plot(curve, has_blocks), value.samples.size());
    sample_range const range = range_of(value.samples.end() - static_cast<std::ptrdiff_t>(count), value.samples.end());
    bool const has_any = range.lowest <= range.highest;
    std::vector<text_line> lines(height, text_line{width, has_blocks});
    look const how = value.outside.empty() ? look::plain : look::alarm;
    lines[0].add(' ' + label_with(unit, value), look::strong).add("  " + value.text, how);
    lines[0].add(value.outside.empty() ? "" : "  " + value.outside, look::alarm);
    lines[0].at_right(count == 0 ? "no number yet" : "the last " + span_text(unit, count), look::faint);
    std::vector<std::string> const dots = plot(value.samples, curve, height - 1, has_blocks);
    for (std::size_t i = 0; i < dots.size(); ++i) {
        bool const is_last = i + 1 == dots.size(); // there is a curve that stays as it is
        double const at_edge = is_last ? range.lowest : range.highest;
        bool const is_edge = has_any and (is_last or (i == 0 and range.highest > range.lowest));
        std::string const scale = is_edge ? amount_text(at_edge, "%.5g") : std::string{};
        lines[i + 1].column(std::string(scale_width - 2 - std::min(scale.size(), scale_width - 2), ' ') + scale,
                            scale_width - 2);
        lines[i + 1].column(has_blocks ? "\u2502" : "|", 1, look::faint).column("", 1).add(dots[i], how);
    }
    return lines;
}

std::string title_of(shown_unit const& unit)
{
    std::string const number = "unit " + std::to_string(unit.address);
    std::string text = unit.name.empty() ? number : unit.name + ": " + number;
    bool const is_asked = unit.link == link_state::linked;
    text += ", " + (not unit.drive.empty() ? unit.drive : is_asked ? "no drive" : "not known yet which device");
    return unit.state.empty() or unit.link == link_state::lost ? text : text + ", " + unit.state;
}

std::vector<std::string> alarms_of(shown_unit const& unit)
{
    std::vector<std::string> all;
    if (unit.link == link_state::lost) {
        all.push_back(lost_text(unit) + "; what is shown is what it said last");
    }
    if (not unit.fault.empty()) {
        all.push_back("fault: " + unit.fault);
    }
    if (not unit.unread.empty()) {
        all.push_back("its state is not known: it answers a read of ETA with: " + unit.unread);
    }
    if (unit.is_local) {
        all.emplace_back("local: its keys or its terminals command it, not the line");
    }
    if (not unit.note.empty()) {
        all.push_back(unit.note);
    }
    for (shown_value const& each : unit.values) {
        if (not each.outside.empty()) {
            all.push_back(each.label + " is " + each.text + ": " + each.outside);
        }
    }
    return all;
}

} // namespace tool
