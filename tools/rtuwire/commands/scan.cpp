// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Finds the units of a line: one request to each address, at each bit rate and format asked for, or at the usual ones until
// somebody answers.
#include <algorithm>
#include <array>
#include <cstdio>
#include <map>
#include <memory>
#include <optional>
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
#include "line/traffic.hpp"
#include "line/usual_settings.hpp"
#include "line/who_is_it.hpp"
#include "output/plain_text.hpp"
#include "output/progress.hpp"

namespace tool {

namespace {

using rtuwire::errc;

/// Each bit rate in each format, in this order.
std::vector<line_setting> settings_of(choices const& chosen)
{
    auto const& bauds = chosen.scan.bauds;
    auto const& formats = chosen.scan.formats;
    std::vector<line_setting> settings;
    for (unsigned const baud : bauds.empty() ? std::vector{chosen.line.baud} : bauds) {
        for (std::string const& format : formats.empty() ? std::vector{chosen.line.format} : formats) {
            settings.push_back({baud_in(baud), format_in(format)});
        }
    }
    return settings;
}

/// Whether the bit rate and the format are to be found: where that is said, and where nobody said which they are.
bool finds_setting(choices const& chosen)
{
    if (chosen.finds_setting) {
        refuse_without_rate(chosen.line, "--find");
    }
    bool const is_said = chosen.line.is_rate_named or not chosen.scan.bauds.empty() or not chosen.scan.formats.empty();
    return chosen.finds_setting or (not is_said and has_rate(chosen.line));
}

class scan {
public:
    explicit scan(choices const& chosen)
        : chosen_{chosen}, finds_{finds_setting(chosen)}, is_tcp_{is_modbus_tcp(chosen.line)},
          settings_{finds_ ? usual_settings() : settings_of(chosen)}, units_{units_in(chosen.scan.units)},
          log_{chosen.scan.resume_file}, results_{chosen.form, true}
    {
        for (record const& each : log_.found()) {
            show(each);
            found_at_ = setting_of(each);
        }
    }

    exit_status run()
    {
        if (finds_) {
            find();
        } else {
            bar_.emplace(settings_.size() * units_.size());
            for (line_setting const& each : settings_) {
                if (not walk(each, units_)) {
                    break;
                }
            }
        }
        bar_.reset();
        results_.finish();
        tell_end();
        if (noted_signal() != 0) {
            std::fprintf(stderr, "ended after %zu addresses%s\n", done_,
                         chosen_.scan.resume_file.empty() ? "" : "; the same command goes on from there");
            return static_cast<exit_status>(128 + noted_signal());
        }
        return has_echo_ ? exit_status::differs : count_ > 0 ? exit_status::done : exit_status::no_answer;
    }

private:
    /// What is next stands behind what was found, and last what was left.
    void tell_end() const
    {
        bool const is_nobody = count_ == 0 and noted_signal() == 0;
        for (std::string const& each : {is_nobody ? nobody_text() : setting_text(), is_nobody ? "" : next_text(),
                                        is_nobody ? std::string{} : left_.sentence(), tcp_text_}) {
            if (not each.empty()) {
                std::fprintf(stderr, "note: %s\n", plain_text(each).c_str());
            }
        }
    }

    /// Setting after setting, until somebody answers: all units of a line have one. The lowest addresses, which units are
    /// delivered with, go first.
    void find()
    {
        auto const lowest_end = std::upper_bound(units_.begin(), units_.end(), highest_usual);
        std::vector<std::uint8_t> const lowest{units_.begin(), lowest_end};
        std::vector<std::uint8_t> const others{lowest_end, units_.end()};
        if (not found_at_) {
            tell_before(lowest, others);
            bar_.emplace(settings_.size() * units_.size());
        }
        for (auto const* const part : {&lowest, &others}) {
            for (line_setting const& each : settings_) {
                if (not found_at_ and not part->empty() and not walk(each, *part)) {
                    return;
                }
            }
        }
        if (found_at_) {
            std::vector<std::uint8_t> left;
            for (std::uint8_t const unit : units_) {
                if (not log_.is_done(*found_at_, unit)) {
                    left.push_back(unit);
                }
            }
            bar_.emplace(left.size());
            done_ = 0;
            static_cast<void>(walk(*found_at_, left));
        } else if (refused_.size() >= settings_.size()) {
            throw ended{exit_status::port, refused_.begin()->second};
        }
    }

    /// How long it may take, before it begins.
    void tell_before(std::vector<std::uint8_t> const& lowest, std::vector<std::uint8_t> const& others) const
    {
        auto const listening = std::chrono::ceil<std::chrono::seconds>(
            std::chrono::duration<double>{chosen_.line.must_not_listen ? 0.0 : chosen_.line.listen});
        auto const all = listening + time_of(lowest) + time_of(others);
        std::string const first = lowest.empty() or others.empty()
                                      ? std::string{}
                                      : " (" + time_in_words(time_of(lowest)) + " for addresses up to " +
                                            std::to_string(highest_usual) + ", which go first)";
        std::fprintf(stderr,
                     "note: bit rate and format are to be found: %s at up to %zu settings, the usual ones first, until "
                     "somebody answers: at most %s%s. It only reads; Ctrl-C ends it\n",
                     addresses_text().c_str(), settings_.size(), time_in_words(all).c_str(), first.c_str());
    }

    /// That nobody answers to.
    std::chrono::seconds time_of(std::vector<std::uint8_t> const& units) const
    {
        constexpr std::size_t request = 8, response = 7;
        constexpr double system = 0.002;
        double seconds = 0;
        for (line_setting const& each : settings_) {
            rtuwire::line_timing const wire{each.baud, each.format};
            double const one = timeout() + system + 1e-6 * wire.characters(request + response).microseconds +
                               1e-6 * wire.t3_5().microseconds;
            auto const left = std::count_if(units.begin(), units.end(),
                                            [&](std::uint8_t unit) { return not log_.is_done(each, unit); });
            seconds += left > 0 ? one * static_cast<double>(left) + settle_time : 0.0;
        }
        return std::chrono::seconds{static_cast<long>(seconds) + 1};
    }

    /// Addresses at one setting; false where somebody ended it.
    bool walk(line_setting const& how, std::vector<std::uint8_t> const& units)
    {
        fruitless_ = 0;
        for (std::uint8_t const unit : units) {
            if (noted_signal() != 0 or not results_.is_open()) {
                line_.reset();
                return false;
            }
            bar_->show(done_, ", asking unit " + std::to_string(unit) + at_text(how) + ", " + std::to_string(count_) +
                                  " found" + last_found_);
            if (not log_.is_done(how, unit) and not refused_.contains(words_of(how))) {
                if (open_line* const line = line_with(how, timeout())) {
                    look_at(*line, how, *rtuwire::unit_id::checked(unit));
                }
                if (has_echo_) {
                    return false;
                }
            }
            ++done_;
            if (finds_ and found_at_ and not is_same_setting(how, *found_at_)) { // while it looked closer
                break;
            }
        }
        if (finds_) {
            settle(how);
        }
        if (is_tcp_ and line_) {
            tcp_text_ = tcp_text(line_->port().words_of_silence(), units.size());
        }
        line_.reset();
        return true;
    }

    /// What there is to say of a server of Modbus TCP.
    std::string tcp_text(std::string const& of_port, std::size_t asked) const
    {
        constexpr std::size_t least = 8; // so many units in a row are none of a line
        if (count_ == asked and asked >= least) {
            return "something answers at every address: a device itself, as a rule, which does not look at the unit";
        }
        constexpr std::size_t mark = 2;
        return of_port.empty() ? of_port : of_port.substr(mark);
    }

    double timeout() const
    {
        return chosen_.line.response_timeout.value_or(finds_ ? find_timeout : is_tcp_ ? gateway_timeout : scan_timeout);
    }
    double patience() const { return std::max(timeout(), finds_ ? patient_timeout : timeout()); }

    /// It listens before the first frame only. What comes late is no response to another's request: each has an address
    /// of its own, so nobody waits for it.
    line_choices choices_with(double seconds)
    {
        line_choices line = chosen_.line;
        line.response_timeout = seconds;
        line.late_response = 0;
        line.retries = 0;
        line.must_not_listen = line.must_not_listen or has_listened_;
        has_listened_ = true;
        return line;
    }

    /// The line at a setting; null where a setting that nobody said is one that its driver does not have.
    open_line* line_with(line_setting const& how, double seconds)
    {
        if (line_ and is_same_setting(line_at_, how) and line_timeout_ == seconds) {
            return line_.get();
        }
        line_.reset();
        try {
            line_ = std::make_unique<open_line>(choices_with(seconds), how);
        } catch (setting_refused const& why) {
            if (not finds_) {
                throw;
            }
            refused_.emplace(words_of(how), why.what());
            return nullptr;
        }
        line_at_ = how;
        line_timeout_ = seconds;
        return line_.get();
    }

    /// What came of one request, and whether anything was heard meanwhile.
    struct asked_once {
        errc outcome;
        bool is_heard;

        bool is_there() const { return outcome == errc::none or rtuwire::is_exception(outcome); }
        bool is_silent() const { return outcome == errc::timed_out and not is_heard; }
    };

    asked_once ask(open_line& line, rtuwire::unit_id unit) const
    {
        if (line.port().is_absent(unit.byte())) {
            return {errc::timed_out, false};
        }
        constexpr std::size_t request = 8;
        std::size_t const before = line.port().heard() + (chosen_.line.has_echo ? request : 0);
        errc const outcome =
            line.ask(unit, rtuwire::read_holding_registers{.start = asked_register, .count = 1}).error();
        if (status_of(outcome) == exit_status::port) {
            throw ended{exit_status::port, line.port().failure()};
        }
        bool const is_absent = rtuwire::is_exception(outcome) and not is_refusal_of_unit(outcome);
        return is_absent ? asked_once{errc::timed_out, false} : asked_once{outcome, line.port().heard() > before};
    }

    void look_at(open_line& line, line_setting const& how, rtuwire::unit_id unit)
    {
        asked_once const asked = ask(line, unit);
        has_echo_ = asked.outcome == errc::line_echo;
        if (has_echo_) { // of the line, and of no unit: every address would show it
            show(record_of(how, unit, {.note = line.words_of_failure(asked.outcome)}));
        } else if (asked.is_there()) {
            if (open_line* const patient = line_with(how, patience())) {
                note_there(*patient, how, unit);
            }
        } else if (finds_) {
            wait_late(unit.byte());
            if (not asked.is_silent()) {
                look_closer(how);
            }
        } else if (asked.outcome != errc::timed_out) {
            note(how, unit, {.note = with_shared(line, unit, line.words_of_failure(asked.outcome))});
        } else {
            log_.note_silent(how, unit.byte());
        }
    }

    void note_there(open_line& line, line_setting const& how, rtuwire::unit_id unit)
    {
        identity_words who = who_is_it(line, unit);
        who.note = with_shared(line, unit, who.note);
        note(how, unit, who);
        if (who.outcome == exit_status::port) {
            throw ended{exit_status::port, line.port().failure()};
        }
        leave(line, how, unit, who.drive);
    }

    /// Nobody waits for a slow unit: its response comes while others are asked. It is silent once none can come any more.
    void wait_late(std::uint8_t unit)
    {
        lately_.push_back(unit);
        while (static_cast<double>(lately_.size()) * timeout() > patient_timeout + timeout()) {
            log_.note_silent(line_at_, lately_.front());
            lately_.erase(lately_.begin());
        }
    }

    /// Whether anything comes within a time without a request.
    static bool is_heard_within(any_port& port, double seconds)
    {
        std::size_t const before = port.heard();
        std::array<std::byte, rtuwire::max_adu_size> place{};
        rtuwire::instant const end = port.now() + seconds_in(seconds);
        while (not rtuwire::reached(port.now(), end) and port.read(place, end)) {
            static_cast<void>(port.take_receive_error());
        }
        return port.heard() != before;
    }

    /// Listens behind the last request of a setting.
    void settle(line_setting const& how)
    {
        bool const may_be_late = line_ and is_same_setting(line_at_, how) and not lately_.empty();
        if (may_be_late and noted_signal() == 0 and is_heard_within(line_->port(), settle_time)) {
            look_closer(how);
        }
        for (std::uint8_t const each : lately_) {
            if (noted_signal() == 0) { // else nobody has waited
                log_.note_silent(how, each);
            }
        }
        lately_.clear();
    }

    /// Something came that is no answer to what was asked: it was late, or of another format, or of two units at once. Those
    /// asked lately are asked again with patience, and one that answers with damage in other settings, too. What comes
    /// without a request, too, is nobody's answer.
    void look_closer(line_setting const& how)
    {
        noise_at_ = how;
        constexpr unsigned most_fruitless = 3; // on a line that is never silent
        if (fruitless_ >= most_fruitless) {
            return;
        }
        ++fruitless_;
        for (std::size_t i = lately_.size(); i-- > 0 and noted_signal() == 0;) {
            rtuwire::unit_id const unit = *rtuwire::unit_id::checked(lately_[i]);
            open_line* const line = line_with(how, patience());
            asked_once const asked = line != nullptr ? ask(*line, unit) : asked_once{errc::timed_out, false};
            if (asked.is_silent()) {
                continue;
            }
            if (asked.is_there()) {
                forget_late(unit);
                note_there(*line, how, unit);
            } else if (std::string const why = line->words_of_failure(asked.outcome);
                       not is_noise(line->port()) and not look_elsewhere(how, unit)) {
                forget_late(unit);
                note_damage(how, unit,
                            why + (asked.outcome == errc::timed_out ? ", and bytes that are no frame" : "") +
                                "; nothing better came at another usual bit rate and format");
            }
            return;
        }
    }

    void note_damage(line_setting const& how, rtuwire::unit_id unit, std::string const& why)
    {
        if (open_line* const line = line_with(how, patience())) {
            note(how, unit, {.note = with_shared(*line, unit, why)});
        }
    }

    /// Whether something comes that nobody asked for. A line on which others talk is left.
    bool is_noise(any_port& port) const
    {
        bool const is_heard = is_heard_within(port, patience());
        if (is_heard and not chosen_.line.must_not_listen) {
            refuse_traffic(port, seconds_in(std::max(chosen_.line.listen, patience())));
        }
        return is_heard;
    }

    void forget_late(rtuwire::unit_id unit)
    {
        lately_.erase(std::remove(lately_.begin(), lately_.end(), unit.byte()), lately_.end());
    }

    /// One that was heard, in each other format of the same bit rate, then at the others. Whether it answers there.
    bool look_elsewhere(line_setting const& how, rtuwire::unit_id unit)
    {
        for (bool const is_same_rate : {true, false}) {
            for (line_setting const& each : settings_) {
                bool const is_next = (each.baud == how.baud) == is_same_rate and not is_same_setting(each, how);
                open_line* const line = is_next and noted_signal() == 0 ? line_with(each, patience()) : nullptr;
                if (line != nullptr and ask(*line, unit).is_there()) {
                    note_there(*line, each, unit);
                    return true;
                }
            }
        }
        return false;
    }

    /// A note, with what is wrong where several units have an address.
    static std::string with_shared(open_line& line, rtuwire::unit_id unit, std::string const& note)
    {
        std::string const shared = why_shared(line, unit);
        return note + (note.empty() or shared.empty() ? "" : "; ") + shared;
    }

    std::string addresses_text() const
    {
        return units_.size() == 1 ? "1 address" : std::to_string(units_.size()) + " addresses";
    }

    /// What to look at where nobody answered.
    std::string nobody_text() const
    {
        if (is_tcp_) {
            return "nobody answered: " + addresses_text() + " asked, " + text_of_cell(cell{timeout()}) +
                   " s each. Next: is the unit behind this gateway powered, and which address does it have?";
        }
        std::string settings;
        for (line_setting const& each : settings_) {
            settings += refused_.contains(words_of(each)) ? "" : (settings.empty() ? "" : ", ") + words_of(each);
        }
        return "nobody answered: " + addresses_text() + " asked at " + settings + ", " + text_of_cell(cell{timeout()}) +
               " s each. Next: is the unit powered, are its two wires at the adapter's A and B (swap them once), "
               "and which address, bit rate and format does its keypad show?" +
               further_text();
    }

    /// The command that goes on where this one has ended.
    std::string further_text() const
    {
        line_choices line = chosen_.line;
        line.typed.rate.clear();
        if (finds_) {
            return (noise_at_
                        ? " At " + words_of(*noise_at_) +
                              " something was heard that is no answer: an open or a damaged line, or another client."
                        : "") +
                   std::string{" If a client talks on this line, sniff --find finds its setting"};
        }
        return has_rate(line) ? " `" + shown_command(line, "scan --find --units " + chosen_.scan.units) +
                                    "` tries the usual bit rates and formats"
                              : "";
    }

    /// Behind the address; Modbus TCP has no setting.
    std::string at_text(line_setting const& how) const { return is_tcp_ ? std::string{} : " at " + words_of(how); }

    static line_setting setting_of(record const& found)
    {
        unsigned baud = 0;
        std::string format;
        for (field const& each : found.fields()) {
            if (each.name == "baud") {
                baud = static_cast<unsigned>(std::stoul(text_of_cell(each.value)));
            } else if (each.name == "format") {
                format = text_of_cell(each.value);
            }
        }
        return {baud_in(baud), format_in(format)};
    }

    /// How the line is set, where that was found out.
    std::string setting_text() const
    {
        bool const is_usual = found_at_ and is_same_setting(*found_at_, setting_in(line_choices{}));
        if (not finds_ or not found_at_ or is_usual) {
            return {};
        }
        std::string const more = note_of_format(*found_at_);
        return "the line is set to " + words_of(*found_at_) + (more.empty() ? "" : " (" + more + ")") + ": say" +
               typed_rate(*found_at_) + " with each command, or baud = " + std::to_string(found_at_->baud) +
               " and format = \"" + name_of_format(found_at_->format) + "\" in rtuwire.toml";
    }

    /// What is next where somebody is there: first with one that is no drive of this program.
    std::string next_text() const
    {
        return not unknown_.empty() ? "which registers has it? `" + unknown_ + "` asks, and only reads"
               : not drive_.empty() ? "next: `" + drive_ + "` reads its output frequency"
                                    : std::string{};
    }

    void note(line_setting const& how, rtuwire::unit_id unit, identity_words const& who)
    {
        record const line = record_of(how, unit, who);
        log_.note_found(how, unit.byte(), line);
        found_at_ = how;
        show(line);
        last_found_ = ": unit " + std::to_string(unit.byte()) + at_text(how);
        if (who.drive.empty() and unknown_.empty()) {
            unknown_ = shown_command(line_at(how), unit, "map");
        }
        if (drive_.empty() and not who.drive.empty()) {
            drive_ = shown_command(line_at(how), unit, "read RFR");
        }
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
        if (finds_ or settings_.size() > 1 or not chosen_.scan.bauds.empty() or not chosen_.scan.formats.empty()) {
            line.typed.rate = typed_rate(how);
        }
        return line;
    }

    void show(record const& line)
    {
        ++count_;
        if (bar_) {
            bar_->clear();
        }
        record shown;
        for (field const& each : line.fields()) {
            bool const has_no_setting = is_tcp_ and (each.name == "baud" or each.name == "format");
            shown.add(each.name, has_no_setting ? cell{} : each.value);
        }
        results_.put(shown);
    }

    /// Every drive has it; for any other device an exception is an answer as well.
    static constexpr std::uint16_t asked_register = 3201;
    static constexpr double scan_timeout = 0.2;
    /// A gateway waits for each unit that is not there, and asks the next one behind that.
    static constexpr double gateway_timeout = 1.0;
    /// Where there are many settings; most units answer sooner, and who is slower is heard while the next ones are asked.
    static constexpr double find_timeout = 0.05, patient_timeout = 0.5, settle_time = 0.2;
    static constexpr std::uint8_t highest_usual = 10;

    choices const& chosen_;
    bool finds_;
    bool is_tcp_; ///< Modbus TCP
    std::vector<line_setting> settings_;
    std::vector<std::uint8_t> units_;
    scan_log log_;
    output results_;
    std::optional<progress> bar_{};
    left_alone left_{};
    std::unique_ptr<open_line> line_{};
    line_setting line_at_{};
    double line_timeout_{0};
    std::map<std::string, std::string> refused_{}; ///< settings that the driver does not have, and what it says
    std::vector<std::uint8_t> lately_{};           ///< asked at this setting, and not heard yet
    unsigned fruitless_{0};                        ///< how often nobody was found behind what was heard at this setting
    std::optional<line_setting> noise_at_{};       ///< where something was last heard that was no answer
    std::optional<line_setting> found_at_{};
    std::size_t done_{0};
    std::size_t count_{0};
    std::string tcp_text_{};
    std::string last_found_{};
    std::string unknown_{}; ///< the command that asks the first one that is no drive for its registers
    std::string drive_{};   ///< that reads the first one that is
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
