// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// The drives that this program knows, or the registers of one: no line is needed.
#include <algorithm>
#include <cstdio>
#include <string>

#include "catalog/entry_words.hpp"
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

/// Programs get counts of what people get with its unit.
record of_register(register_entry const& entry, drive_catalog const& drive, bool is_table)
{
    auto const step = step_of(entry, drive);
    record row{{"register", std::string{entry.code}}, {"address", std::int64_t{entry.address}}};
    if (has_menu(drive)) {
        row.add("menu", std::string{entry.menu});
    }
    return row.add("group", std::string{entry.group})
        .add("access", std::string{text_of(entry.mode)})
        .add("kind", std::string{text_of(entry.kind)})
        .add("step", step and not entry.unit.empty() ? amount_text(1, *step, entry.unit) : std::string{})
        .add("lowest", is_table ? limit_text(entry.min, entry, drive) : text_of_bound(entry.min))
        .add("highest", is_table ? limit_text(entry.max, entry, drive) : text_of_bound(entry.max))
        .add("default", not entry.factory ? cell{}
                        : is_table        ? cell{default_text(*entry.factory, entry, drive)}
                                          : cell{std::int64_t{*entry.factory}})
        .add("source", std::string{text_of(entry.source)})
        .add("name", std::string{entry.name})
        .add("note", note_on(entry, drive));
}

/// The registers of a word, a search and a group, where each was said: of all of them at once.
std::vector<register_entry const*> chosen_of(choices const& chosen, drive_catalog const& drive)
{
    std::vector<register_entry const*> shown = search_registers(drive, chosen.search);
    auto const keep = [&shown](std::vector<std::string> const& words, drive_catalog const& of) {
        std::vector<chosen_register> const named = registers_in(words, &of);
        std::erase_if(shown, [&named](register_entry const* each) {
            return not std::ranges::count(named, each, &chosen_register::entry);
        });
    };
    if (not chosen.words.empty()) {
        keep(chosen.words, drive);
    }
    if (not chosen.group.empty()) {
        keep({"@" + chosen.group}, drive);
    }
    return shown;
}

exit_status list_drives(choices const& chosen)
{
    if (not chosen.words.empty() or not chosen.search.empty() or not chosen.group.empty()) {
        refuse_word("the registers of which drive? say --drive");
    }
    output results{chosen.form, false};
    for (drive_catalog const* const each : all_catalogs()) {
        results.put(of_drive(*each));
    }
    results.finish();
    return exit_status::done;
}

} // namespace

exit_status run_list(choices const& chosen)
{
    if (chosen.line.drive.empty()) {
        return list_drives(chosen);
    }
    drive_catalog const& drive = catalog_chosen(chosen.line.drive);
    std::vector<register_entry const*> const shown = chosen_of(chosen, drive);
    if (shown.empty()) {
        std::fprintf(stderr, "rtuwire: no register of an %s is found by that\n", std::string{drive.name}.c_str());
    }
    output results{chosen.form, false};
    for (register_entry const* const each : shown) {
        results.put(of_register(*each, drive, chosen.form == output_form::table));
    }
    results.finish();
    return shown.empty() ? exit_status::differs : exit_status::done;
}

} // namespace tool
