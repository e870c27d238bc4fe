// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// What a line does with its time, live or from a capture.
#include <algorithm>
#include <cmath>
#include <string>

#include "commands/commands.hpp"
#include "frame/line_figures.hpp"
#include "line/end_wish.hpp"
#include "line/open_line.hpp"
#include "line/played_capture.hpp"
#include "line/tap.hpp"
#include "line/time_text.hpp"

namespace tool {

namespace {

std::int64_t whole(std::uint64_t count) { return static_cast<std::int64_t>(count); }

record of_line(line_figures const& line)
{
    return {{"seconds", line.seconds()},
            {"frames", whole(line.frames())},
            {"load %", std::round(line.load() * 1'000.0) / 10.0},
            {"shortest silence ms", line.shortest_silence()},
            {"silences below t3.5", whole(line.too_close())},
            {"stray bytes", whole(line.stray_bytes())}};
}

record of_unit(std::uint8_t number, unit_figures const& unit)
{
    return {{"unit", std::int64_t{number}},
            {"requests", whole(unit.requests)},
            {"answered", whole(unit.answered)},
            {"refused", whole(unit.refused)},
            {"unanswered", whole(unit.unanswered)},
            {"damaged", whole(unit.damaged)},
            {"shortest ms", unit.response_times.quantile(0)},
            {"median ms", unit.response_times.quantile(0.5)},
            {"99 % ms", unit.response_times.quantile(0.99)},
            {"longest ms", unit.response_times.quantile(1)}};
}

void show_histogram(line_figures const& line, output& results)
{
    auto const counts = line.histogram();
    std::uint64_t const most = *std::max_element(counts.begin(), counts.end());
    for (std::size_t i = 0; i < counts.size() and most > 0; ++i) {
        std::string const last = std::to_string(line_figures::limits.back());
        std::string const range =
            i < line_figures::limits.size() ? "below " + std::to_string(line_figures::limits[i]) : "above " + last;
        results.put({{"response ms", range},
                     {"count", whole(counts[i])},
                     {"", std::string(static_cast<std::size_t>(counts[i] * 40 / most), '#')}});
    }
}

} // namespace

exit_status run_timing(choices const& chosen)
{
    note_signals();
    line_figures line;
    auto const take = [&line](tapped_frame const& it) { line.take(it); };
    if (chosen.file.empty() and not is_capture(chosen)) {
        any_port port = open_to_listen(chosen);
        line_calendar const calendar{unix_now()};
        listen(port, chosen, calendar, take, [] { return true; });
    } else {
        play_capture(capture_in(chosen), setting_in(chosen.line), take);
    }
    output results{chosen.form, false};
    results.put(of_line(line));
    for (auto const& [number, unit] : line.units()) {
        results.put(of_unit(number, unit));
    }
    if (chosen.form == output_form::table) {
        show_histogram(line, results);
    }
    results.finish();
    return line.frames() > 0 ? exit_status::done : exit_status::no_answer;
}

} // namespace tool
