// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
#include "line/line_words.hpp"

#include <algorithm>
#include <charconv>
#include <iterator>
#include <optional>
#include <set>
#include <string_view>
#include <utility>

#include <rtuwire/port.hpp>

#include "catalog/catalog.hpp"
#include "device/device_folders.hpp"
#include "device/register_file.hpp"
#include "exit_status.hpp"
#include "words/suggestion.hpp"
#include "words/words.hpp"

namespace tool {

namespace {

std::optional<unsigned> number_in(std::string_view word)
{
    unsigned number = 0;
    auto const [end, wrong] = std::from_chars(word.data(), word.data() + word.size(), number);
    bool const is_whole = wrong == std::errc{} and end == word.data() + word.size();
    return is_whole ? std::optional{number} : std::nullopt;
}

/// What is asked only where somebody says that whatever answers is meant: a reserved address, and that of all.
std::optional<unit_address> any_unit_at(unsigned number)
{
    if (number == 0) {
        return unit_address::zero();
    }
    auto const reserved = rtuwire::unit_id::checked_reserved(number);
    return reserved ? std::optional{unit_address{*reserved}} : std::nullopt;
}

/// `advice` stands behind a refusal.
rtuwire::unit_id address_in(std::string_view word, std::string const& of, std::string const& advice = {})
{
    auto const number = number_in(word);
    auto const unit = number ? rtuwire::unit_id::checked(*number) : rtuwire::errc::malformed;
    if (not unit) {
        refuse_word("'" + std::string{word} + "' in '" + of + "' is no address of a unit: 1 to 247" + advice);
    }
    return *unit;
}

/// "fan=7:atv320", "fan=7".
named_unit named_in(std::string const& word)
{
    std::size_t const sign = word.find('=');
    if (sign == 0 or sign == std::string::npos) {
        refuse_word("'" + word + "' names no unit: it looks like fan=7:atv320");
    }
    if (word.find_first_of("0123456789+-") == 0 or word.find(',') < sign) {
        refuse_word("'" + word + "': a name begins with no digit or sign and has no comma, so that --unit 3 is unit 3");
    }
    std::size_t const colon = word.find(':', sign);
    return {address_in(std::string_view{word}.substr(sign + 1, colon - sign - 1), word), word.substr(0, sign),
            colon == word.npos ? std::string{} : word.substr(colon + 1)};
}

/// One name means one unit, and a unit has one type: neither the first nor the last is silently right.
void refuse_contradiction(named_unit const& before, named_unit const& one)
{
    std::string const units[]{std::to_string(before.unit.byte()), std::to_string(one.unit.byte())};
    if (before.name == one.name) {
        refuse_word("the name '" + one.name + "' is given twice, to unit " + units[0] + " and to unit " + units[1]);
    }
    if (is_same_word(before.name, one.name)) {
        refuse_word("the names '" + before.name + "' of unit " + units[0] + " and '" + one.name + "' of unit " +
                    units[1] + " differ in nothing but capital letters");
    }
    bool const has_two_types = not before.drive.empty() and not one.drive.empty() and before.drive != one.drive;
    if (before.unit == one.unit and has_two_types) {
        refuse_word("unit " + units[1] + " has two types: " + before.name + " is an " + before.drive + ", " + one.name +
                    " an " + one.drive);
    }
}

} // namespace

rtuwire::character_format format_in(std::string const& word)
{
    std::string known;
    for (named_format const& each : all_formats) {
        if (word == each.name) {
            return each.format;
        }
        known += (known.empty() ? "" : &each == std::end(all_formats) - 1 ? " and " : ", ") + std::string{each.name};
    }
    refuse_word("'" + word + "' is no format: there are " + known);
}

std::string name_of_format(rtuwire::character_format format)
{
    return std::string{std::ranges::find(all_formats, format, &named_format::format)->name};
}

std::uint32_t baud_in(unsigned number)
{
    if (not rtuwire::is_bit_rate(number)) {
        refuse_word(std::to_string(number) + " bits a second: this system has no such bit rate");
    }
    return number;
}

std::vector<std::uint8_t> units_in(std::string const& word)
{
    std::set<std::uint8_t> units;
    for (std::string_view const part : parts_of(word, ",")) {
        auto const ends = parts_of(part, "-");
        bool const is_range = ends.size() <= 2 and std::ranges::none_of(ends, &std::string_view::empty);
        unsigned const first = is_range ? address_in(ends[0], word).byte() : 1;
        unsigned const last = is_range ? address_in(ends.back(), word).byte() : 0;
        if (last < first) {
            refuse_word("'" + std::string{part} + "' in '" + word +
                        "' is neither an address of a unit, 1 to 247, nor a range of them, such as 1-247");
        }
        for (unsigned each = first; each <= last; ++each) {
            units.insert(static_cast<std::uint8_t>(each));
        }
    }
    return {units.begin(), units.end()};
}

bool is_register_file(std::string_view type)
{
    bool const is_drive = type.empty() or type == "none" or catalog_named(type) != nullptr;
    return type.ends_with(".toml") or (not is_drive and device_file_named(std::string{type}).has_value());
}

std::vector<named_unit> names_in(line_choices const& line)
{
    std::vector<named_unit> named;
    for (std::string const& each : line.names) {
        named_unit one = named_in(each);
        for (named_unit const& before : named) {
            refuse_contradiction(before, one);
        }
        named.push_back(std::move(one));
    }
    return named;
}

named_unit unit_in(line_choices const& line)
{
    std::vector<named_unit> const named = names_in(line);
    std::vector<std::string_view> known;
    std::optional<named_unit> found;
    auto const number = number_in(line.unit);
    for (named_unit const& each : named) {
        known.push_back(each.name);
        if (each.name == line.unit or (number and each.unit.byte() == *number)) {
            found = each;
        }
    }
    if (not found and not number) {
        refuse_word("'" + line.unit + "' is neither an address nor a name given by --name" +
                    suggestion(line.unit, known));
    }
    auto const any = number ? any_unit_at(*number) : std::nullopt;
    std::string const advice = any ? "; read, watch and identify take 0 and 248 to 255 with --any-unit" : "";
    named_unit chosen = found                          ? *found
                        : any and line.may_be_any_unit ? named_unit{*any}
                                                       : named_unit{address_in(line.unit, "--unit", advice)};
    std::string const of_name = is_register_file(chosen.drive) ? std::exchange(chosen.drive, {}) : std::string{};
    std::string const file = line.device.empty() ? of_name : line.device;
    chosen.drive = line.drive.empty() ? chosen.drive : line.drive;
    if (file.empty()) {
        return chosen;
    }
    bool const is_drive = not chosen.drive.empty() and chosen.drive != "none";
    if (is_drive and line.knows_registers) {
        refuse_word((line.device.empty() ? "--name " + chosen.name + '=' + std::to_string(chosen.unit.byte()) + ':'
                                         : std::string{"--device "}) +
                    file + ": a register file is of what is no drive, and this unit is said to be an " + chosen.drive);
    }
    chosen.drive = is_drive ? chosen.drive : "none";
    chosen.names = line.knows_registers ? &register_file_at(file) : nullptr;
    return chosen;
}

named_unit unit_to_change(choices const& chosen)
{
    if (not chosen.line.is_unit_named) {
        refuse_word("which unit? '" + chosen.command +
                    "' changes something, and takes no unit by itself: say --unit 7, or unit = 7 in the configuration");
    }
    return unit_in(chosen.line);
}

std::string shown_command(line_choices const& line, std::string_view words)
{
    typed_line const& typed = line.typed;
    return typed.program + typed.options + typed.rate + typed.unit + typed.drive + ' ' + std::string{words};
}

std::string shown_command(line_choices const& line, unit_address unit, std::string_view words)
{
    line_choices of_unit = line;
    of_unit.typed.unit = " -u " + std::to_string(unit.byte());
    of_unit.typed.drive.clear(); // is that of the unit that was named
    return shown_command(of_unit, words);
}

std::string way_to_stop(line_choices const& line)
{
    return '`' + shown_command(line, line.typed.stop) + "` stops it, and says so, where the drive hears that";
}

rtuwire::duration seconds_in(double seconds)
{
    return rtuwire::microseconds(static_cast<std::uint32_t>(seconds * 1'000'000.0));
}

} // namespace tool
