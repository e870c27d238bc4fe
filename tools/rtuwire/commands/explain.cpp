// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// All that is known of registers, of one drive or of each that has them: no line is needed.
#include <string>
#include <vector>

#include "catalog/entry_words.hpp"
#include "catalog/value_text.hpp"
#include "commands/commands.hpp"
#include "line/asked_registers.hpp"
#include "line/who_is_it.hpp"
#include "motion/moving_registers.hpp"

namespace tool {

namespace {

std::string_view meaning_of(rtuwire::provenance source)
{
    switch (source) {
    case rtuwire::provenance::documented:
        return "documented: printed in the drive's manual or in the manufacturer's parameter file";
    case rtuwire::provenance::inferred:
        return "inferred: from the file of a sister drive, and the drive may take other values than these";
    case rtuwire::provenance::doubtful:
        return "doubtful: the sources contradict themselves, or tell little more than that it exists";
    }
    return "";
}

std::string_view meaning_of(rtuwire::access mode)
{
    switch (mode) {
    case rtuwire::access::read_only: return "read only";
    case rtuwire::access::read_write: return "read, write";
    case rtuwire::access::configuration: return "read, write while the motor is stopped";
    }
    return "";
}

/// Its values, or its bits, a text each: "SEP (2): separate".
std::vector<std::string> values_of(register_entry const& entry)
{
    std::vector<std::string> list;
    auto const words_for = [&entry](std::uint16_t value) {
        rtuwire::choice const* const choice = entry.choice_of(value);
        return choice == nullptr or choice->meaning.size() == 0 ? std::string{}
                                                                : ": " + std::string{std::string_view{choice->meaning}};
    };
    for (rtuwire::choice const& each : entry.values()) {
        list.push_back(std::string{std::string_view{each.mnemonic}} + " (" + std::to_string(each.word) + ")" +
                       words_for(each.word));
    }
    for (std::uint16_t bit = 0; bit < entry.bits.size() and entry.kind == register_kind::bits; ++bit) {
        if (not entry.bits[bit].empty()) {
            list.push_back("bit " + std::to_string(bit) + ", " + std::string{entry.bits[bit]} + words_for(bit));
        }
    }
    return list;
}

/// What a write may do besides what it is meant for.
std::string effect_of(register_entry const& entry, drive_catalog const& drive)
{
    if (not entry.is_writable()) {
        return {};
    }
    if (commands_a_motor(entry.address, drive)) {
        return "it commands the motor: only start and stop write it";
    }
    std::string text;
    auto const add = [&text](std::string const& more) { text += (text.empty() or more.empty() ? "" : "; ") + more; };
    if (std::string const why = why_it_may_move(entry); not why.empty()) {
        add("it " + why + ": a motor may turn after it");
    }
    if (std::string const why = why_it_runs_otherwise(entry); not why.empty()) {
        add("it " + why +
            ": a motor that runs turns otherwise after it, so a drive with power takes it with --allow-run only");
    }
    for (std::uint16_t const value : std::initializer_list<std::uint16_t>{0, 1, 4, 5}) {
        bool const is_value = entry.values().empty() ? value == 0 : text_of(entry, value)[0] != '#';
        std::string const why = is_value ? why_it_runs_on(entry.address, value, drive) : std::string{};
        add(why.empty() ? why : std::to_string(value) + " " + why);
        std::string const lost = value == 0 ? why_it_is_out_of_reach(entry, value) : std::string{};
        add(lost.empty() ? lost : std::to_string(value) + " " + lost);
        std::string const never = value == 1 ? why_it_is_never_written(entry, value, drive) : std::string{};
        add(never);
    }
    if (takes_orders(entry, drive)) {
        add("it takes an order, and need not hold what was written");
    }
    return text;
}

record facts_of(register_entry const& entry, drive_catalog const& drive)
{
    auto const step = step_of(entry, drive);
    record row{{"drive", std::string{drive.name}},
               {"register", std::string{entry.code}},
               {"address", std::int64_t{entry.address}},
               {"menu", std::string{entry.menu}},
               {"group", std::string{entry.group}},
               {"name", std::string{entry.name}},
               {"access", std::string{meaning_of(entry.mode)}},
               {"kind", std::string{text_of(entry.kind)}},
               {"unit", std::string{entry.unit}},
               {"step", step and entry.is_amount() ? amount_text(1, *step, entry.unit) : std::string{}}};
    return row.add("lowest", limit_text(entry.min, entry, drive))
        .add("highest", limit_text(entry.max, entry, drive))
        .add("default", entry.factory ? cell{default_text(*entry.factory, entry, drive)} : cell{})
        .add("source", std::string{meaning_of(entry.source)})
        .add("note", note_on(entry, drive))
        .add("a write", effect_of(entry, drive));
}

std::string one_text(std::vector<std::string> const& list)
{
    std::string text;
    for (std::string const& each : list) {
        text += (text.empty() ? "" : "; ") + each;
    }
    return text;
}

/// For people: the register and its drive as a head, then a line a fact, and a line a value.
void show_lines(output& results, record const& facts, std::vector<std::string> const& values)
{
    std::vector<field> const& all = facts.fields();
    std::string const drive = text_of_cell(all[0].value);
    std::string const code = text_of_cell(all[1].value);
    auto const put = [&](std::string const& what, std::string const& text) {
        results.put({{code, what}, {drive, text}});
    };
    for (std::size_t i = 2; i < all.size(); ++i) {
        if (std::string const text = text_of_cell(all[i].value); not text.empty()) {
            put(all[i].name, text);
        }
    }
    for (std::string const& each : values) {
        put("value", each);
    }
}

void show(output& results, output_form form, register_entry const& entry, drive_catalog const& drive)
{
    record facts = facts_of(entry, drive);
    std::vector<std::string> const values = values_of(entry);
    if (form == output_form::table) {
        show_lines(results, facts, values);
    } else {
        results.put(facts.add("values", one_text(values)));
    }
}

/// Of the drive that was said; else of each that has what the word names. Refuses a word that none has.
std::vector<drive_catalog const*> drives_with(choices const& chosen, std::string const& word)
{
    if (not chosen.line.drive.empty()) {
        return {&catalog_chosen(chosen.line.drive)};
    }
    std::vector<drive_catalog const*> found;
    std::string_view const one[]{word};
    std::optional<refusal> first;
    for (drive_catalog const* const each : all_catalogs()) {
        register_selection const selected = select_registers(one, each);
        if (selected.refused) {
            first = first and not first->nearest.empty() ? first : selected.refused;
        } else if (selected.registers.front().entry != nullptr) {
            found.push_back(each);
        }
    }
    if (found.empty()) {
        // What is said of one drive's list says nothing where none was named.
        bool const is_of_a_list = not first or first->kind == "unknown_register" or first->kind == "unknown_group";
        std::string const nearest =
            first and not first->nearest.empty() ? "; did you mean " + first->nearest + "?" : std::string{};
        refuse_word(is_of_a_list ? word + ": no drive of this program is known to have it" + nearest : first->sentence);
    }
    return found;
}

} // namespace

exit_status run_explain(choices const& chosen)
{
    output results{chosen.form, false};
    for (std::string const& word : chosen.words) {
        for (drive_catalog const* const drive : drives_with(chosen, word)) {
            for (chosen_register const& each : registers_in({word}, drive)) {
                if (each.entry == nullptr) {
                    refuse_word(word + ": nothing is known of register " + text_of(each.where) + " of an " +
                                std::string{drive->name});
                }
                show(results, chosen.form, *each.entry, *drive);
            }
        }
    }
    results.finish();
    return exit_status::done;
}

} // namespace tool
