// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
#include "monitor/draw.hpp"

#include <algorithm>
#include <cstdio>
#include <utility>

#include "monitor/draw_unit.hpp"

namespace tool {

namespace {

std::string keys_of(std::size_t width)
{
    constexpr std::size_t with_all = 100;
    return std::string{"q quit  up/down unit  </> value  g plot  c changed  t times  p pause  "} +
           (width >= with_all ? "b bell  +/- period  ? help" : "? help");
}

constexpr char const* help[]{
    "q          quit; so do Ctrl-C, TERM and HUP",
    "up, down   choose the unit whose values are shown (k, j)",
    "<, >       choose one of its values (left, right); g plots it, and again ends that",
    "c          only what has changed within 10 s, of all units; it fades",
    "t          how long responses took and what failed, in the place of states",
    "b          the bell at each new alarm, or none",
    "p          pause: nothing is asked until p is pressed again",
    "+, -       a longer, a shorter period between two rounds",
    "?          this page, and back",
    "monitor only reads. It writes nothing, and moves no motor.",
    "But each read holds off a drive's own time-out of the link: while this page",
    "reads, a drive does not notice that its controller is gone, and its motor may",
    "run on. A read of an idle drive starts that time-out: once this page has ended",
    "and nobody else asks, the next start may find SLF1 and need a reset.",
    "",
    "Red: a fault, a lost link, a drive under local control (its keys or terminals),",
    "a value outside of the limits that --alarm sets.",
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
            details();
        }
        foot();
        return std::move(lines_);
    }

private:
    text_line& line() { return lines_.emplace_back(width_, shown_.has_blocks); }

    void head()
    {
        std::size_t const alarms = shown_.alarms();
        text_line& first = line().add("rtuwire monitor ", look::strong).column(shown_.port, 32, look::plain, false);
        first.add("  every " + period_text(shown_.period));
        if (shown_.is_paused) {
            first.add("  PAUSED", look::alarm);
        }
        if (alarms > 0) {
            first.add("  " + std::to_string(alarms) + (alarms == 1 ? " alarm" : " alarms"), look::alarm);
        }
        if (shown_.has_bell) {
            first.add("  bell");
        }
        first.at_right(shown_.time);
        line();
    }

    /// The list of units, scrolled so that the selected one is in it.
    void units()
    {
        put_unit_titles(line(), shown_.has_times);
        std::size_t const count = shown_.units.size();
        std::size_t const room = std::min(count, std::max<std::size_t>(4, (height_ - frame_lines) / 2));
        std::size_t const first = std::min(shown_.selected < room ? 0 : shown_.selected - room + 1, count - room);
        for (std::size_t i = first; i < first + room; ++i) {
            shown_.has_times ? put_times(line(), shown_.units[i])
                             : put_unit(line(), shown_.units[i], width_, shown_.has_blocks);
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

    void details()
    {
        if (shown_.selected >= shown_.units.size()) {
            return;
        }
        shown_unit const& unit = shown_.units[shown_.selected];
        line().add(title_of(unit), look::strong).at_right(counts_text(unit.counts), look::faint);
        for (std::string const& each : alarms_of(unit)) {
            line().add(each, look::alarm);
        }
        if (not unit.lacks.empty()) {
            line().add(unit.lacks, look::faint);
        }
        auto const plotted = all_plotted();
        // All plots, where that leaves some values.
        std::size_t const least = std::min(plotted.size() * least_plot, room() - std::min(room(), least_values));
        std::size_t const for_plots = plotted.empty() ? 0 : std::max(room() * 3 / 5, least);
        std::size_t const for_values = room() - for_plots;
        shown_.has_changed_only ? changed(for_values) : values(unit, for_values);
        plots(plotted);
    }

    /// Lines above the foot.
    std::size_t room() const
    {
        std::size_t const end = height_ - foot_lines;
        return end > lines_.size() ? end - lines_.size() : 0;
    }

    /// Scrolled so that the chosen one is among them.
    void values(shown_unit const& unit, std::size_t most)
    {
        std::size_t const count = unit.values.size();
        std::size_t const shown = count <= most ? count : std::max<std::size_t>(most, 1) - 1;
        std::size_t const chosen = shown_.value < count ? shown_.value : 0;
        std::size_t const first = chosen < shown ? 0 : chosen - shown + 1;
        for (std::size_t i = first; i < first + shown and i < count; ++i) {
            bool const is_plotted = shown_.is_plotted(shown_.selected, i);
            put_value(line(), unit.values[i], {i == shown_.value, is_plotted}, width_, shown_.has_blocks);
        }
        if (shown < count and most > 0) {
            line().add(std::to_string(shown) + " of " + std::to_string(count) +
                           " values: < and > go through them, a higher terminal has more",
                       look::faint);
        }
    }

    /// What became another within some seconds, of all units.
    void changed(std::size_t most)
    {
        std::size_t const end = lines_.size() + most;
        for (shown_unit const& unit : shown_.units) {
            for (shown_value const& value : unit.values) {
                if (value.unchanged < faded and lines_.size() < end) {
                    put_changed(line(), unit, value, width_, shown_.has_blocks);
                }
            }
        }
        if (lines_.size() + most == end) {
            line().add("nothing has changed for 10 s", look::faint);
        }
    }

    using plotted_value = std::pair<shown_unit const*, shown_value const*>;

    std::vector<plotted_value> all_plotted() const
    {
        std::vector<plotted_value> all;
        for (std::size_t i = 0; i < shown_.units.size(); ++i) {
            for (std::size_t j = 0; j < shown_.units[i].values.size(); ++j) {
                if (shown_.is_plotted(i, j)) {
                    all.emplace_back(&shown_.units[i], &shown_.units[i].values[j]);
                }
            }
        }
        return all;
    }

    /// Below the values, of equal height each.
    void plots(std::vector<plotted_value> const& all)
    {
        if (all.empty()) {
            return;
        }
        std::size_t const most = std::max<std::size_t>(room() / least_plot, 1);
        std::size_t const count = std::min(all.size(), most);
        bool const has_more = count < all.size();
        std::size_t const lines = (room() > 0 ? room() - (has_more ? 1 : 0) : 0) / count;
        for (std::size_t i = 0; i < count and lines > 1; ++i) {
            for (text_line& each : plot_of(*all[i].first, *all[i].second, width_, lines, shown_.has_blocks)) {
                lines_.push_back(std::move(each));
            }
        }
        if (has_more) {
            line().add("plots that need a higher terminal: " + std::to_string(all.size() - count), look::faint);
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
        line().add(keys_of(width_), look::strong);
    }

    static constexpr std::size_t foot_lines = 2;
    static constexpr std::size_t least_plot = 4; ///< lines, with its title
    static constexpr std::size_t least_values = 4;
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
