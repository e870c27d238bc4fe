// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Stands between other people's client and server, and plays what goes wrong on lines.
#include <algorithm>
#include <array>
#include <chrono>
#include <cstdio>
#include <memory>
#include <string>
#include <vector>

#include "../support/platform.hpp"
#include "chaos/disturbed_line.hpp"
#include "chaos/line_end.hpp"
#include "commands/commands.hpp"
#include "line/capture_output.hpp"
#include "line/end_wish.hpp"
#include "line/line_words.hpp"
#include "line/time_text.hpp"
#include "output/output.hpp"
#include "output/passing_text.hpp"
#include "port/own_terminal.hpp"

namespace tool {

namespace {

using rtuwire::duration;
using rtuwire::instant;
using std::chrono::steady_clock;

fault_plan plan_in(choices const& chosen)
{
    if (chosen.chaos.faults.empty()) {
        refuse_word("chaos: which faults? say --faults late=1%,lost@250; chaos --help names all");
    }
    line_setting const how = setting_in(chosen.line);
    return {.faults = faults_in(chosen.chaos.faults),
            .seed = chosen.chaos.seed,
            .time_out = seconds_in(chosen.line.response_timeout.value_or(1.0)),
            .character = rtuwire::line_timing{how.baud, how.format}.characters(1)};
}

/// What each fault would meet.
exit_status tell_plan(choices const& chosen)
{
    constexpr std::uint32_t looked_at = 1'000;
    constexpr std::uint32_t most_named = 12;
    fault_plan const plan = plan_in(chosen);
    output results{chosen.form, false};
    for (line_fault const& fault : plan.faults) {
        std::uint32_t met = 0;
        std::string frames;
        for (std::uint32_t number = 1; number <= looked_at; ++number) {
            if (meets(fault, plan.seed, number)) {
                frames += met < most_named ? (met > 0 ? " " : "") + std::to_string(number) : "";
                ++met;
            }
        }
        frames += met > most_named ? " ..." : "";
        results.put({{"fault", fault.typed},
                     {"what", words_of(fault, plan.time_out)},
                     {"of the first 1000", std::uint64_t{met}},
                     {"frames", frames}});
    }
    results.finish();
    return exit_status::done;
}

void check_words(choices const& typed)
{
    chaos_choices const& chosen = typed.chaos;
    if (typed.line.typed.options.starts_with(" -p ")) {
        refuse_word("--port " + typed.line.port + ": chaos has two ports, --from and --to");
    }
    if (typed.file == "-") {
        refuse_word("-o -: the figures go to standard output; say a file");
    }
    if (chosen.from.empty() or chosen.to.empty()) {
        refuse_word("chaos: between which ports? say " +
                    (chosen.from.empty() ? std::string{"--from with the port on which the client asks, or --from "} +
                                               new_client_port + " for a new one"
                                         : "--to with the port on which the server answers"));
    }
    if (chosen.from == chosen.to and chosen.from != "pty") {
        refuse_word("--from and --to are both " + chosen.from + ": the client and the server hang on a port each");
    }
    if (chosen.from.starts_with("sim:")) {
        refuse_word("--from " + chosen.from + ": simulated drives ask nobody; they stand behind --to");
    }
}

/// On a terminal a line that changes; the figures stand at the end, too.
class live_counts {
public:
    void show(disturbed_line const& line)
    {
        auto const now = steady_clock::now();
        if (is_terminal_ and now >= next_) {
            next_ = now + std::chrono::milliseconds{200};
            tell_at_once('\r' + text_of(line) + "\x1b[K");
        }
    }
    void clear() const
    {
        if (is_terminal_) {
            tell_at_once("\r\x1b[K");
        }
    }

private:
    static std::string text_of(disturbed_line const& line)
    {
        fault_counts const& requests = line.counts(frame_way::request);
        fault_counts const& answers = line.counts(frame_way::answer);
        std::string text =
            std::to_string(requests.frames) + " requests, " + std::to_string(answers.frames) + " answers";
        for (fault_counts const* const each : {&answers, &requests}) {
            for (auto const& [name, count] : each->met) {
                text += ", " + std::to_string(count) + ' ' + name;
            }
        }
        return text;
    }

    bool is_terminal_{is_terminal(STDERR_FILENO)};
    steady_clock::time_point next_{};
};

class chaos_command {
public:
    explicit chaos_command(choices const& chosen)
        : chosen_{chosen}, plan_{plan_in(chosen)}, from_{line_end::side::client, chosen.chaos.from, chosen.line},
          to_{line_end::side::server, chosen.chaos.to, chosen.line}
    {
        plan_.silence = std::max(from_.silence(), to_.silence());
        if (not chosen.file.empty()) {
            file_ = std::make_unique<capture_output>(chosen.file, new_capture_file("-o", chosen.file),
                                                     rtuwire::capture_options{.bits_per_second = chosen.line.baud},
                                                     from_.device() + " - " + to_.device(), calendar_);
        }
    }

    exit_status run()
    {
        std::fprintf(stderr,
                     "chaos: for benches. A command that is late, lost or asked again moves a motor, or leaves it "
                     "running: no drive hangs here whose motor may turn\nclient on %s, server on %s, seed %u\n",
                     from_.device().c_str(), to_.device().c_str(), plan_.seed);
        disturbed_line line{plan_,
                            {[this](frame_way way, rtuwire::byte_view bytes) { send(way, bytes); },
                             [this](rtuwire::traced_frame const& frame, std::string const& what) {
                                 if (file_) {
                                     file_->put(frame, what);
                                 }
                             }}};
        auto const began = steady_clock::now();
        auto const is_over = [&] {
            return chosen_.last and steady_clock::now() - began >= std::chrono::duration<double>{*chosen_.last};
        };
        while (noted_signal() == 0 and not is_over() and (not file_ or file_->is_open())) {
            pass(line);
            live_.show(line);
        }
        live_.clear();
        return tell(line);
    }

private:
    void send(frame_way way, rtuwire::byte_view bytes) { (way == frame_way::request ? to_ : from_).write(bytes); }

    void pass(disturbed_line& line)
    {
        std::array ends{watched_port(from_.descriptor_number(), POLLIN), watched_port(to_.descriptor_number(), POLLIN)};
        poll_ports(ends, wait_of(line));
        instant const now = rtuwire::steady_now();
        std::array<std::byte, 512> place;
        line.receive(frame_way::request, from_.read(place), now);
        line.receive(frame_way::answer, to_.read(place), now);
        if (file_) {
            file_->advance(now);
        }
    }

    /// Up to the next that is due.
    static std::chrono::milliseconds wait_of(disturbed_line const& line)
    {
        constexpr std::uint32_t longest = 100;
        instant const now = rtuwire::steady_now();
        auto const due = line.poll_deadline();
        if (not due) {
            return std::chrono::milliseconds{longest};
        }
        return std::chrono::milliseconds{reached(now, *due) ? 0
                                                            : std::min(longest, (*due - now).microseconds / 1'000 + 1)};
    }

    exit_status tell(disturbed_line const& line) const
    {
        output results{chosen_.form, false};
        for (frame_way const way : {frame_way::request, frame_way::answer}) {
            fault_counts const& counts = line.counts(way);
            std::string const of = way == frame_way::request ? "requests" : "answers";
            auto const put = [&](std::string const& fault, std::uint32_t count) {
                results.put({{"of", of}, {"fault", fault}, {"frames", std::uint64_t{count}}});
            };
            put("all", counts.frames);
            put("none", counts.untouched);
            for (auto const& [name, count] : counts.met) {
                put(name, count);
            }
            if (counts.kept_back > 0) {
                put("kept back", counts.kept_back);
            }
        }
        results.finish();
        return line.counts(frame_way::request).frames > 0 ? exit_status::done : exit_status::no_answer;
    }

    choices const& chosen_;
    line_calendar calendar_{unix_now()};
    fault_plan plan_;
    line_end from_;
    line_end to_;
    std::unique_ptr<capture_output> file_{};
    live_counts live_{};
};

} // namespace

exit_status run_chaos(choices const& chosen)
{
    if (chosen.chaos.is_dry) {
        return tell_plan(chosen);
    }
    check_words(chosen);
    note_signals();
    return chaos_command{chosen}.run();
}

} // namespace tool
