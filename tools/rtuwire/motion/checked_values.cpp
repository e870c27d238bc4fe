// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
#include "motion/checked_values.hpp"

#include <algorithm>
#include <optional>
#include <string>

#include "line/asked_registers.hpp"
#include "line/reading.hpp"
#include "line/register_reader.hpp"
#include "motion/unsafe_write.hpp"
#include "words/value_block.hpp"

namespace tool {

namespace {

void refuse_if_wrong(value_to_write const& value, write_rules const& rules, choices const& chosen)
{
    refuse_command(value, rules, chosen);
    if (value.refused) {
        refuse(*value.refused);
    }
    if (rules.drive != nullptr) {
        refuse_unsafe_write(value, *rules.drive, chosen);
    }
    refuse_what_moves(value, chosen.allowed);
}

/// Two forms of one register of what is no drive: one of them is not what somebody wants there.
void refuse_overlap(std::vector<value_to_write> const& before, value_to_write const& one,
                    std::vector<std::string> const& words)
{
    auto const other =
        std::ranges::find_if(before, [&one](value_to_write const& each) { return overlap(each.where, one.where); });
    if (other != before.end()) {
        refuse_word("'" + words[before.size()] + "' and '" + words[static_cast<std::size_t>(other - before.begin())] +
                    "' write one register: say one of them");
    }
}

} // namespace

void refuse_unsafe_values(std::vector<value_to_write> const& values, write_rules const& rules, choices const& chosen)
{
    if (rules.drive != nullptr) {
        refuse_for_safety("the unit is an " + std::string{rules.drive->name} +
                          ", whose settings are restored by what is known of it: leave out --device");
    }
    for (value_to_write const& each : values) {
        refuse_if_wrong(each, rules, chosen);
    }
}

void refuse_changed_values(std::vector<value_to_write> const& confirmed, std::vector<value_to_write> const& now)
{
    for (std::size_t i = 0; i < confirmed.size(); ++i) {
        value_to_write const& was = confirmed[i];
        value_to_write const& is = now[i];
        bool const is_same_count = was.words == is.words;
        if (is_same_count and was.text == is.text) {
            continue;
        }
        auto const words_of = [is_same_count](value_to_write const& each) {
            return is_same_count ? each.text : std::to_string(each.words[0]) + " in the unit's steps";
        };
        throw ended{exit_status::refused, label_of({was.where, was.entry}) + " was " + words_of(was) +
                                              " when you were asked, and is " + words_of(is) +
                                              " now: somebody changed its steps; nothing is written"};
    }
}

std::vector<value_to_write> checked_values(std::vector<std::string> const& typed, open_line& line,
                                           named_unit const& unit, write_rules const& rules, choices const& chosen)
{
    vocabulary const meant{rules.drive, unit.names};
    std::vector<std::string> words;
    std::vector<bool> is_with_previous;
    for (std::string const& word : typed) {
        value_block const block = values_in(word, meant);
        for (chosen_register const& each : block.registers) { // whatever their values are
            refuse_command({.where = each.where, .entry = each.entry}, rules, chosen);
        }
        if (block.refused) {
            refuse(*block.refused);
        }
        words.insert(words.end(), block.words.begin(), block.words.end());
        is_with_previous.push_back(false);
        is_with_previous.resize(words.size(), true);
    }
    std::vector<chosen_register> needed;
    for (std::string const& word : words) { // what needs no request to be refused
        value_to_write const value = check_value(word, meant);
        refuse_if_wrong(value, rules, chosen);
        for (register_entry const* const each : value.needed) {
            needed.push_back({{each->address}, each});
        }
    }
    register_reader limits{needed, meant};
    limits.read(line, unit.unit);
    std::vector<value_to_write> values;
    known_words const known = [&](std::string_view code) -> std::optional<std::uint16_t> {
        auto const written = std::find_if(values.rbegin(), values.rend(), [code](value_to_write const& each) {
            return each.entry != nullptr and each.entry->code == code;
        });
        return written != values.rend() ? std::optional{written->words[0]} : limits.known()(code);
    };
    for (std::string const& word : words) {
        value_to_write value = check_value(word, meant, known);
        refuse_if_wrong(value, rules, chosen);
        if (not value.is_ready()) {
            throw ended{status_of(limits.first_error()), "'" + word + "' is limited by " +
                                                             std::string{value.needed.front()->code} +
                                                             ", which could not be read: " + limits.first_failure()};
        }
        if (rules.drive == nullptr) {
            refuse_overlap(values, value, words);
        }
        value.is_with_previous = is_with_previous[values.size()];
        values.push_back(value);
    }
    return values;
}

} // namespace tool
