// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Writes a file's settings into a drive that stands. A dry run comes first, and shows what would be written.
#include <cstdio>
#include <optional>
#include <string>

#include "backup/drive_settings.hpp"
#include "backup/restore_record.hpp"
#include "catalog/entry_words.hpp"
#include "catalog/value_text.hpp"
#include "commands/commands.hpp"
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
            tell(plan, chosen_.restore.dry_run ? "nothing is written in a dry run" : "the drive holds all of it");
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
                .save = asked.save};
    }

    /// Before the line is opened: what would be written has to fit its register.
    void refuse_what_is_out_of_limits() const
    {
        for (saved_parameter const& each : settings_.parameters) {
            bool const is_meant = altivar::allowed_by(options(false), *each.entry->row) == restore_outcome::planned;
            if (is_meant and each.word and not each.entry->row->takes(each.entry->count_of(*each.word))) {
                drive_catalog const& drive = *settings_.drive;
                refuse_word(place_text(chosen_.file, each.place) + std::string{each.entry->code} + ": " +
                            value_text(*each.entry, *each.word, settings_) + " is not within its limits, " +
                            limit_text(each.entry->min, *each.entry, drive) + " to " +
                            limit_text(each.entry->max, *each.entry, drive) + ", or none of its values");
            }
        }
    }

    restored run_once(open_line& line, bool is_dry_run, restore_record& record)
    {
        return restore_({line.port(), line.options(), unit_.unit, *drive_, settings_, options(is_dry_run),
                         [&](register_entry const& entry, altivar::restore_report const& what) {
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
        std::string const what = "unit " + std::to_string(unit_.unit.byte()) + ", " + std::string{drive_->name} + ": " +
                                 std::to_string(plan.count(restore_outcome::planned)) + " settings of " + chosen_.file +
                                 " differ";
        if (not may_go_on(chosen_.allowed, what, "write them?")) {
            return exit_status::refused;
        }
        note_signals();
        restore_record record;
        restored const done = run_once(line, false, record);
        if (chosen_.restore.save and done.reason.kind == outcome_kind::succeeded) {
            log_write({chosen_.line.port, unit_.unit.byte(), "CMI", "restored", "0x0002 (save to eeprom)"});
        }
        return end(line, done, record, std::string{});
    }

    /// Options say what may be written; whatever may let a motor turn, or run on, needs --allow-run as for `write`.
    void refuse_without_run(restore_record const& plan) const
    {
        for (restored_parameter const& each : plan.parameters()) {
            auto const word = settings_.word_of(each.entry->code);
            if (each.last.outcome != restore_outcome::planned or not word or chosen_.allowed.may_run) {
                continue;
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
        show(record);
        std::string text = how.port_error != rtuwire::errc::none ? line.port().failure()
                           : how.was_ended                       ? "ended by a signal"
                                                                 : sentence_of(how.reason);
        text += note.empty() ? "" : "; " + note;
        tell(record, text);
        return how.port_error != rtuwire::errc::none ? exit_status::port
               : how.was_ended                       ? static_cast<exit_status>(128 + noted_signal())
                                                     : status_for(how.reason);
    }

    /// How it went, on the error output, so that results stay rows.
    void tell(restore_record const& record, std::string const& how) const
    {
        std::size_t sent = 0;
        for (restored_parameter const& each : record.parameters()) {
            sent += each.was_written ? 1U : 0U;
        }
        std::fprintf(stderr,
                     "rtuwire: %s; %zu written, %zu to be written, %zu held already, %zu not in the file, %zu never "
                     "written by a restore\n",
                     how.c_str(), sent, record.count(restore_outcome::planned), record.count(restore_outcome::holds),
                     record.count(restore_outcome::not_wanted), record.count(restore_outcome::never_written));
        std::fflush(stderr);
    }

    static std::string value_text(register_entry const& entry, std::uint16_t word, saved_settings const& in)
    {
        auto const step = step_of(entry, *in.drive, in.word_of(entry.steps_set_by));
        return step ? full_text(entry, word, *step) : std::to_string(word) + " steps";
    }

    static cell text_cell(register_entry const& entry, std::optional<std::uint16_t> word, saved_settings const& in)
    {
        return word ? cell{value_text(entry, *word, in)} : cell{};
    }

    void show(restore_record const& record)
    {
        for (restored_parameter const& each : record.parameters()) {
            if (is_worth_a_line(each, settings_)) {
                put(each);
            }
        }
        results_.finish();
    }

    void put(restored_parameter const& of)
    {
        bool const is_table = chosen_.form == output_form::table;
        std::string outcome{std::string_view{name_of(of.last.outcome)}};
        outcome += of.last.error == rtuwire::errc::none ? "" : ": " + words_of(of.last.error);
        record row{{"unit", std::int64_t{unit_.unit.byte()}},
                   {"register", is_table ? code_and_menu(*of.entry) : std::string{of.entry->code}},
                   {"held", text_cell(*of.entry, before_of(of), settings_)},
                   {"wanted", text_cell(*of.entry, settings_.word_of(of.entry->code), settings_)},
                   {"outcome",
                    of.was_written and of.last.outcome == restore_outcome::holds ? "written and read back" : outcome},
                   {"note", std::string{std::string_view{altivar::why(*of.entry->row)}}}};
        results_.put(row, is_bad(of.last.outcome));
    }

    static bool is_bad(restore_outcome outcome)
    {
        return outcome == restore_outcome::refused or outcome == restore_outcome::differs or
               outcome == restore_outcome::unconfirmed or outcome == restore_outcome::not_reached or
               outcome == restore_outcome::out_of_limits or outcome == restore_outcome::unreadable;
    }

    /// What it held before the first write: the dry run read it.
    std::optional<std::uint16_t> before_of(restored_parameter const& of) const
    {
        for (restored_parameter const& each :
             plan_ == nullptr ? std::vector<restored_parameter>{} : plan_->parameters()) {
            if (each.entry == of.entry) {
                return each.before;
            }
        }
        return of.before;
    }

    void log(register_entry const& entry, altivar::restore_report const& what)
    {
        if (not is_write(what.outcome)) {
            return;
        }
        auto const before = before_of({&entry});
        bool const is_known = what.outcome == restore_outcome::written or what.outcome == restore_outcome::differs;
        auto const text = [&](std::optional<std::uint16_t> word) {
            return word ? value_text(entry, *word, settings_) : std::string{"unknown"};
        };
        std::string const why = log_write({chosen_.line.port, unit_.unit.byte(), std::string{entry.code}, text(before),
                                           text(is_known ? what.held : std::nullopt)});
        if (not why.empty() and not is_log_missed_) {
            is_log_missed_ = true;
            std::fprintf(stderr, "rtuwire: not noted: %s\n", why.c_str());
        }
    }

    choices const& chosen_;
    named_unit unit_;
    output results_;
    saved_settings settings_;
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
    return restoring{chosen}.run();
}

} // namespace tool
