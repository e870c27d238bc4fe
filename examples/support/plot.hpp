// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Reference, output, current and state of a drive over time: as characters, and as an SVG file.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>
#include <vector>

#include <rtuwire/drives.hpp>

#include "../../tools/support/say.hpp"

namespace examples {

using namespace tool;

/// One look at a drive.
struct sample {
    double time;      ///< s
    double reference; ///< Hz
    double output;    ///< Hz
    double current;   ///< A
    rtuwire::cia402::state state;
    bool is_known; ///< false while the link is lost
};

using history = std::vector<sample>;

/// One letter for a state.
inline char letter_of(sample const& at)
{
    using rtuwire::cia402::state;
    switch (at.is_known ? at.state : state::unknown) {
    case state::not_ready_to_switch_on: return 'n';
    case state::switch_on_disabled: return 'd';
    case state::ready_to_switch_on: return 'r';
    case state::switched_on: return 's';
    case state::operation_enabled: return 'O';
    case state::quick_stop_active: return 'Q';
    case state::fault_reaction_active:
    case state::fault: return 'F';
    case state::unknown: break;
    }
    return '?';
}

inline constexpr char letters[] = "d switch on disabled, r ready, s switched on, O operation, F fault, ? link lost";

/// A field of characters with a scale on its left.
class chart_area {
public:
    chart_area(double low, double high, std::size_t rows, std::size_t columns)
        : low_{low}, high_{high}, rows_(rows, std::string(columns, ' '))
    {}

    void mark(std::size_t column, double value, char with)
    {
        double const share = (high_ - value) / (high_ - low_);
        double const row = std::round(share * double(rows_.size() - 1));
        if (row >= 0 and row < double(rows_.size())) {
            rows_[std::size_t(row)][column] = with;
        }
    }

    void print(char const* unit) const
    {
        for (std::size_t row = 0; row < rows_.size(); ++row) {
            double const share = double(row) / double(rows_.size() - 1);
            say("%7.1f %-2s|%s\n", high_ - share * (high_ - low_), unit, rows_[row].c_str());
        }
    }

private:
    double low_;
    double high_;
    std::vector<std::string> rows_;
};

inline double highest_current(history const& all)
{
    double most = 0.1;
    for (sample const& each : all) {
        most = std::max(most, each.current);
    }
    return most;
}

/// The whole history in the terminal.
inline void print_plot(history const& all)
{
    constexpr std::size_t columns = 96;
    if (all.size() < 2) {
        return;
    }
    double const begin = all.front().time;
    double const length = all.back().time - begin;
    chart_area frequency{-60, 60, 13, columns};
    chart_area current{0, highest_current(all), 5, columns};
    std::string states(columns, ' ');
    std::size_t done = 0;
    for (sample const& each : all) {
        auto const column = std::min(columns - 1, std::size_t((each.time - begin) / length * columns));
        for (; done <= column; ++done) {
            states[done] = letter_of(each);
        }
        if (each.is_known) {
            frequency.mark(column, each.reference, '.');
            frequency.mark(column, each.output, '#');
            current.mark(column, each.current, '*');
        }
    }
    say("\n# output and . reference\n");
    frequency.print("Hz");
    say("* motor current\n");
    current.print("A");
    say("  state   |%s\n", states.c_str());
    say("          0 s %*.1f s\n          %s\n", int(columns) - 6, length, letters);
}

/// The same as a drawing of its own.
class svg_plot {
public:
    explicit svg_plot(history const& all) : all_{all} {}

    /// Whether the file was written.
    bool write(std::string const& path) const
    {
        std::FILE* const file = std::fopen(path.c_str(), "w");
        if (file == nullptr) {
            return false;
        }
        std::string const text = drawing();
        bool const is_written = std::fwrite(text.data(), 1, text.size(), file) == text.size();
        return (std::fclose(file) == 0) and is_written;
    }

private:
    static constexpr double width = 900, left = 60, right = 880;

    double x(double time) const
    {
        double const length = std::max(1.0, all_.back().time - all_.front().time);
        return left + (time - all_.front().time) / length * (right - left);
    }

    template <typename Value> std::string line(char const* colour, char const* dashes, Value value_of) const
    {
        // The line breaks where the link was lost.
        std::string text;
        bool is_open = false;
        for (sample const& each : all_) {
            if (not each.is_known) {
                text += is_open ? "\"/>\n" : "";
                is_open = false;
                continue;
            }
            char point[64];
            std::snprintf(point, sizeof point, "%.1f,%.1f ", x(each.time), value_of(each));
            if (not is_open) {
                text += std::string{"<polyline fill=\"none\" stroke=\""} + colour +
                        "\" stroke-width=\"2\" stroke-dasharray=\"" + dashes + "\" points=\"";
            }
            is_open = true;
            text += point;
        }
        return text + (is_open ? "\"/>\n" : "");
    }

    static std::string label(double x, double y, std::string const& text)
    {
        char place[64];
        std::snprintf(place, sizeof place, "<text x=\"%.1f\" y=\"%.1f\">", x, y);
        return place + text + "</text>\n";
    }

    static char const* colour_of(sample const& at)
    {
        switch (letter_of(at)) {
        case 'O': return "#7fbf7f";
        case 'F': return "#df7f7f";
        case 'Q': return "#dfbf7f";
        case '?': return "#bfbfbf";
        default: return "#cfdfef";
        }
    }

    std::string states() const
    {
        std::string text;
        for (std::size_t i = 0; i + 1 < all_.size(); ++i) {
            char bar[128];
            std::snprintf(bar, sizeof bar, "<rect x=\"%.1f\" y=\"410\" width=\"%.2f\" height=\"24\" fill=\"%s\"/>\n",
                          x(all_[i].time), x(all_[i + 1].time) - x(all_[i].time) + 0.3, colour_of(all_[i]));
            text += bar;
        }
        return text;
    }

    std::string drawing() const
    {
        std::string text = "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 900 470\" "
                           "font-family=\"sans-serif\" font-size=\"13\">\n"
                           "<rect width=\"900\" height=\"470\" fill=\"white\"/>\n"
                           "<path d=\"M60 140H880M60 40V240M60 280V390M60 390H880\" "
                           "stroke=\"#808080\" fill=\"none\"/>\n";
        if (all_.size() < 2) {
            return text + "</svg>\n";
        }
        double const most = highest_current(all_);
        text += line("#a0a0a0", "6 4", [](sample const& at) { return 140 - at.reference * 1.6; });
        text += line("#2060c0", "none", [](sample const& at) { return 140 - at.output * 1.6; });
        text += line("#c06020", "none", [most](sample const& at) { return 390 - at.current / most * 100; });
        char highest[32];
        std::snprintf(highest, sizeof highest, "%.1f A", most);
        char length[32];
        std::snprintf(length, sizeof length, "%.1f s", all_.back().time - all_.front().time);
        text += label(10, 64, "50 Hz") + label(10, 224, "-50 Hz") + label(10, 294, highest) +
                label(60, 28, "reference (dashed) and output frequency") + label(60, 272, "motor current") + states() +
                label(60, 456, "state: green operation, red fault, grey link lost") + label(width - 70, 456, length);
        return text + "</svg>\n";
    }

    history const& all_;
};

} // namespace examples
