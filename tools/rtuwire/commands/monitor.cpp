// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Several units on a full screen. It only reads.
#include <algorithm>
#include <chrono>
#include <csignal>
#include <iterator>
#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "../support/signals.hpp"
#include "commands/commands.hpp"
#include "line/asked_registers.hpp"
#include "line/asked_units.hpp"
#include "line/end_wish.hpp"
#include "line/line_words.hpp"
#include "line/time_text.hpp"
#include "monitor/draw.hpp"
#include "monitor/limits.hpp"
#include "monitor/line_thread.hpp"
#include "monitor/terminal.hpp"

namespace tool {

namespace {

/// A silent unit holds up the others so long, and the end of the program.
constexpr double usual_timeout = 0.3;
constexpr double longest_timeout = 3.0;
constexpr double usual_period = 0.5;

/// Ends with what does without a screen.
void refuse_screen(choices const& chosen, std::string const& why, std::string_view form = "")
{
    refuse_word(why + "; `" + shown_command(chosen.line, std::string{form} + "watch RFR ETA") +
                "` writes lines, to a pipe or a file as well");
}

/// `monitor 7 3 2` where no unit was said: registers of unit 1, and meant for units.
void refuse_units_as_registers(choices const& chosen)
{
    constexpr unsigned longest_address = 3, highest_unit = 247;
    bool const is_meant = not chosen.line.is_unit_named and chosen.line.names.empty() and not chosen.words.empty() and
                          std::ranges::all_of(chosen.words, [](std::string const& word) {
                              bool const is_short = word.find_first_not_of("0123456789") == word.npos and
                                                    word.size() <= longest_address and not word.empty();
                              return is_short and std::stoul(word) >= 1 and std::stoul(word) <= highest_unit;
                          });
    if (not is_meant) {
        return;
    }
    std::string units;
    for (std::string const& each : chosen.words) {
        units += (units.empty() ? "" : ",") + each;
    }
    line_choices line = chosen.line;
    line.typed.unit = " -u " + units;
    refuse_word("the words of monitor are registers, and nobody said of which unit; `" +
                shown_command(line, "monitor") + "` shows the units " + units);
}

void check(choices const& chosen)
{
    refuse_units_as_registers(chosen);
    if (chosen.form != output_form::table) {
        refuse_screen(chosen, "monitor draws a screen, no --json and no --csv", "--json ");
    }
    try {
        check_terminal();
    } catch (ended const& why) {
        refuse_screen(chosen, why.what());
    }
    if (chosen.line.response_timeout.value_or(0) > longest_timeout) {
        refuse_word("--timeout of more than 3 s: monitor would not end when q is pressed");
    }
}

/// A request is not repeated at once: the next round does it.
std::unique_ptr<open_line> open(line_choices line)
{
    line.retries = 0;
    line.is_verbose = false; // the screen is full
    line.response_timeout = line.response_timeout.value_or(usual_timeout);
    return std::make_unique<open_line>(line);
}

/// A word without a unit behind it that another one is known to have is none of a unit that lacks it.
bool is_of_another(named_unit const& unit, std::string const& word, std::vector<named_unit> const& units)
{
    return not is_known_to(unit, word) and
           std::ranges::any_of(units, [&word](named_unit const& each) { return is_known_to(each, word); });
}

/// The words that mean this unit.
std::vector<std::string> own_words(named_unit const& unit, std::vector<std::string> const& typed,
                                   std::vector<named_unit> const& units)
{
    std::vector<std::string> words = words_for(unit, typed, units);
    std::erase_if(words, [&](std::string const& word) { return is_of_another(unit, word, units); });
    return words;
}

std::vector<value_limit> limits_of(named_unit const& unit, std::vector<std::string> const& typed,
                                   std::vector<named_unit> const& units)
{
    std::vector<value_limit> all;
    for (std::string const& each : typed) {
        value_limit limit = limit_in(each);
        for (std::string const& word : own_words(unit, {limit.word}, units)) {
            limit.word = word;
            all.push_back(limit);
        }
    }
    return all;
}

std::vector<unit_reader> readers(choices const& chosen)
{
    std::vector<named_unit> const units = units_watched(chosen.line);
    monitor_choices const& how = chosen.monitor;
    std::vector<std::string> words = chosen.words;
    words.insert(words.end(), how.plots.begin(), how.plots.end());
    std::ranges::transform(how.alarms, std::back_inserter(words),
                           [](std::string const& each) { return limit_in(each).word; });
    check_register_words(words, units);
    std::vector<unit_reader> all;
    for (named_unit const& each : units) {
        all.emplace_back(unit_wish{.unit = each,
                                   .words = words_for(each, chosen.words, units),
                                   .plots = own_words(each, how.plots, units),
                                   .limits = limits_of(each, how.alarms, units),
                                   .misses = chosen.line.retries + 1});
    }
    return all;
}

class monitoring {
public:
    explicit monitoring(line_thread& line, double period, bool has_bell) : line_{line}
    {
        shown_.has_bell = has_bell;
        shown_.port = line.device();
        shown_.period = period;
    }

    /// Until somebody ends it; the terminal is restored when it returns, and when it throws.
    exit_status run()
    {
        full_screen screen;
        shown_.has_blocks = screen.has_blocks();
        for (key pressed = key::redraw; pressed != key::quit; pressed = screen.next_key(redraw_time)) {
            if (noted_signal() != 0) {
                return static_cast<exit_status>(128 + noted_signal());
            }
            if (pressed == key::gone) {
                return static_cast<exit_status>(128 + hang_up); // before its signal, or where that is ignored
            }
            apply(pressed, shown_);
            line_.set_period(shown_.period);
            line_.set_paused(shown_.is_paused);
            refresh();
            if (std::size_t const now = shown_.alarms(); now != alarms_) {
                bool const is_new = now > std::exchange(alarms_, now);
                is_new and shown_.has_bell ? screen.ring() : void();
            }
            screen.show(draw(shown_, screen.width(), screen.height()));
            if (not shown_.failure.empty()) {
                throw ended{exit_status::port, shown_.failure};
            }
        }
        return exit_status::done;
    }

private:
    static constexpr std::chrono::milliseconds redraw_time{100};

    void refresh()
    {
        shown_.units = line_.units();
        shown_.failure = line_.failure();
        shown_.time = time_text(unix_now()).substr(11, 8);
    }

    line_thread& line_;
    shown_screen shown_{};
    std::size_t alarms_{0};
};

} // namespace

exit_status run_monitor(choices const& chosen)
{
    check(chosen);
    std::vector<unit_reader> units = readers(chosen);
    note_signals();
    double const period = chosen.every.value_or(usual_period);
    line_thread line{open(chosen.line), std::move(units), period};
    return monitoring{line, period, chosen.monitor.has_bell}.run();
}

} // namespace tool
