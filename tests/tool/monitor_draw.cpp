// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// The screen of `monitor` as text: what is on it, and that it fits.
#include "../../tools/rtuwire/monitor/draw.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include "exit_status.hpp"

#include "../../tools/rtuwire/monitor/keys.hpp"
#include "../../tools/rtuwire/monitor/limits.hpp"
#include "../../tools/rtuwire/monitor/plot.hpp"
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
    CHECK(page.back().text() == "q quit  up/down unit  </> value  g plot  c changed  t times  p pause  ? help");
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

TEST_CASE("monitor: values that do not fit are counted, and scrolled so that the chosen one is on the screen")
{
    shown_screen shown = screen_of(1);
    for (int i = 0; i < 40; ++i) {
        shown.units[0].values.push_back({"V" + std::to_string(i), "", "1.0 A", false, {}});
    }
    CHECK(find(draw(shown, 80, 24), " of 42 values").is_there);
    CHECK_FALSE(find(draw(shown, 80, 60), " of 42 values").is_there);
    for (int i = 0; i < 42; ++i) {
        apply(key::next_value, shown);
        std::string const label = shown.units[0].values[static_cast<std::size_t>(i)].label;
        INFO(label);
        CHECK(find(draw(shown, 80, 24), '>' + label + ' ').is_there);
    }
    apply(key::next_value, shown);
    CHECK(shown.value == 41);
    for (int i = 0; i < 50; ++i) {
        apply(key::value_before, shown);
    }
    CHECK(shown.value == shown_screen::no_value);
}

TEST_CASE("monitor: a value outside of its limits is an alarm of its unit, with the limit in words")
{
    shown_screen shown = screen_of(2);
    shown.units[1].values[0].outside = "above 45 Hz";
    CHECK(shown.alarms() == 1);
    auto page = draw(shown, 80, 24);
    CHECK(find(page, "1 alarm").is_alarm);
    CHECK(find(page, "RFR above 45 Hz").is_alarm);
    apply(key::down, shown);
    page = draw(shown, 80, 24);
    CHECK(find(page, "RFR is 50.0 Hz: above 45 Hz").is_alarm);
}

TEST_CASE("monitor: limits are typed as numbers with a unit or without, and what is none is refused")
{
    value_limit const both = limit_in("RFR@fan=-4.5..45Hz");
    CHECK(both.word == "RFR@fan");
    CHECK((both.lowest == -4.5 and both.highest == 45 and both.unit == "Hz"));
    CHECK(outside_text(both, 45, "Hz").empty());
    CHECK(outside_text(both, 45.1, "Hz") == "above 45 Hz");
    CHECK(outside_text(both, -5, "Hz") == "below -4.5 Hz");
    CHECK(outside_text(both, 5, "rpm") == "its limit is in Hz, and it is in rpm");
    CHECK(outside_text(both, 5, "") == "its limit is in Hz, and it is without a unit");
    CHECK(outside_text(both, NAN, "Hz") == "no number, which its limit is of");
    CHECK_FALSE(limit_in("a=..1").lowest);
    CHECK_FALSE(limit_in("input:4:f32=1m3/h..").highest);
    CHECK(outside_text(limit_in("a=..1"), 2, "V") == "above 1 V");
    for (std::string const wrong : {"", "a", "=1..2", "a=1", "a=..", "a=2..1", "a=1,5..2", "a=nan..", "a=..inf",
                                    "a=1V..2A", "a=x..2", "a=1 ..2"}) {
        INFO(wrong);
        CHECK_THROWS_AS(limit_in(wrong), ended);
    }
}

TEST_CASE("monitor: a plot has its curve between the lowest and the highest, with gaps, in braille or in ASCII")
{
    CHECK(plot({0, 1, 2, 3}, 2, 1, true) == std::vector<std::string>{"⡠⠊"});
    CHECK(plot({0, 3}, 1, 1, true) == std::vector<std::string>{"⡸"});
    CHECK(plot({3, 3, 3}, 3, 2, true) == std::vector<std::string>{"   ", " ⢀⣀"});
    CHECK(plot({0, NAN, 3}, 2, 1, true) == std::vector<std::string>{"⢀⠈"});
    CHECK(plot({0, 1}, 2, 1, false) == std::vector<std::string>{".'"});
    CHECK(plot({0, 3}, 3, 2, false) == std::vector<std::string>{"  :", " .'"});
    CHECK(plot({}, 2, 1, true) == std::vector<std::string>{"  "});
    CHECK(plot({1, 2}, 2, 0, true).empty());
    CHECK(plot({1, 2}, 0, 1, true) == std::vector<std::string>{""});
}

TEST_CASE("monitor: plots are chosen by a key, share the room below the values, and are counted where they do not fit")
{
    shown_screen shown = screen_of(2);
    apply(key::plot, shown); // none is chosen: the first with a curve
    CHECK(find(draw(shown, 80, 24), " RFR@drive1  50.0 Hz").is_there);
    CHECK(find(draw(shown, 80, 24), "      50│ ").is_there);
    CHECK(find(draw(shown, 80, 24), "       0│ ").is_there);
    CHECK(find(draw(shown, 80, 24), " RFR       ~").is_there);
    apply(key::down, shown);
    apply(key::plot, shown);
    CHECK(find(draw(shown, 80, 24), " RFR@drive1").is_there);
    CHECK(find(draw(shown, 80, 24), " RFR@drive2").is_there);
    apply(key::plot, shown);
    CHECK_FALSE(find(draw(shown, 80, 24), " RFR@drive2").is_there);
    shown.units[0].values[0].samples = {7, 7};
    CHECK(find(draw(shown, 80, 24), "       7│ ").is_there);
    for (shown_unit& each : shown.units) {
        for (int i = 0; i < 4; ++i) {
            each.values.push_back({"V" + std::to_string(i), "", "1", false, {1, 2}});
            each.values.back().is_plotted = true;
        }
    }
    for (std::size_t const width : {80U, 120U}) {
        for (std::size_t const height : {24U, 25U, 31U, 60U, 200U}) {
            check_fits(shown, width, height);
        }
    }
    CHECK(find(draw(shown, 80, 24), "plots that need a higher terminal: ").is_there);
    CHECK_FALSE(find(draw(shown, 80, 60), "plots that need").is_there);
}

TEST_CASE("monitor: what has changed is shown of all units, fades, and goes")
{
    shown_screen shown = screen_of(2);
    apply(key::changed, shown);
    CHECK(find(draw(shown, 80, 24), "nothing has changed for 10 s").is_there);
    shown_value& value = shown.units[1].values[0];
    auto const how = [&shown] {
        for (text_line const& each : draw(shown, 80, 24)) {
            if (each.text().starts_with(" RFR@drive2")) {
                return std::optional{each.pieces().front().how};
            }
        }
        return std::optional<look>{};
    };
    value.unchanged = 0.5;
    CHECK(how() == look::strong);
    value.unchanged = 3;
    CHECK(how() == look::plain);
    value.unchanged = 7;
    CHECK(how() == look::faint);
    value.outside = "above 45 Hz";
    CHECK(how() == look::alarm);
    value.unchanged = 10;
    CHECK_FALSE(how());
}

TEST_CASE("monitor: response times and errors of each unit")
{
    shown_screen shown = screen_of(2);
    shown.units[0].counts = {
        .asked = 12, .silent = 1, .refused = 2, .damaged = 3, .last = 8.25, .longest = 24.1, .sum = 80};
    CHECK(find(draw(shown, 80, 24), "8.2 ms, longest 24.1; 6 of 12 failed").is_there);
    apply(key::times, shown);
    CHECK(find(draw(shown, 80, 24), "      8.2    10.0     24.1       12       1        2        3").is_there);
    apply(key::times, shown);
    CHECK(find(draw(shown, 80, 24), "operation enabled").is_there);
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
