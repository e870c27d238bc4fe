// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Holds a server, or a client, against the clauses of the specification. It only reads, where nothing else is allowed.
#include <cstdio>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "../support/platform.hpp"
#include "check/checked_client.hpp"
#include "check/checked_unit.hpp"
#include "check/profile.hpp"
#include "check/told_verdicts.hpp"
#include "commands/commands.hpp"
#include "line/end_wish.hpp"
#include "line/left_alone.hpp"
#include "line/line_words.hpp"
#include "line/open_line.hpp"
#include "motion/fed_drive.hpp"
#include "output/plain_text.hpp"
#include "port/any_port.hpp"
#include "port/served_port.hpp"
#include "words/suggestion.hpp"
#include "words/time_words.hpp"

namespace tool {

namespace {

constexpr double usual_wait = 1.0;   ///< seconds: there are servers that take half of it before they refuse
constexpr double clients_wait = 0.5; ///< that a client is told to wait: it waits in many clauses, and repeats

line_time time_of(double seconds)
{
    return std::chrono::duration_cast<line_time>(std::chrono::duration<double>{seconds});
}

std::span<clause const> clauses_of(check_choices const& how)
{
    return how.is_client ? all_client_clauses() : all_clauses();
}

exit_status list_clauses(choices const& chosen)
{
    output results{chosen.form, false};
    for (clause const* each : wanted_clauses(clauses_of(chosen.check), chosen.check.only)) {
        judged_clause const row{each, {}};
        record const full = record_of(row, output_form::csv);
        results.put({{"clause", std::string{each->id}},
                     {"level", full.fields()[1].value},
                     {"source", std::string{each->source}},
                     {chosen.check.is_client ? "what is judged" : "asked where", std::string{each->applies}},
                     {"what fails without it", std::string{each->harm}}});
    }
    results.finish();
    return exit_status::done;
}

exit_status explain_clause(std::string const& id)
{
    std::vector<std::string_view> ids;
    for (std::span<clause const> const side : {all_clauses(), all_client_clauses()}) {
        for (clause const& each : side) {
            if (each.id == id) {
                std::fputs(explained(each).c_str(), stdout);
                return exit_status::done;
            }
            ids.push_back(each.id);
        }
    }
    refuse_word("--explain: '" + id + "' is no clause" + suggestion(id, ids));
}

class checking {
public:
    explicit checking(choices const& chosen)
        : chosen_{chosen}, clauses_{wanted_clauses(all_clauses(), chosen.check.only)},
          scratch_{scratch_in(chosen.check)}, unit_{unit_in(chosen.line)}
    {
        bool const changes =
            not chosen.check.scratch.empty() or not chosen.check.scratch_coils.empty() or chosen.check.may_disrupt;
        if (changes and not chosen.allowed.may_write) {
            refuse_for_safety("--scratch, --scratch-coils and --disruptive change the unit: say --write, too");
        }
        if (chosen.check.is_alone and chosen.check.scratch.empty() and chosen.check.scratch_coils.empty()) {
            refuse_word("--alone allows writes to other addresses, which go with --scratch only");
        }
        may_change_ = changes;
    }

    exit_status run()
    {
        open_line line{chosen_.line};
        fed_unit const who = unit_there(line);
        line_setting const setting = setting_in(chosen_.line);
        double const seconds = chosen_.line.response_timeout.value_or(usual_wait);
        std::optional<fed_pause> const pause = pause_of(line, unit_.unit, who);
        if (pause) {
            refuse_long_wait(time_of(seconds), *pause);
        }
        probed_line probed{line.port(), line.exchange(), rtuwire::line_timing{setting.baud, setting.format},
                           time_of(seconds), unit_.unit.byte()};
        checked_unit unit{probed, unit_.unit.byte(), chosen_.check};
        if (pause) {
            unit.keep_fed(pause->longest, pause->why + ": a shorter --timeout takes less");
        }
        unit.claim(profile_.functions());
        note_signals();
        try {
            if (not unit.discover(clauses_, scratch_)) {
                throw ended{exit_status::no_answer,
                            "unit " + std::to_string(unit_.unit.byte()) +
                                ": no response to functions 01 to 04; scan looks for who is there"};
            }
            ask_all(unit);
        } catch (...) {
            put_back(unit);
            throw;
        }
        put_back(unit);
        if (who.drive != nullptr) {
            leave(line, *who.drive);
        }
        tell_pace(unit);
        profile_.tell();
        exit_status const status = verdicts_.tell(chosen_.line.port + " unit " + std::to_string(unit_.unit.byte()));
        return status == exit_status::done and is_left_changed_ ? exit_status::differs : status;
    }

private:
    /// A drive is never sent what may change it, and is asked that much only where somebody says so.
    fed_unit unit_there(open_line& line) const
    {
        fed_unit const who = who_is_fed(line, unit_);
        if (who.may_be_drive and may_change_) {
            refuse_for_safety("unit " + std::to_string(unit_.unit.byte()) + " is a drive, or may be one" +
                              (who.drive == nullptr ? "" : " (" + std::string{who.drive->name} + ")") +
                              ": it is checked by reading only, without --scratch, --scratch-coils and --disruptive");
        }
        if (not line.port().is_simulated()) {
            ask_before_it_is_fed(who, unit_, chosen_.allowed, "a check", "check it?");
        }
        return who;
    }

    /// No question may be left without an answer for longer than a drive may be without one.
    void refuse_long_wait(line_time wait, fed_pause const& pause) const
    {
        constexpr line_time besides{100'000}, tenth{100'000}; // what a machine takes besides; a figure to say
        if (wait + besides <= pause.longest) {
            return;
        }
        auto const most = (pause.longest - besides) / tenth;
        refuse_for_safety(
            "--timeout: for " + seconds_text(wait) + " behind each request without an answer unit " +
            std::to_string(unit_.unit.byte()) + " hears none that it answers, and " + pause.why +
            (most > 0 ? "; say --timeout " + std::to_string(most / 10) + '.' + std::to_string(most % 10) + " or less"
                      : std::string{}));
    }

    void leave(open_line& line, drive_catalog const& drive)
    {
        left_alone left;
        left.note(line, unit_.unit, drive, shown_command(chosen_.line, unit_.unit, "--write reset"));
        if (std::string const sentence = left.sentence(); not sentence.empty()) {
            std::fprintf(stderr, "note: %s\n", plain_text(sentence).c_str());
        }
    }

    void ask_all(checked_unit& unit)
    {
        clause const* before = nullptr;
        clause const* culprit = nullptr; // behind which the unit did not come to a known state
        for (clause const* which : clauses_) {
            if (noted_signal() != 0) {
                break;
            }
            verdicts_.begin(*which);
            judged_clause row{which, judged_one(unit, *which, before, culprit)};
            if (noted_signal() != 0) {
                break; // a clause that was cut says nothing
            }
            verdicts_.add(std::move(row));
            before = which;
        }
        verdicts_.end();
    }

    judgement judged_one(checked_unit& unit, clause const& which, clause const* before, clause const*& culprit)
    {
        if (auto const why = unit.why_not_asked(which)) {
            return {why->is_of_unit ? verdict::does_not_apply : verdict::not_tried, why->why, {}};
        }
        if (not unit.establish(which.state)) {
            culprit = culprit == nullptr ? before : culprit;
            return {verdict::not_tried,
                    "no known state: the unit does not answer a plain read" +
                        (culprit == nullptr ? std::string{} : " since clause " + std::string{culprit->id}),
                    unit.line().take_passed()};
        }
        culprit = nullptr;
        return profile_.judged(judged(unit, which), which.id);
    }

    void put_back(checked_unit& unit)
    {
        if (std::string const left = unit.put_back(); not left.empty()) {
            std::fprintf(stderr, "rtuwire: not put back: %s\n", plain_text(left).c_str());
            is_left_changed_ = true;
        }
    }

    /// What is no fault by itself, and decides what a client has to wait for.
    static void tell_pace(checked_unit const& unit)
    {
        constexpr line_time slow{300'000},
            halting{45'000}; // most clients wait longer than the one, and not than the other
        auto const ms = [](line_time time) { return static_cast<long long>(time.count() / 1'000); };
        if (unit.longest_answer() >= slow) {
            std::fprintf(stderr, "note: the unit is slow: answers began up to %lld ms behind their request\n",
                         ms(unit.longest_answer()));
        }
        if (unit.longest_gap() >= halting) {
            std::fprintf(
                stderr,
                "note: answers halt: silences of up to %lld ms are inside of them, and end a frame for most clients\n",
                ms(unit.longest_gap()));
        }
    }

    choices const& chosen_;
    std::vector<clause const*> clauses_;
    scratch_places scratch_;
    check_profile profile_{chosen_.check.profile};
    named_unit unit_;
    bool may_change_{false};
    bool is_left_changed_{false};
    told_verdicts verdicts_{chosen_, clauses_};
};

exit_status check_client(choices const& chosen)
{
    check_choices const& how = chosen.check;
    if (not how.scratch.empty() or not how.scratch_coils.empty() or how.may_disrupt or how.is_alone or
        how.hostile > 0 or how.readable or not how.profile.empty()) {
        refuse_word("--client: --readable, --scratch, --scratch-coils, --alone, --disruptive, --hostile and --profile "
                    "are for servers");
    }
    std::vector<clause const*> const clauses = wanted_clauses(all_client_clauses(), how.only);
    std::uint8_t const unit = unit_in(chosen.line).unit.byte();
    line_setting const setting = setting_in(chosen.line);
    exchange_log::open_file(chosen.line);
    served_port port{chosen.line.port, serial_settings_in(chosen.line, setting)};
    if (port.is_device() and how.client_port.empty() and not chosen.words.empty()) {
        refuse_word(with_own_words("--port " + chosen.line.port +
                                   ": which port does the client open? say --client-port /dev/ttyUSB1"));
    }
    any_port const no_port; // whose frames are shown as they are
    exchange_log log = exchange_log::of(chosen.line, setting, no_port);
    checked_client client{
        port,
        log,
        rtuwire::line_timing{setting.baud, setting.format},
        unit,
        {chosen.words, how.client_port, time_of(chosen.line.response_timeout.value_or(clients_wait))}};
    if (chosen.words.empty()) {
        std::fprintf(stderr, "unit %u is served on %s, to a client that waits %.3g s for a response (--timeout)\n",
                     unsigned{unit}, plain_text(port.name()).c_str(),
                     chosen.line.response_timeout.value_or(clients_wait));
    }
    note_signals();
    told_verdicts verdicts{chosen, clauses};
    for (clause const* which : clauses) {
        verdicts.begin(*which);
        judged_clause row{which, client.judged(*which)};
        if (noted_signal() != 0) {
            break; // a clause that was cut says nothing
        }
        verdicts.add(std::move(row));
    }
    verdicts.end();
    return verdicts.tell(chosen.words.empty() ? "client on " + port.name() : chosen.words.front());
}

} // namespace

exit_status run_check(choices const& chosen)
{
    if (not chosen.check.is_client and (not chosen.words.empty() or not chosen.check.client_port.empty())) {
        refuse_word("check: a command and --client-port are for --client, which checks a client");
    }
    if (chosen.check.lists) {
        return list_clauses(chosen);
    }
    if (not chosen.check.explained.empty()) {
        return explain_clause(chosen.check.explained);
    }
    return chosen.check.is_client ? check_client(chosen) : checking{chosen}.run();
}

} // namespace tool
