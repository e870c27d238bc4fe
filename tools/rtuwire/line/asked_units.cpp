// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
#include "line/asked_units.hpp"

#include <algorithm>
#include <iterator>
#include <sstream>
#include <string_view>
#include <utility>

#include "line/who_is_it.hpp"
#include "words/suggestion.hpp"

namespace tool {

namespace {

bool is_name(std::vector<named_unit> const& named, std::string const& word)
{
    return std::ranges::count(named, word, &named_unit::name) > 0;
}

bool is_number_or_range(std::string const& word)
{
    return not word.empty() and word.find_first_not_of("0123456789-") == std::string::npos;
}

/// A register file is of what nobody called a drive.
named_unit one_of_several(line_choices line, std::string const& word)
{
    line.unit = word;
    std::string const device = std::exchange(line.device, {});
    named_unit const plain = unit_in(line);
    if (plain.names != nullptr or (not plain.drive.empty() and plain.drive != no_drive)) {
        return plain;
    }
    line.device = device;
    return unit_in(line);
}

void add_new(std::vector<named_unit>& units, named_unit const& one)
{
    if (not std::ranges::count(units, one.unit, &named_unit::unit)) {
        units.push_back(one);
    }
}

/// Adds the units of one part of a list; an address that has a name keeps it.
void add_part(std::vector<named_unit>& units, line_choices const& line, std::string const& part)
{
    if (is_name(names_in(line), part) or not is_number_or_range(part)) {
        add_new(units, one_of_several(line, part));
        return;
    }
    for (std::uint8_t const each : units_in(part)) {
        add_new(units, one_of_several(line, std::to_string(each)));
    }
}

/// Nobody is left for --device; and two of one name would have columns that nobody can tell apart.
void check_together(line_choices const& line, std::vector<named_unit> const& units)
{
    bool const has_file = std::ranges::any_of(units, [](named_unit const& each) { return each.names != nullptr; });
    if (not line.device.empty() and not has_file) {
        refuse_word("--device " + line.device +
                    ": a register file is of what is no drive, and each of these units is said to be one");
    }
    for (named_unit const& one : units) {
        for (named_unit const& other : units) {
            if (one.unit != other.unit and name_of(one) == name_of(other)) {
                refuse_word("'" + name_of(one) + "' is unit " + std::to_string(one.unit.byte()) + " and unit " +
                            std::to_string(other.unit.byte()) + ": columns of that name could be of both");
            }
        }
        if (not one.drive.empty()) {
            static_cast<void>(catalog_or_none(one.drive)); // refuses what is none
        }
    }
}

/// Behind which character a word says of which unit it is; a group begins with that mark.
constexpr char mark_of_unit = '@';

/// A word, and of which unit it is; of all where that is empty.
struct word_of_unit {
    std::string word;
    std::string unit;
};

std::vector<word_of_unit> parts_of(std::vector<std::string> const& words)
{
    std::vector<word_of_unit> parts;
    for (std::string const& word : words) {
        std::istringstream all{word + ','}; // an empty part is refused where the registers are looked for
        for (std::string part; std::getline(all, part, ',');) {
            std::size_t const at = part.find(mark_of_unit, 1);
            parts.push_back({part.substr(0, at), at == part.npos ? std::string{} : part.substr(at + 1)});
            if (at != part.npos and parts.back().unit.empty()) {
                refuse_word("'" + part + "': a unit is missing behind the @");
            }
        }
    }
    return parts;
}

bool is_of(named_unit const& unit, std::string const& word)
{
    return word == std::to_string(unit.unit.byte()) or word == name_of(unit);
}

} // namespace

std::vector<named_unit> units_asked(line_choices const& line)
{
    if (line.unit.find_first_of(",-") == std::string::npos or is_name(names_in(line), line.unit)) {
        return {unit_in(line)};
    }
    std::vector<named_unit> units;
    std::istringstream parts{line.unit + ','};
    for (std::string part; std::getline(parts, part, ',');) {
        if (part.empty()) {
            refuse_word("'" + line.unit + "' in --unit: a unit is missing at a comma; it looks like 3,7-9");
        }
        add_part(units, line, part);
    }
    if (units.empty()) {
        refuse_word("'" + line.unit + "' in --unit is no list of units: it looks like 3,7-9");
    }
    check_together(line, units);
    return units;
}

std::vector<named_unit> units_watched(line_choices const& line)
{
    if (line.is_unit_named or line.names.empty()) {
        return units_asked(line);
    }
    std::vector<named_unit> units;
    for (named_unit const& each : names_in(line)) {
        add_new(units, one_of_several(line, each.name));
    }
    check_together(line, units);
    return units;
}

std::string name_of(named_unit const& unit)
{
    return unit.name.empty() ? "unit" + std::to_string(unit.unit.byte()) : unit.name;
}

std::vector<std::string> words_for(named_unit const& unit, std::vector<std::string> const& words,
                                   std::vector<named_unit> const& units)
{
    std::vector<std::string> own;
    for (word_of_unit const& each : parts_of(words)) {
        if (each.unit.empty() or is_of(unit, each.unit)) {
            own.push_back(each.word);
        } else if (std::ranges::none_of(units, [&each](named_unit const& one) { return is_of(one, each.unit); })) {
            std::vector<std::string> names;
            std::ranges::transform(units, std::back_inserter(names),
                                   [](named_unit const& one) { return name_of(one); });
            refuse_word("'" + each.word + mark_of_unit + each.unit + "': '" + each.unit +
                        "' is none of the units that are asked" +
                        suggestion(each.unit, std::vector<std::string_view>{names.begin(), names.end()}));
        }
    }
    return own;
}

} // namespace tool
