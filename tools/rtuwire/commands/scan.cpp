// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Finds the units of a line: one request to each address, at each bit rate and format asked for.
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

/// The bit rates and formats to try, in this order.
std::vector<line_setting> settings_of(choices const& chosen)
{
    auto bauds = chosen.scan.bauds;
    auto formats = chosen.scan.formats;
    if (bauds.empty()) {
        bauds.push_back(chosen.line.baud);
    }
    if (formats.empty()) {
        formats.push_back(chosen.line.format);
    }
    std::vector<line_setting> settings;
    for (unsigned const baud : bauds) {
        for (std::string const& format : formats) {
            settings.push_back({baud_in(baud), format_in(format)});
        }
    }
    return settings;
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
        std::string const sentence = count_ > 0 or noted_signal() != 0 ? left_.sentence() : nobody_text();
        if (not sentence.empty()) {
            std::fprintf(stderr, "note: %s\n", plain_text(sentence).c_str());
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
            bar_.show(done_, ", asking unit " + std::to_string(unit) + ", " + std::to_string(count_) + " found");
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
            settings += (settings.empty() ? "" : ", ") + std::to_string(each.baud) + ' ' +
                        std::string{name_of_format(each.format)};
        }
        std::string const addresses = units_.size() == 1 ? "1 address" : std::to_string(units_.size()) + " addresses";
        std::string text =
            "nobody answered: " + addresses + " asked at " + settings + ", " +
            text_of_cell(cell{chosen_.line.response_timeout.value_or(scan_timeout)}) +
            " s each. Next: is the unit powered, are its two wires at the adapter's A and B (swap them once), "
            "and which address, bit rate and format does its keypad show?";
        if (settings_.size() == 1) {
            text += " `" + other_settings() + "` tries the usual ones";
        }
        return text;
    }

    std::string other_settings() const
    {
        line_choices line = chosen_.line;
        line.typed.rate.clear();
        return shown_command(line,
                             "scan --units " + chosen_.scan.units + " --bauds 9600,19200,38400 --formats 8E1,8N1");
    }

    void note(line_setting const& how, rtuwire::unit_id unit, identity_words const& who)
    {
        record const line = record_of(how, unit, who);
        log_.note_found(how, unit.byte(), line);
        show(line);
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
