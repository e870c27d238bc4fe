// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// The screen of `monitor` as text: what is on it, and that it fits.
#include "../../tools/rtuwire/monitor/draw.hpp"

#include <algorithm>
#include <string>
#include <vector>

#include "../../tools/rtuwire/monitor/keys.hpp"
#include "../../tools/rtuwire/monitor/sparkline.hpp"
#include "support/catch.hpp"

using namespace tool;

namespace {

/// Characters, counted by their first bytes.
std::size_t characters(std::string const& text)
{
    return static_cast<std::size_t>(
        std::count_if(text.begin(), text.end(), [](char each) { return each >= 0 or (each & 0x40) != 0; }));
}

shown_unit drive(unsigned address, std::string const& name)
{
    shown_unit unit{.address = address, .name = name, .drive = "atv320", .link = link_state::linked};
    unit.state = "operation enabled";
    unit.values.push_back({"RFR", "Output frequency", "50.0 Hz", false, {0, 10, 20, 50}});
    unit.values.push_back({"HMIS", "Product state", "rUn: running", false, {}});
    return unit;
}

shown_screen screen_of(std::size_t units)
{
    shown_screen shown{.port = "/dev/ttyUSB0", .time = "12:34:56"};
    for (std::size_t i = 0; i < units; ++i) {
        shown.units.push_back(drive(static_cast<unsigned>(i + 1), "drive" + std::to_string(i + 1)));
    }
    return shown;
}

/// The line that holds a text, and whether all of that text is in red.
struct found_line {
    bool is_there{false};
    bool is_alarm{false};
    bool is_selected{false};
};

found_line find(std::vector<text_line> const& page, std::string const& text)
{
    for (text_line const& each : page) {
        if (each.text().find(text) != std::string::npos) {
            bool const is_alarm = std::any_of(each.pieces().begin(), each.pieces().end(), [&](text_piece const& piece) {
                return piece.how == look::alarm and piece.text.find(text) != std::string::npos;
            });
            return {true, is_alarm, each.is_selected()};
        }
    }
    return {};
}

void check_fits(shown_screen const& shown, std::size_t width, std::size_t height)
{
    INFO(width << "x" << height);
    auto const page = draw(shown, width, height);
    CHECK(page.size() <= height);
    for (text_line const& each : page) {
        INFO(each.text());
        CHECK(characters(each.text()) <= width);
    }
}

} // namespace

TEST_CASE("monitor: the screen has the port, the units with their states and values, and the keys")
{
    auto const page = draw(screen_of(3), 80, 24);
    CHECK(page.size() == 24);
    CHECK(page.front().text().find("/dev/ttyUSB0  every 0.5 s") != std::string::npos);
    CHECK(page.front().text().ends_with("12:34:56"));
    CHECK(page.back().text() == "q quit   up/down drive   p pause   +/- period   ? help");
    for (char const* const each : {"drive1", "drive2", "drive3"}) {
        CHECK(find(page, each).is_there);
    }
    CHECK(find(page, " drive1      1    atv320       operation enabled").is_selected);
    CHECK(find(page, "drive1: unit 1, atv320, operation enabled").is_there);
    CHECK(find(page, "RFR        Output frequency").is_there);
    CHECK(find(page, "50.0 Hz").is_there);
    CHECK(find(page, "▁▂▄█").is_there);
    CHECK(find(page, "hold off the drives' own time-outs").is_there);
    CHECK_FALSE(find(page, "alarm").is_there);
}

TEST_CASE("monitor: a fault, a lost link and local control are alarms, each in words")
{
    shown_screen shown = screen_of(4);
    shown.units[0].fault = "SLF1: Modbus interrupted";
    shown.units[0].state = "fault";
    shown.units[1].link = link_state::lost;
    shown.units[1].silent_seconds = 12.7;
    shown.units[2].is_local = true;
    auto const page = draw(shown, 80, 24);
    CHECK(find(page, "3 alarms").is_alarm);
    CHECK(find(page, "fault, SLF1: Modbus interrupted").is_alarm);
    CHECK(find(page, "fault: SLF1: Modbus interrupted").is_alarm);
    CHECK(find(page, "link lost, silent for 12 s").is_alarm);
    CHECK(find(page, "operation enabled, local").is_alarm);
    CHECK(find(page, "drive4").is_there);
    CHECK_FALSE(find(page, "drive4").is_alarm);
}

TEST_CASE("monitor: no line is longer than the terminal, and there are no more than it has")
{
    shown_screen shown = screen_of(40);
    shown.selected = 39;
    shown.units[39].name = "ein sehr langer Name für einen Antrieb";
    shown.units[39].note = std::string(300, 'x');
    for (int i = 0; i < 60; ++i) {
        shown.units[39].values.push_back({"LONGLABEL" + std::to_string(i), std::string(50, 'n'), std::string(99, 't'),
                                          true, std::deque<double>(400, 1.0)});
    }
    for (bool const has_help : {false, true}) {
        shown.has_help = has_help;
        for (std::size_t const width : {0U, 1U, 7U, 40U, 79U, 80U, 81U, 120U, 400U}) {
            for (std::size_t const height : {0U, 1U, 2U, 23U, 24U, 25U, 40U, 200U}) {
                check_fits(shown, width, height);
            }
        }
    }
}

TEST_CASE("monitor: a terminal below 80x24 is told what is needed, and one of that size is not")
{
    for (auto const& [width, height] : std::vector<std::pair<std::size_t, std::size_t>>{{79, 24}, {80, 23}, {30, 10}}) {
        std::string all;
        for (text_line const& each : draw(screen_of(2), width, height)) {
            all += each.text() + " ";
        }
        CHECK(all == "This terminal has " + std::to_string(width) + "x" + std::to_string(height) +
                         " characters; monitor needs 80x24. q quits. ");
    }
    CHECK_FALSE(find(draw(screen_of(2), 80, 24), "monitor needs").is_there);
}

TEST_CASE("monitor: many units are scrolled, so that the chosen one is on the screen")
{
    shown_screen shown = screen_of(50);
    for (std::size_t i = 0; i < 50; ++i) {
        shown.selected = i;
        auto const page = draw(shown, 80, 24);
        std::string const name = " drive" + std::to_string(i + 1) + " ";
        INFO(name);
        CHECK(find(page, name).is_selected);
        CHECK(page.back().text().starts_with("q quit"));
    }
    CHECK(find(draw(shown, 80, 24), "42 to 50 of 50 units").is_there);
}

TEST_CASE("monitor: values that do not fit are counted")
{
    shown_screen shown = screen_of(1);
    shown.units[0].values.resize(40, {"LCR", "Motor current", "1.0 A", false, {}});
    auto const page = draw(shown, 80, 24);
    auto const shown_lines = std::count_if(page.begin(), page.end(), [](text_line const& each) {
        return each.text().find("RFR  ") == 1 or each.text().find("HMIS ") == 1 or each.text().find("LCR ") == 1;
    });
    CHECK(find(page, std::to_string(40 - shown_lines) + " more values").is_there);
    CHECK_FALSE(find(draw(shown, 80, 60), "more values").is_there);
}

TEST_CASE("monitor: the help says what reads do to a drive's own time-out")
{
    shown_screen shown = screen_of(1);
    shown.has_help = true;
    auto const page = draw(shown, 80, 24);
    CHECK(find(page, "each read holds off a drive's own time-out").is_there);
    CHECK(find(page, "It writes nothing").is_there);
    CHECK_FALSE(find(page, "drive1").is_there);
    CHECK(page.back().text().starts_with("q quit"));
}

TEST_CASE("monitor: what ends the program is on the screen, in red")
{
    shown_screen shown = screen_of(1);
    shown.failure = "/dev/ttyUSB0: vanished";
    CHECK(find(draw(shown, 80, 24), "/dev/ttyUSB0: vanished").is_alarm);
}

TEST_CASE("monitor: a name with control characters cannot move the cursor")
{
    shown_screen shown = screen_of(1);
    shown.units[0].name = "a\x1b[2J\n\x7f";
    CHECK(find(draw(shown, 80, 24), "a?[2J??").is_there);
}

TEST_CASE("monitor: a sparkline shows the newest samples at the right, between the lowest and the highest")
{
    CHECK(sparkline({0, 1, 2, 3, 4, 5, 6, 7}, 8, true) == "▁▂▃▄▅▆▇█");
    CHECK(sparkline({0, 1, 2, 3, 4, 5, 6, 7}, 4, true) == "▁▃▆█");
    CHECK(sparkline({-7, 0}, 5, true) == "   ▁█");
    CHECK(sparkline({3, 3, 3}, 3, true) == "▁▁▁");
    CHECK(sparkline({0, NAN, 7}, 3, true) == "▁ █");
    CHECK(sparkline({NAN, NAN}, 3, true) == "   ");
    CHECK(sparkline({}, 3, true) == "   ");
    CHECK(sparkline({1, 2}, 0, true).empty());
    CHECK(sparkline({0, 1, 2, 3, 4, 5, 6, 7}, 8, false) == "_.-~+*%#");
}

TEST_CASE("monitor: a value keeps as many samples as any terminal shows, and no more")
{
    shown_value value;
    for (int i = 0; i < 1'000; ++i) {
        value.add_sample(i);
    }
    CHECK(value.samples.size() == shown_value::most_samples);
    CHECK(value.samples.back() == 999);
}

TEST_CASE("monitor: keys choose a unit, pause, and change the period, and stop at the ends")
{
    shown_screen shown = screen_of(2);
    apply(key::up, shown);
    CHECK(shown.selected == 0);
    apply(key::down, shown);
    apply(key::down, shown);
    CHECK(shown.selected == 1);
    apply(key::up, shown);
    CHECK(shown.selected == 0);
    apply(key::pause, shown);
    CHECK(shown.is_paused);
    CHECK(find(draw(shown, 80, 24), "PAUSED").is_there);
    apply(key::pause, shown);
    CHECK_FALSE(shown.is_paused);
    apply(key::longer, shown);
    CHECK(period_text(shown.period) == "1 s");
    for (int i = 0; i < 20; ++i) {
        apply(key::longer, shown);
    }
    CHECK(period_text(shown.period) == "1 min");
    for (int i = 0; i < 20; ++i) {
        apply(key::shorter, shown);
    }
    CHECK(period_text(shown.period) == "0.1 s");
    CHECK(shorter_period(0.3) == 0.2);
    CHECK(longer_period(0.3) == 0.5);
    CHECK(longer_period(3'600) == 3'600);
    CHECK(shorter_period(3'600) == 60);
    shown_screen none;
    apply(key::down, none);
    CHECK(none.selected == 0);
}
