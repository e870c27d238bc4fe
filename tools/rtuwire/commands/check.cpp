// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Holds a server against the clauses of the specification. It only reads, where nothing else is allowed.
#include <algorithm>
#include <cstdio>
#include <string>
#include <vector>

#include "check/profile.hpp"
#include "check/report.hpp"
#include "commands/commands.hpp"
#include "line/end_wish.hpp"
#include "line/left_alone.hpp"
#include "line/line_words.hpp"
#include "line/open_line.hpp"
#include "motion/fed_drive.hpp"
#include "output/plain_text.hpp"
#include "output/progress.hpp"
#include "words/suggestion.hpp"

namespace tool {

namespace {

constexpr double usual_wait = 1.0; ///< seconds: there are servers that take half of it before they refuse

bool is_wanted(clause const& which, std::string const& only)
{
    if (only.empty()) {
        return true;
    }
    for (std::size_t from = 0; from <= only.size();) {
        std::size_t const end = std::min(only.find(',', from), only.size());
        std::string_view const word = std::string_view{only}.substr(from, end - from);
        // A clause, a function's or a group's letter: F03.1, F03, F.
        bool const is_part = which.id.starts_with(word) and
                             (which.id.size() == word.size() or which.id[word.size()] == '.' or word.size() == 1);
        if (not word.empty() and is_part) {
            return true;
        }
        from = end + 1;
    }
    return false;
}

std::vector<clause const*> wanted(std::string const& only)
{
    std::vector<clause const*> all;
    for (clause const& each : all_clauses()) {
        if (is_wanted(each, only)) {
            all.push_back(&each);
        }
    }
    if (all.empty()) {
        refuse_word("--only " + only + ": no clause is called so; --list names all");
    }
    // Clang 14 cannot use the one of std::ranges.
    std::stable_partition(all.begin(), all.end(), [](clause const* each) { return each->state != clause_state::last; });
    return all;
}

exit_status list_clauses(choices const& chosen)
{
    output results{chosen.form, false};
    for (clause const* each : wanted(chosen.check.only)) {
        judged_clause const row{each, {}};
        record const full = record_of(row, output_form::csv);
        results.put({{"clause", std::string{each->id}},
                     {"level", full.fields()[1].value},
                     {"source", std::string{each->source}},
                     {"asked where", std::string{each->applies}},
                     {"what fails without it", std::string{each->harm}}});
    }
    results.finish();
    return exit_status::done;
}

exit_status explain_clause(std::string const& id)
{
    for (clause const& each : all_clauses()) {
        if (each.id == id) {
            std::fputs(explained(each).c_str(), stdout);
            return exit_status::done;
        }
    }
    std::vector<std::string_view> ids;
    for (clause const& each : all_clauses()) {
        ids.push_back(each.id);
    }
    refuse_word("--explain: '" + id + "' is no clause" + suggestion(id, ids));
}

class checking {
public:
    explicit checking(choices const& chosen)
        : chosen_{chosen}, clauses_{wanted(chosen.check.only)}, scratch_{scratch_in(chosen.check)}, unit_{unit_in(
                                                                                                        chosen.line)}
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
        drive_catalog const* const drive = drive_there(line);
        line_setting const setting = setting_in(chosen_.line);
        double const seconds = chosen_.line.response_timeout.value_or(usual_wait);
        probed_line probed{line.port(), line.exchange(), rtuwire::line_timing{setting.baud, setting.format},
                           std::chrono::duration_cast<line_time>(std::chrono::duration<double>{seconds})};
        checked_unit unit{probed, unit_.unit.byte(), chosen_.check};
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
        if (drive != nullptr) {
            leave(line, *drive);
        }
        tell_pace(unit);
        profile_.tell();
        return tell();
    }

private:
    /// A drive is never sent what may change it, and is asked that much only where somebody says so.
    drive_catalog const* drive_there(open_line& line) const
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
        return who.drive;
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
        output results{chosen_.form, true};
        progress bar{clauses_.size()};
        clause const* before = nullptr;
        clause const* culprit = nullptr; // behind which the unit did not come to a known state
        for (std::size_t i = 0; i < clauses_.size() and noted_signal() == 0; ++i) {
            clause const& which = *clauses_[i];
            bar.show(i, ": " + std::string{which.id});
            judged_clause row{&which, judged_one(unit, which, before, culprit)};
            if (noted_signal() != 0) {
                break; // a clause that was cut says nothing
            }
            bar.clear();
            bool const is_shown = chosen_.form != output_form::table or row.found.how == verdict::fails or
                                  row.found.how == verdict::told or row.found.how == verdict::known;
            if (is_shown) {
                results.put(record_of(row, chosen_.form), row.found.how == verdict::fails);
            }
            rows_.push_back(std::move(row));
            before = &which;
        }
        bar.clear();
        results.finish();
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

    exit_status tell()
    {
        auto const count = [this](verdict how, auto... level) {
            return std::ranges::count_if(rows_, [&](judged_clause const& each) {
                return each.found.how == how and ((each.which->level == level) and ...);
            });
        };
        auto const fails = count(verdict::fails, clause_level::must);
        std::fprintf(stderr, "%zd clauses hold, %zd musts and %zd shoulds fail, %zd do not apply, %zd were not tried\n",
                     count(verdict::holds), fails, count(verdict::fails, clause_level::should),
                     count(verdict::does_not_apply), count(verdict::not_tried));
        if (noted_signal() != 0) {
            std::fprintf(stderr, "ended after %zu of %zu clauses\n", rows_.size(), clauses_.size());
        }
        if (not chosen_.check.junit.empty()) {
            write_junit(chosen_.check.junit, chosen_.line.port + " unit " + std::to_string(unit_.unit.byte()), rows_);
        }
        if (noted_signal() != 0) {
            return static_cast<exit_status>(128 + noted_signal());
        }
        return fails > 0 or is_left_changed_ ? exit_status::differs : exit_status::done;
    }

    choices const& chosen_;
    std::vector<clause const*> clauses_;
    scratch_places scratch_;
    check_profile profile_{chosen_.check.profile};
    named_unit unit_;
    bool may_change_{false};
    bool is_left_changed_{false};
    std::vector<judged_clause> rows_{};
};

} // namespace

exit_status run_check(choices const& chosen)
{
    if (chosen.check.lists) {
        return list_clauses(chosen);
    }
    if (not chosen.check.explained.empty()) {
        return explain_clause(chosen.check.explained);
    }
    return checking{chosen}.run();
}

} // namespace tool
