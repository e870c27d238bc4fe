// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Finds the units of a line: one request to each address, at each bit rate and format asked for.
#include <algorithm>
#include <cstdio>
#include <string>
#include <vector>

#include "catalog/catalog.hpp"
#include "commands/commands.hpp"
#include "line/end_wish.hpp"
#include "line/left_alone.hpp"
#include "line/line_words.hpp"
#include "line/open_line.hpp"
#include "line/scan_log.hpp"
#include "line/shared_address.hpp"
#include "line/who_is_it.hpp"
#include "output/plain_text.hpp"
#include "output/progress.hpp"

namespace tool {

namespace {

using rtuwire::errc;

/// Each bit rate in each format, in this order.
std::vector<line_setting> settings_in(std::vector<unsigned> const& bauds, std::vector<std::string> const& formats)
{
    std::vector<line_setting> settings;
    for (unsigned const baud : bauds) {
        for (std::string const& format : formats) {
            settings.push_back({baud_in(baud), format_in(format)});
        }
    }
    return settings;
}

std::vector<line_setting> settings_of(choices const& chosen)
{
    auto const& bauds = chosen.scan.bauds;
    auto const& formats = chosen.scan.formats;
    return settings_in(bauds.empty() ? std::vector{chosen.line.baud} : bauds,
                       formats.empty() ? std::vector{chosen.line.format} : formats);
}

/// What is tried where nobody answers: each set of settings behind the ones before it.
struct setting_set {
    std::vector<unsigned> bauds;
    std::vector<std::string> formats;
};

std::vector<setting_set> const& usual_settings()
{
    static std::vector<setting_set> const all{{{9600, 19200, 38400}, {"8E1", "8N1"}},
                                              {{9600, 19200, 38400}, {"8N2", "8O1"}},
                                              {{4800, 57600, 115200}, {"8E1", "8N1", "8N2"}},
                                              {{1200, 2400}, {"8E1", "8N1", "8N2"}},
                                              {{9600, 19200, 38400}, {"8E2", "8O2"}}};
    return all;
}

template <typename List, typename Text> std::string joined(List const& list, Text text)
{
    std::string all;
    for (auto const& each : list) {
        all += (all.empty() ? "" : ",") + text(each);
    }
    return all;
}

class scan {
public:
    explicit scan(choices const& chosen)
        : chosen_{chosen}, settings_{settings_of(chosen)}, units_{units_in(chosen.scan.units)},
          log_{chosen.scan.resume_file}, results_{chosen.form, true}, bar_{settings_.size() * units_.size()}
    {
        for (record const& each : log_.found()) {
            show(each);
        }
    }

    exit_status run()
    {
        for (line_setting const& each : settings_) {
            if (not walk(each)) {
                break;
            }
        }
        bar_.clear();
        results_.finish();
        bool const is_nobody = count_ == 0 and noted_signal() == 0;
        for (std::string const& each :
             {is_nobody ? nobody_text() : next_text(), is_nobody ? std::string{} : left_.sentence()}) {
            if (not each.empty()) {
                std::fprintf(stderr, "note: %s\n", plain_text(each).c_str());
            }
        }
        if (noted_signal() != 0) {
            std::fprintf(stderr, "ended after %zu addresses%s\n", done_,
                         chosen_.scan.resume_file.empty() ? "" : "; the same command goes on from there");
            return static_cast<exit_status>(128 + noted_signal());
        }
        return has_echo_ ? exit_status::differs : count_ > 0 ? exit_status::done : exit_status::no_answer;
    }

private:
    /// All addresses at one setting; false where somebody ended it.
    bool walk(line_setting const& how)
    {
        std::unique_ptr<open_line> line;
        for (std::uint8_t const unit : units_) {
            if (noted_signal() != 0 or not results_.is_open()) {
                return false;
            }
            bar_.show(done_, ", asking unit " + std::to_string(unit) + " at " + words_of(how) + ", " +
                                 std::to_string(count_) + " found" + last_found_);
            if (not log_.is_done(how, unit)) {
                if (not line) {
                    line = std::make_unique<open_line>(choices_here(), how);
                }
                look_at(*line, how, *rtuwire::unit_id::checked(unit));
                if (has_echo_) {
                    return false;
                }
            }
            ++done_;
        }
        return true;
    }

    /// It listens before the first frame only. What comes late is no response to another's request: each has an address
    /// of its own, so nobody waits for it.
    line_choices choices_here()
    {
        line_choices line = chosen_.line;
        line.response_timeout = line.response_timeout.value_or(scan_timeout);
        line.late_response = 0;
        line.retries = 0;
        line.must_not_listen = line.must_not_listen or has_listened_;
        has_listened_ = true;
        return line;
    }

    void look_at(open_line& line, line_setting const& how, rtuwire::unit_id unit)
    {
        auto const heard = line.ask(unit, rtuwire::read_holding_registers{.start = asked_register, .count = 1});
        errc const outcome = heard.error();
        bool const is_there = outcome == errc::none or rtuwire::is_exception(outcome);
        bool const is_silent = outcome == errc::timed_out;
        if (status_of(outcome) == exit_status::port) {
            throw ended{exit_status::port, line.port().failure()};
        }
        has_echo_ = outcome == errc::line_echo;
        if (has_echo_) { // of the line, and of no unit: every address would show it
            show(record_of(how, unit, {.note = line.words_of_failure(outcome)}));
        } else if (is_there) {
            identity_words who = who_is_it(line, unit);
            who.note = with_shared(line, unit, who.note);
            note(how, unit, who);
            leave(line, how, unit, who.drive);
        } else if (not is_silent) {
            note(how, unit, {.note = with_shared(line, unit, line.words_of_failure(outcome))});
        } else {
            log_.note_silent(how, unit.byte());
        }
    }

    /// A note, with what is wrong where several units have an address.
    static std::string with_shared(open_line& line, rtuwire::unit_id unit, std::string const& note)
    {
        std::string const shared = why_shared(line, unit);
        return note + (note.empty() or shared.empty() ? "" : "; ") + shared;
    }

    /// What to look at where nobody answered.
    std::string nobody_text() const
    {
        std::string settings;
        for (line_setting const& each : settings_) {
            settings += (settings.empty() ? "" : ", ") + words_of(each);
        }
        std::string const addresses = units_.size() == 1 ? "1 address" : std::to_string(units_.size()) + " addresses";
        std::string text =
            "nobody answered: " + addresses + " asked at " + settings + ", " +
            text_of_cell(cell{chosen_.line.response_timeout.value_or(scan_timeout)}) +
            " s each. Next: is the unit powered, are its two wires at the adapter's A and B (swap them once), "
            "and which address, bit rate and format does its keypad show?";
        std::string const more = other_settings();
        return more.empty() ? text : text + " `" + more + "` tries the next ones";
    }

    bool is_asked(setting_set const& set) const
    {
        return std::ranges::all_of(settings_in(set.bauds, set.formats), [this](line_setting const& each) {
            return std::ranges::any_of(settings_, [&each](line_setting const& asked) {
                return asked.baud == each.baud and asked.format == each.format;
            });
        });
    }

    /// The command that asks behind the last set of settings that this one has asked at; empty behind all.
    std::string other_settings() const
    {
        auto const& sets = usual_settings();
        auto const last = std::find_if(sets.rbegin(), sets.rend(), [this](auto const& each) { return is_asked(each); });
        auto const next = last.base();
        if (next == sets.end()) {
            return {};
        }
        line_choices line = chosen_.line;
        line.typed.rate.clear();
        std::string const bauds = joined(next->bauds, [](unsigned each) { return std::to_string(each); });
        std::string const formats = joined(next->formats, [](std::string const& each) { return each; });
        return shown_command(line,
                             "scan --units " + chosen_.scan.units + " --bauds " + bauds + " --formats " + formats);
    }

    /// What is next where somebody is there that is no drive of this program.
    std::string next_text() const
    {
        return unknown_.empty() ? std::string{} : "which registers has it? `" + unknown_ + "` asks, and only reads";
    }

    void note(line_setting const& how, rtuwire::unit_id unit, identity_words const& who)
    {
        record const line = record_of(how, unit, who);
        log_.note_found(how, unit.byte(), line);
        show(line);
        last_found_ = ": unit " + std::to_string(unit.byte()) + " at " + words_of(how);
        if (who.drive.empty() and unknown_.empty()) {
            unknown_ = shown_command(line_at(how), unit, "map");
        }
    }

    static std::string words_of(line_setting const& how)
    {
        return std::to_string(how.baud) + ' ' + name_of_format(how.format);
    }

    static record record_of(line_setting const& how, rtuwire::unit_id unit, identity_words const& who)
    {
        return {{"unit", std::int64_t{unit.byte()}},
                {"baud", std::int64_t{how.baud}},
                {"format", name_of_format(how.format)},
                {"vendor", who.vendor},
                {"product", who.product},
                {"revision", who.revision},
                {"drive", who.drive},
                {"note", who.note}};
    }

    /// Simulated drives of this program end with it.
    void leave(open_line& line, line_setting const& how, rtuwire::unit_id unit, std::string const& drive)
    {
        drive_catalog const* const known = catalog_named(drive);
        if (known != nullptr and not line.port().is_simulated()) {
            left_.note(line, unit, *known, shown_command(line_at(how), unit, "--write reset"));
        }
    }

    /// For a command on the line as it is set here.
    line_choices line_at(line_setting const& how) const
    {
        line_choices line = chosen_.line;
        if (not chosen_.scan.bauds.empty() or not chosen_.scan.formats.empty()) {
            line.typed.rate = " -b " + std::to_string(how.baud) + " -f " + std::string{name_of_format(how.format)};
        }
        return line;
    }

    void show(record const& line)
    {
        ++count_;
        bar_.clear();
        results_.put(line);
    }

    /// Every drive has it; for any other device an exception is an answer as well.
    static constexpr std::uint16_t asked_register = 3201;
    static constexpr double scan_timeout = 0.2;

    choices const& chosen_;
    std::vector<line_setting> settings_;
    std::vector<std::uint8_t> units_;
    scan_log log_;
    output results_;
    progress bar_;
    left_alone left_{};
    std::size_t done_{0};
    std::size_t count_{0};
    std::string last_found_{};
    std::string unknown_{}; ///< the command that asks the first one that is no drive for its registers
    bool has_listened_{false};
    bool has_echo_{false};
};

} // namespace

exit_status run_scan(choices const& chosen)
{
    note_signals();
    return scan{chosen}.run();
}

} // namespace tool
