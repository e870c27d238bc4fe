// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
#include "monitor/draw_unit.hpp"

#include <algorithm>

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
    return unit.note.empty() ? text : text + ", " + unit.note;
}

/// The first value with a curve.
shown_value const* main_value(shown_unit const& unit)
{
    auto const found = std::find_if(unit.values.begin(), unit.values.end(),
                                    [](shown_value const& each) { return not each.samples.empty(); });
    return found != unit.values.end() ? &*found : nullptr;
}

} // namespace

void put_unit_titles(text_line& line)
{
    line.column(" name", name_width, look::strong).column("unit", address_width, look::strong);
    line.column("drive", drive_width, look::strong).add("state", look::strong);
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

void put_value(text_line& line, shown_value const& value, std::size_t width, bool has_blocks)
{
    bool const has_curve = not value.samples.empty();
    std::size_t const name_room = width * 2 / 5;
    line.column(" " + value.label, label_width - 1, look::strong).column("", 1);
    line.column(value.name, name_room - 1, look::faint).column("", 1);
    look const how = value.is_bad ? look::alarm : look::plain;
    if (not has_curve) {
        line.add(value.text, how);
        return;
    }
    line.column(value.text, value_width - 1, how).column("", 1);
    std::size_t const taken = label_width + name_room + value_width;
    line.add(sparkline(value.samples, width - taken, has_blocks));
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
    return all;
}

} // namespace tool
