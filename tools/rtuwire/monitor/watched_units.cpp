// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
#include "monitor/watched_units.hpp"

#include <algorithm>
#include <optional>
#include <sstream>

#include "line/asked_registers.hpp"
#include "line/who_is_it.hpp"

namespace tool {

namespace {

bool is_name(std::vector<named_unit> const& named, std::string const& word)
{
    return std::any_of(named.begin(), named.end(), [&](named_unit const& each) { return each.name == word; });
}

bool is_number_or_range(std::string const& word)
{
    return not word.empty() and word.find_first_not_of("0123456789-") == std::string::npos;
}

/// The units of one part of a list; an address that has a name keeps it.
std::vector<named_unit> units_of_part(line_choices line, std::string const& part)
{
    std::vector<named_unit> units;
    if (is_name(names_in(line), part) or not is_number_or_range(part)) {
        line.unit = part;
        units.push_back(unit_in(line));
        return units;
    }
    for (std::uint8_t const each : units_in(part)) {
        line.unit = std::to_string(each);
        units.push_back(unit_in(line));
    }
    return units;
}

void add_new(std::vector<named_unit>& units, named_unit const& one)
{
    bool const is_there =
        std::any_of(units.begin(), units.end(), [&](named_unit const& each) { return each.unit == one.unit; });
    if (not is_there) {
        units.push_back(one);
    }
}

} // namespace

std::vector<named_unit> units_watched(line_choices const& line)
{
    std::vector<named_unit> units;
    if (not line.is_unit_named and not line.names.empty()) {
        for (named_unit const& each : names_in(line)) {
            line_choices one = line;
            one.unit = each.name;
            add_new(units, unit_in(one));
        }
        return units;
    }
    std::istringstream parts{line.unit};
    for (std::string part; std::getline(parts, part, ',');) {
        for (named_unit const& each : units_of_part(line, part)) {
            add_new(units, each);
        }
    }
    if (units.empty()) {
        refuse_word("'" + line.unit + "' in --unit is no list of units: it looks like 3,7-9");
    }
    return units;
}

void check_register_words(std::vector<std::string> const& words, std::vector<named_unit> const& units)
{
    for (named_unit const& each : units) {
        if (not each.drive.empty()) {
            static_cast<void>(catalog_or_none(each.drive)); // refuses what is none
        }
    }
    for (std::string const& word : words) {
        std::string_view const one[]{word};
        std::optional<refusal> why = select_registers(one, {nullptr, units.front().names}).refused;
        for (drive_catalog const* const each : all_catalogs()) {
            if (why and units.front().names == nullptr) {
                why = select_registers(one, each).refused;
            }
        }
        if (why) {
            refuse(*why);
        }
    }
}

} // namespace tool
