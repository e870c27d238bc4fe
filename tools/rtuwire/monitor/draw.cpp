// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
#include "monitor/draw.hpp"

#include <algorithm>
#include <cstdio>

#include "monitor/draw_unit.hpp"

namespace tool {

namespace {

constexpr char const* keys = "q quit   up/down drive   p pause   +/- period   ? help";

constexpr char const* help[]{
    "q          quit; so do Ctrl-C, TERM and HUP",
    "up, down   choose the drive whose values are shown (k, j)",
    "p          pause: nothing is asked until p is pressed again",
    "+, -       a longer, a shorter period between two rounds",
    "?          this page, and back",
    "",
    "monitor only reads. It writes nothing, and moves no motor.",
    "But each read holds off a drive's own time-out of the link: while this page",
    "reads, a drive does not notice that its controller is gone, and its motor may",
    "run on. A read of an idle drive starts that time-out: once this page has ended",
    "and nobody else asks, the next start may find SLF1 and need a reset.",
    "",
    "Red: a fault, a lost link, a drive under local control (its keys or terminals).",
    "A unit that does not respond is asked less often, up to every 8 seconds.",
};

class drawing {
public:
    drawing(shown_screen const& shown, std::size_t width, std::size_t height)
        : shown_{shown}, width_{width}, height_{height}
    {}

    std::vector<text_line> small()
    {
        std::string const text = "This terminal has " + std::to_string(width_) + "x" + std::to_string(height_) +
                                 " characters; monitor needs 80x24. q quits.";
        for (std::string const& each : wrapped(text, width_)) {
            line().add(each);
        }
        lines_.erase(lines_.begin() + static_cast<std::ptrdiff_t>(std::min(lines_.size(), height_)), lines_.end());
        return std::move(lines_);
    }

    std::vector<text_line> whole()
    {
        head();
        if (shown_.has_help) {
            for (char const* const each : help) {
                line().add(each);
            }
        } else {
            units();
            values();
        }
        foot();
        return std::move(lines_);
    }

private:
    text_line& line() { return lines_.emplace_back(width_, shown_.has_blocks); }

    void head()
    {
        auto const alarms = std::count_if(shown_.units.begin(), shown_.units.end(),
                                          [](shown_unit const& each) { return each.has_alarm(); });
        text_line& first = line().add("rtuwire monitor ", look::strong).column(shown_.port, 32, look::plain, false);
        first.add("  every " + period_text(shown_.period));
        if (shown_.is_paused) {
            first.add("  PAUSED", look::alarm);
        }
        if (alarms > 0) {
            first.add("  " + std::to_string(alarms) + (alarms == 1 ? " alarm" : " alarms"), look::alarm);
        }
        first.at_right(shown_.time);
        line();
    }

    /// The list of units, scrolled so that the selected one is in it.
    void units()
    {
        put_unit_titles(line());
        std::size_t const count = shown_.units.size();
        std::size_t const room = std::min(count, std::max<std::size_t>(4, (height_ - frame_lines) / 2));
        std::size_t const first = std::min(shown_.selected < room ? 0 : shown_.selected - room + 1, count - room);
        for (std::size_t i = first; i < first + room; ++i) {
            put_unit(line(), shown_.units[i], width_, shown_.has_blocks);
            if (i == shown_.selected) {
                lines_.back().select();
            }
        }
        bool const is_all = room == count;
        line().add(is_all ? ""
                          : std::to_string(first + 1) + " to " + std::to_string(first + room) + " of " +
                                std::to_string(count) + " units",
                   look::faint);
    }

    void values()
    {
        if (shown_.selected >= shown_.units.size()) {
            return;
        }
        shown_unit const& unit = shown_.units[shown_.selected];
        line().add(title_of(unit), look::strong);
        for (std::string const& each : alarms_of(unit)) {
            line().add(each, look::alarm);
        }
        std::size_t const end = height_ - foot_lines;
        std::size_t const room = end > lines_.size() ? end - lines_.size() : 0;
        std::size_t const count = unit.values.size();
        std::size_t const shown = count <= room ? count : std::max<std::size_t>(room, 1) - 1;
        for (std::size_t i = 0; i < shown; ++i) {
            put_value(line(), unit.values[i], width_, shown_.has_blocks);
        }
        if (shown < count) {
            line().add(std::to_string(count - shown) + " more values: they need a higher terminal", look::faint);
        }
    }

    /// At the lower end, whatever is above.
    void foot()
    {
        std::size_t const above = height_ - foot_lines;
        lines_.resize(above, text_line{width_});
        if (shown_.failure.empty()) {
            line().add("Reads only. Its reads hold off the drives' own time-outs: see ?", look::faint);
        } else {
            line().add(shown_.failure, look::alarm);
        }
        line().add(keys, look::strong);
    }

    static constexpr std::size_t foot_lines = 2;
    static constexpr std::size_t frame_lines = 6; ///< head, titles, gap, foot

    shown_screen const& shown_;
    std::size_t width_;
    std::size_t height_;
    std::vector<text_line> lines_{};
};

} // namespace

std::string period_text(double seconds)
{
    bool const is_long = seconds >= 60;
    char text[32];
    std::snprintf(text, sizeof text, is_long ? "%g min" : "%g s", is_long ? seconds / 60 : seconds);
    return text;
}

std::vector<text_line> draw(shown_screen const& shown, std::size_t width, std::size_t height)
{
    drawing page{shown, width, height};
    return width < least_width or height < least_height ? page.small() : page.whole();
}

} // namespace tool
