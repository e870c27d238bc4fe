// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
#include "line/asked_registers.hpp"

#include <algorithm>
#include <map>
#include <string_view>

#include "line/asked_units.hpp"
#include "line/who_is_it.hpp"
#include "output/plain_text.hpp"

namespace tool {

void refuse(refusal const& why) { refuse_word(why.sentence); }

std::vector<chosen_register> registers_in(std::vector<std::string> const& words, vocabulary const& known)
{
    std::vector<std::string_view> const views{words.begin(), words.end()};
    register_selection selection = select_registers(views, known);
    if (selection.refused) {
        refuse(*selection.refused);
    }
    return std::move(selection.registers);
}

namespace {

/// The table of a unit of which numbers are asked for. A number of a drive's menu means another register there than
/// the address, so the unit is asked who it is; null where it is none of the drives.
drive_catalog const* drive_of_numbers(open_line& line, unit_address unit, std::string_view menu_number)
{
    if (menu_number.empty()) {
        return nullptr;
    }
    identity_words const who = who_is_it(line, unit);
    if (not who.drive.empty()) {
        return catalog_named(who.drive);
    }
    if (who.is_another) {
        return nullptr;
    }
    std::string const why = who.note.empty() ? "is a '" + who.product + "' of which kind is not known" : who.note;
    throw ended{who.outcome == exit_status::done ? exit_status::differs : who.outcome,
                "unit " + std::to_string(unit.byte()) + ": " + why + "; " + ambiguity_of(menu_number)};
}

drive_catalog const* table_of(open_line& line, named_unit const& unit, std::vector<std::string> const& words)
{
    if (not unit.drive.empty()) {
        return catalog_or_none(unit.drive);
    }
    std::vector<std::string_view> const views{words.begin(), words.end()};
    bool const has_numbers_only = not select_registers(views, nullptr).refused;
    if (has_numbers_only) {
        return drive_of_numbers(line, unit.unit, first_menu_number(views));
    }
    drive_catalog const* drive = nullptr;
    auto const why = ended_by([&] { drive = &catalog_of(line, unit.unit, {}); });
    if (why) {
        throw ended{why->status, why->what() + std::string{why->status == exit_status::differs
                                                               ? "; names of what is no drive need --device FILE"
                                                               : ""}};
    }
    return drive;
}

/// Those words that name registers of this unit; the others it lacks.
void add_registers(asked_registers& asked, std::vector<std::string> const& words)
{
    vocabulary const known{asked.drive, asked.unit.names};
    std::vector<std::string> right;
    for (std::string const& word : words) {
        std::string_view const one[]{word};
        if (auto const why = select_registers(one, known).refused) {
            asked.lacks.push_back(*why);
        } else {
            right.push_back(word);
        }
    }
    asked.registers = registers_in(right, known);
}

asked_registers asked_of(open_line& line, named_unit const& unit, std::vector<std::string> const& words)
{
    asked_registers asked{.unit = unit, .drive = table_of(line, unit, words)};
    add_registers(asked, words);
    return asked;
}

/// Of one of several units that did not tell what it is: the places, which mean the same on any, are read all the same.
asked_registers places_of(open_line& line, named_unit const& unit, std::vector<std::string> const& words,
                          ended const& why)
{
    asked_registers asked{.unit = unit};
    add_registers(asked, words);
    std::vector<std::string> places = words;
    std::erase_if(places, [&asked](std::string const& word) {
        return std::ranges::count(asked.lacks, word, &refusal::culprit) > 0;
    });
    if (asked.registers.empty() or asked.lacks.empty()) {
        return {.unit = unit, .failure = why};
    }
    std::vector<std::string_view> const views{places.begin(), places.end()};
    try {
        asked.drive = drive_of_numbers(line, unit.unit, first_menu_number(views));
    } catch (ended const& ambiguous) {
        return {.unit = unit, .failure = ambiguous};
    }
    asked.unknown = why.what();
    return asked;
}

/// Before anything is sent: the words of each unit.
std::vector<std::vector<std::string>> words_of_each(std::vector<std::string> const& words,
                                                    std::vector<named_unit> const& units)
{
    std::vector<std::vector<std::string>> all;
    for (named_unit const& unit : units) {
        std::vector<std::string> const& own = all.emplace_back(words_for(unit, words, units));
        std::vector<std::string_view> const views{own.begin(), own.end()};
        if (auto const wrong = wrong_place_in(views)) {
            refuse(*wrong);
        }
    }
    return all;
}

/// What one more unit says of a word: the nearest right one goes before a refusal without.
void note_unknown(std::map<std::string, std::optional<refusal>>& wrong, std::string const& word,
                  std::optional<refusal> const& why)
{
    auto const [found, is_new] = wrong.try_emplace(word, why);
    bool const is_better = found->second and (not why or found->second->nearest.empty());
    found->second = is_new or not is_better ? found->second : why;
}

void refuse_first(std::map<std::string, std::optional<refusal>> const& wrong)
{
    for (auto const& [word, why] : wrong) {
        if (why) {
            refuse(*why);
        }
    }
}

/// Why a word means nothing on a unit that was not asked yet who it is.
std::optional<refusal> why_unknown(named_unit const& unit, std::string const& word)
{
    std::string_view const one[]{word};
    drive_catalog const* const drive = unit.drive.empty() ? nullptr : catalog_or_none(unit.drive);
    std::optional<refusal> why = select_registers(one, {drive, unit.names}).refused;
    for (drive_catalog const* const each : all_catalogs()) {
        if (why and unit.drive.empty()) {
            why = select_registers(one, each).refused;
        }
    }
    return why;
}

/// A word that none of the units knows is wrong; where one of them did not tell what it is, it may be that one's.
void refuse_unknown(std::vector<asked_registers> const& all, std::vector<std::vector<std::string>> const& words)
{
    auto const is_open = [](asked_registers const& each) { return each.failure or not each.unknown.empty(); };
    if (std::ranges::any_of(all, is_open)) {
        return;
    }
    std::map<std::string, std::optional<refusal>> wrong; // of a word that some unit knows, nothing
    for (std::size_t i = 0; i < all.size(); ++i) {
        for (std::string const& word : words[i]) {
            auto const why = std::ranges::find(all[i].lacks, word, &refusal::culprit);
            note_unknown(wrong, word, why == all[i].lacks.end() ? std::nullopt : std::optional{*why});
        }
        for (refusal const& why : all[i].lacks) { // one that names only a part of its word
            if (not std::ranges::count(words[i], why.culprit)) {
                refuse(why);
            }
        }
    }
    refuse_first(wrong);
}

} // namespace

std::vector<asked_registers> registers_asked(std::vector<std::string> const& words,
                                             std::vector<named_unit> const& units, open_line& line)
{
    auto const own = words_of_each(words, units);
    std::vector<asked_registers> all;
    for (std::size_t i = 0; i < units.size(); ++i) {
        if (own[i].empty()) {
            refuse_word("nothing is asked of " + name_of(units[i]));
        }
        try {
            all.push_back(asked_of(line, units[i], own[i]));
        } catch (ended const& why) { // the others are read all the same
            if (units.size() == 1 or why.status == exit_status::usage or why.status == exit_status::port) {
                throw;
            }
            all.push_back(places_of(line, units[i], own[i], why));
        }
    }
    refuse_unknown(all, own);
    for (asked_registers& each : all) {
        if (not each.failure and each.registers.empty()) {
            each.failure.emplace(exit_status::differs, name_of(each.unit) + " has none of these registers");
        }
    }
    return all;
}

void check_register_words(std::vector<std::string> const& words, std::vector<named_unit> const& units)
{
    std::map<std::string, std::optional<refusal>> wrong; // of a word that some unit may know, nothing
    auto const own = words_of_each(words, units);
    for (std::size_t i = 0; i < units.size(); ++i) {
        for (std::string const& word : own[i]) {
            note_unknown(wrong, word, why_unknown(units[i], word));
        }
    }
    refuse_first(wrong);
}

bool is_known_to(named_unit const& unit, std::string const& word)
{
    return not unit.drive.empty() and not why_unknown(unit, word);
}

void tell_left_out(std::vector<asked_registers> const& all)
{
    for (asked_registers const& each : all) {
        if (each.failure) {
            tell_error(each.failure->what());
            continue;
        }
        std::string words;
        for (refusal const& why : each.lacks) {
            words += (words.empty() ? "" : ", ") + why.culprit;
        }
        if (not words.empty()) {
            tell_error("note: " + name_of(each.unit) + " has no " + words +
                       (each.unknown.empty() ? "" : " that is known: " + each.unknown));
        }
    }
}

} // namespace tool
