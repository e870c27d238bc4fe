// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Writes a file's settings into a drive that stands. A dry run comes first, and shows what would be written.
#include <algorithm>
#include <cstdio>
#include <optional>
#include <string>

#include "backup/drive_settings.hpp"
#include "backup/restore_record.hpp"
#include "backup/restore_view.hpp"
#include "catalog/entry_words.hpp"
#include "catalog/value_text.hpp"
#include "commands/commands.hpp"
#include "commands/device_commands.hpp"
#include "line/end_wish.hpp"
#include "line/line_words.hpp"
#include "line/who_is_it.hpp"
#include "line/write_log.hpp"
#include "motion/moving_registers.hpp"
#include "motion/question.hpp"

namespace tool {

namespace {

namespace altivar = rtuwire::altivar;
using altivar::outcome_kind;

exit_status status_for(altivar::reason const& why)
{
    if (why.kind == outcome_kind::succeeded) {
        return exit_status::done;
    }
    if (why.kind == outcome_kind::silent or why.kind == outcome_kind::executed_unconfirmed) {
        return why.error == rtuwire::errc::none ? exit_status::no_answer : status_of(why.error);
    }
    bool const is_of_settings = why.kind == outcome_kind::refused or why.kind == outcome_kind::not_taken;
    // Else the drive runs, is commanded, is another one.
    return is_of_settings ? exit_status::differs : exit_status::refused;
}

class restoring {
public:
    explicit restoring(choices const& chosen)
        : chosen_{chosen}, unit_{unit_to_change(chosen)}, results_{chosen.form, false}, settings_{settings_of_file(
                                                                                            chosen.file, unit_.drive)}
    {}

    exit_status run()
    {
        refuse_nothing_to_restore();
        refuse_what_is_out_of_limits();
        if (not chosen_.restore.dry_run) {
            refuse_wrong_log();
        }
        open_line line{chosen_.line};
        drive_ = &catalog_of(line, unit_.unit, unit_.drive);
        restore_ = restore_for(drive_->name);
        if (restore_ == nullptr) {
            refuse_for_safety("settings of an " + std::string{drive_->name} +
                              " are backed up and compared, and not restored");
        }
        restore_record plan;
        restored const planned = run_once(line, true, plan);
        if (planned.reason.kind != outcome_kind::succeeded or planned.port_error != rtuwire::errc::none) {
            return end(line, planned, plan, "nothing was written");
        }
        if (chosen_.restore.dry_run or plan.count(restore_outcome::planned) == 0) {
            show(plan);
            tell(plan, chosen_.restore.dry_run                   ? "nothing is written in a dry run"
                       : plan.count(restore_outcome::holds) == 0 ? "there is nothing in it that this restore may write"
                                                                 : "the drive holds all that it may write");
            return exit_status::done;
        }
        return write(line, plan);
    }

private:
    altivar::restore_options options(bool is_dry_run) const
    {
        restore_choices const& asked = chosen_.restore;
        return {.dry_run = is_dry_run,
                .with_channels = asked.with_channels,
                .with_link = asked.with_link,
                .with_inferred = asked.with_inferred,
                .with_supervision = asked.with_supervision,
                .with_autorestart = asked.with_autorestart,
                .save = asked.save,
                .terminals = {.accept_unseen_inputs = asked.has_open_inputs}};
    }

    /// A file of which nothing is left, or that was made of another drive, must not end as if the drive held it.
    void refuse_nothing_to_restore() const
    {
        auto const has_word = [](saved_parameter const& each) { return each.word.has_value(); };
        if (std::ranges::none_of(settings_.parameters, has_word)) {
            refuse_word(chosen_.file + ": there is no value in it that could be restored");
        }
    }

    /// Before the line is opened: what would be written has to fit its register.
    void refuse_what_is_out_of_limits() const
    {
        for (saved_parameter const& each : settings_.parameters) {
            bool const is_meant = altivar::allowed_by(options(false), *each.entry->row) == restore_outcome::planned;
            if (is_meant and each.word and not each.entry->row->takes(each.entry->count_of(*each.word))) {
                drive_catalog const& drive = *settings_.drive;
                refuse_word(place_text(chosen_.file, each.place) + std::string{each.entry->code} + ": " +
                            view_.wanted_text(*each.entry, *each.word) + " is not within its limits, " +
                            limit_text(each.entry->min, *each.entry, drive) + " to " +
                            limit_text(each.entry->max, *each.entry, drive) + ", or none of its values");
            }
        }
    }

    restored run_once(open_line& line, bool is_dry_run, restore_record& record)
    {
        return restore_({line.port(), line.options(), line.exchange(), unit_.unit, *drive_, settings_,
                         options(is_dry_run), [&](register_entry const& entry, altivar::restore_report const& what) {
                             record.note(entry, what);
                             if (not is_dry_run) {
                                 log(entry, what);
                             }
                         }});
    }

    exit_status write(open_line& line, restore_record const& plan)
    {
        refuse_without_run(plan);
        if (chosen_.form == output_form::table and not chosen_.allowed.is_confirmed) {
            show(plan);
        }
        plan_ = &plan;
        view_.note_plan(plan);
        std::string const what = "unit " + std::to_string(unit_.unit.byte()) + ", " + std::string{drive_->name} + ": " +
                                 std::to_string(plan.count(restore_outcome::planned)) + " settings of " + chosen_.file +
                                 " differ";
        if (not may_go_on(chosen_.allowed, what, "write them?")) {
            return exit_status::refused;
        }
        refuse_wrong_log(plan.count(restore_outcome::planned) + 1U);
        note_signals();
        restore_record record;
        restored const done = run_once(line, false, record);
        if (done.is_saved) {
            note_in_log("CMI", "restored", "0x0002 (save to eeprom)");
        }
        std::string note = chosen_.restore.save ? done.is_saved ? "saved" : "not saved" : "";
        if (std::string const changed = changed_steps(record); not changed.empty()) {
            note = changed + (note.empty() ? "" : "; " + note);
        }
        return end(line, done, record, note);
    }

    /// Options say what may be written; whatever may let a motor turn, or run on, needs --allow-run as for `write`.
    void refuse_without_run(restore_record const& plan) const
    {
        for (restored_parameter const& each : plan.parameters()) {
            auto const word = settings_.word_of(each.entry->code);
            if (each.last.outcome != restore_outcome::planned or not word or chosen_.allowed.may_run) {
                continue;
            }
            std::string const out_of_reach = why_it_is_out_of_reach(*each.entry, *word);
            if (not out_of_reach.empty()) {
                refuse_for_safety("nothing was written: " + std::string{each.entry->code} + " " + out_of_reach +
                                  "; to restore it, say --allow-run besides");
            }
            std::string const moves = why_it_may_move(*each.entry);
            std::string const why = moves.empty() ? why_it_runs_on(each.entry->address, *word, *drive_) : moves;
            if (not why.empty()) {
                refuse_for_safety("nothing was written: " + std::string{each.entry->code} + " " + why +
                                  ": a motor may turn or run on after it; to restore it, say --allow-run besides");
            }
        }
    }

    exit_status end(open_line& line, restored const& how, restore_record const& record, std::string const& note)
    {
        // Of another drive's settings nothing can be said register by register.
        bool const is_other_drive = how.reason.kind == outcome_kind::other_family;
        std::string text = how.port_error != rtuwire::errc::none ? line.port().failure()
                           : how.was_ended                       ? "ended by a signal"
                                           : sentence_for(how.reason, record) + remedy_for(how.reason);
        text += note.empty() ? "" : "; " + note;
        if (is_other_drive) {
            tell_of_another_drive(text);
        } else {
            show(record);
            tell(record, text);
        }
        return how.port_error != rtuwire::errc::none ? exit_status::port
               : how.was_ended                       ? static_cast<exit_status>(128 + noted_signal())
               : is_log_missed_ and how.reason.kind == outcome_kind::succeeded ? exit_status::port
                                                                               : status_for(how.reason);
    }

    /// What could not even be tried ends a restore as what reads back otherwise does.
    static std::string sentence_for(altivar::reason const& why, restore_record const& record)
    {
        if (why.kind == outcome_kind::overwritten) {
            return "somebody commands the drive: its command is not 0000";
        }
        bool const was_not_tried = why.kind == outcome_kind::not_taken and record.count(restore_outcome::differs) == 0;
        return was_not_tried ? "a setting cannot be written as it is wanted: its row says why" : sentence_of(why);
    }

    std::string remedy_for(altivar::reason const& why) const
    {
        if (why.kind == outcome_kind::other_family) {
            return ": the settings are of an " + std::string{settings_.drive->name};
        }
        if (why.kind == outcome_kind::overwritten) {
            return "; if that is what a stop left there, `" + shown_command(chosen_.line, "stop --freewheel") +
                   "` clears it";
        }
        return why.kind == outcome_kind::unknown_register
                   ? ": this drive does not tell its inputs; see that no run input is closed, and say --inputs-open"
                   : "";
    }

    /// All that there is to say; to programs as a row.
    void tell_of_another_drive(std::string const& text)
    {
        if (chosen_.form != output_form::table) {
            results_.put({{"unit", std::int64_t{unit_.unit.byte()}}, {"error", text}});
            results_.finish();
        }
        std::fprintf(stderr, "rtuwire: %s\n", text.c_str());
    }

    /// How it went, on the error output, so that results stay rows.
    static void tell(restore_record const& record, std::string const& how)
    {
        std::fprintf(stderr, "rtuwire: %s; %s\n", how.c_str(), counts_text(record).c_str());
        std::fflush(stderr);
    }

    void show(restore_record const& record)
    {
        for (restored_parameter const& each : record.parameters()) {
            if (is_worth_a_line(each, settings_)) {
                results_.put(view_.row_of(each, record, unit_.unit, chosen_.form), is_bad(each.last.outcome));
            }
        }
        results_.finish();
    }

    void log(register_entry const& entry, altivar::restore_report const& what)
    {
        if (not is_write(what.outcome)) {
            return;
        }
        auto const before = view_.before_of({&entry});
        bool const is_known = what.outcome == restore_outcome::written or what.outcome == restore_outcome::differs;
        std::string const old = before ? view_.held_text(entry, *before, *plan_) : "unknown";
        std::string const now = is_known and what.held ? view_.wanted_text(entry, *what.held) : "unknown";
        note_in_log(std::string{entry.code}, old, now);
    }

    void note_in_log(std::string const& label, std::string const& old, std::string const& now)
    {
        std::string const why = log_write({chosen_.line.port, unit_.unit.byte(), label, old, now});
        if (not why.empty() and not is_log_missed_) {
            is_log_missed_ = true;
            std::fprintf(stderr, "rtuwire: not noted: %s\n", why.c_str());
        }
    }

    choices const& chosen_;
    named_unit unit_;
    output results_;
    saved_settings settings_;
    restore_view view_{settings_};
    drive_catalog const* drive_{nullptr};
    restore_function restore_{nullptr};
    restore_record const* plan_{nullptr};
    bool is_log_missed_{false};
};

} // namespace

exit_status run_restore(choices const& chosen)
{
    if (not chosen.allowed.may_write and not chosen.restore.dry_run) {
        refuse_for_safety("this program only reads; to restore settings, say --write, or look first with --dry-run");
    }
    return unit_in(chosen.line).names == nullptr ? restoring{chosen}.run() : restore_device(chosen);
}

} // namespace tool
