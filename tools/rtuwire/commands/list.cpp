// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// The drives that this program knows, or the registers of one: no line is needed.
#include <string>

#include "catalog/value_text.hpp"
#include "commands/commands.hpp"
#include "line/asked_registers.hpp"
#include "line/who_is_it.hpp"

namespace tool {

namespace {

record of_drive(drive_catalog const& drive)
{
    return {{"drive", std::string{drive.name}},
            {"reference", std::string{drive.reference}},
            {"registers", static_cast<std::int64_t>(drive.registers.size())},
            {"most in a read", std::int64_t{drive.limits.read}},
            {"most in a write", std::int64_t{drive.limits.write}}};
}

/// A limit, or a default, as people read it; programs get counts of them.
std::string amount_of(std::int64_t count, register_entry const& entry, drive_catalog const& drive)
{
    auto const step = step_of(entry, drive);
    bool const is_amount = entry.kind == register_kind::number or entry.kind == register_kind::signed_number;
    return is_amount and step ? amount_text(count, *step, entry.unit)
           : is_amount        ? std::to_string(count) + " steps"
                              : std::to_string(count);
}

std::string note_on(register_entry const& entry, drive_catalog const& drive)
{
    std::string note;
    if (not entry.steps_set_by.empty()) {
        note = "steps set by " + std::string{entry.steps_set_by};
    }
    if (entry.gap_first <= entry.gap_last) {
        note += (note.empty() ? "never " : "; never ") + amount_of(entry.gap_first, entry, drive) + " to " +
                amount_of(entry.gap_last, entry, drive);
    }
    return note;
}

std::string limit_text(rtuwire::bound const& limit, register_entry const& entry, drive_catalog const& drive)
{
    return limit.is_number() ? amount_of(limit.raw(), entry, drive) : text_of_bound(limit);
}

record of_register(register_entry const& entry, drive_catalog const& drive, bool is_table)
{
    auto const step = step_of(entry, drive);
    return {{"register", std::string{entry.code}},
            {"address", std::int64_t{entry.address}},
            {"access", std::string{text_of(entry.mode)}},
            {"kind", std::string{text_of(entry.kind)}},
            {"step", step and not entry.unit.empty() ? amount_text(1, *step, entry.unit) : std::string{}},
            {"lowest", is_table ? limit_text(entry.min, entry, drive) : text_of_bound(entry.min)},
            {"highest", is_table ? limit_text(entry.max, entry, drive) : text_of_bound(entry.max)},
            {"default", not entry.factory ? cell{}
                        : is_table        ? cell{amount_of(*entry.factory, entry, drive)}
                                          : cell{std::int64_t{*entry.factory}}},
            {"source", std::string{text_of(entry.source)}},
            {"name", std::string{entry.name}},
            {"note", note_on(entry, drive)}};
}

} // namespace

exit_status run_list(choices const& chosen)
{
    output results{chosen.form, false};
    if (chosen.line.drive.empty()) {
        if (not chosen.words.empty() or not chosen.search.empty()) {
            refuse_word("the registers of which drive? say --drive");
        }
        for (drive_catalog const* const each : all_catalogs()) {
            results.put(of_drive(*each));
        }
        results.finish();
        return exit_status::done;
    }
    drive_catalog const& drive = catalog_chosen(chosen.line.drive);
    std::vector<register_entry const*> shown;
    if (not chosen.search.empty()) {
        shown = search_registers(drive, chosen.search);
    } else if (chosen.words.empty()) {
        shown = search_registers(drive, "");
    } else {
        for (chosen_register const& each : registers_in(chosen.words, &drive)) {
            shown.push_back(each.entry);
        }
    }
    for (register_entry const* const each : shown) {
        if (each != nullptr) {
            results.put(of_register(*each, drive, chosen.form == output_form::table));
        }
    }
    results.finish();
    return shown.empty() ? exit_status::differs : exit_status::done;
}

} // namespace tool
