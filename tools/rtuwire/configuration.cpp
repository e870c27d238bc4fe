// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
#include "configuration.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <iomanip>
#include <optional>
#include <sstream>
#include <string_view>
#include <vector>

#include "../support/platform.hpp"
#include "catalog/catalog.hpp"
#include "exit_status.hpp"
#include "files/regular_file.hpp"
#include "line/line_words.hpp"
#include "line/who_is_it.hpp"
#include "line_options.hpp"
#include "port/port_word.hpp"
#include "words/suggestion.hpp"

namespace tool {

namespace {

double number_in(std::string const& word, double lowest, double highest)
{
    char* end = nullptr;
    double const number = std::strtod(word.c_str(), &end);
    if (word.empty() or *end != '\0' or not(number >= lowest and number <= highest)) {
        std::ostringstream text;
        text << std::setprecision(10) << "'" << word << "' is no number from " << lowest << " to " << highest;
        refuse_word(text.str());
    }
    return number;
}

unsigned whole_in(std::string const& word, unsigned lowest, unsigned highest)
{
    double const number = number_in(word, lowest, highest);
    if (number != std::floor(number)) {
        refuse_word("'" + word + "' is no whole number");
    }
    return static_cast<unsigned>(number);
}

bool flag_in(std::string const& word)
{
    if (word != "true" and word != "false") {
        refuse_word("it is true or false");
    }
    return word == "true";
}

std::string drive_in(std::string const& word)
{
    if (word != no_drive and catalog_named(word) == nullptr) {
        std::vector<std::string_view> names;
        for (drive_catalog const* const each : all_catalogs()) {
            names.push_back(each->name);
        }
        refuse_word("'" + word + "' is no drive" + suggestion(word, names));
    }
    return word;
}

std::string port_in(std::string const& word)
{
    if (port_choice const which = read_port_word(word); which.refused) {
        refuse_word(which.refused->sentence);
    }
    return word;
}

/// One that can stand in the file.
struct option {
    std::string_view name;
    void (*take)(line_choices& line, std::string const& word);
};

constexpr option options[] = {
    {"port", [](line_choices& line, std::string const& word) { line.port = port_in(word); }},
    {"unit",
     [](line_choices& line, std::string const& word) {
         line.unit = word;
         line.is_unit_named = true;
     }},
    {"baud",
     [](line_choices& line, std::string const& word) {
         line.baud = baud_in(whole_in(word, 1, 10'000'000));
         line.is_rate_named = true;
     }},
    {"format",
     [](line_choices& line, std::string const& word) {
         static_cast<void>(format_in(word));
         line.format = word;
         line.is_rate_named = true;
     }},
    {"drive", [](line_choices& line, std::string const& word) { line.drive = drive_in(word); }},
    {"name",
     [](line_choices& line, std::string const& word) {
         line.names.push_back(word);
         auto const named = names_in(line);
         if (std::string const& type = named.back().drive; not type.empty() and not is_register_file(type)) {
             static_cast<void>(drive_in(type));
         }
     }},
    {"timeout",
     [](line_choices& line, std::string const& word) { line.response_timeout = number_in(word, 0.001, 30); }},
    {"retries", [](line_choices& line, std::string const& word) { line.retries = whole_in(word, 0, 10); }},
    {"pause", [](line_choices& line, std::string const& word) { line.pause = whole_in(word, 0, 3'000); }},
    {"echo", [](line_choices& line, std::string const& word) { line.has_echo = flag_in(word); }},
    {"rs485", [](line_choices& line, std::string const& word) { line.must_switch_rs485 = flag_in(word); }},
    {"listen", [](line_choices& line, std::string const& word) { line.listen = number_in(word, 0, 3'600); }},
};

/// A value as it would be typed; nothing of what no option takes.
std::optional<std::string> word_of(toml::node const& value)
{
    if (auto const* const text = value.as_string()) {
        return text->get();
    }
    if (auto const* const number = value.as_integer()) {
        return std::to_string(number->get());
    }
    if (auto const* const flag = value.as_boolean()) {
        return flag->get() ? "true" : "false";
    }
    std::array<char, 32> digits{};
    auto const* const amount = value.as_floating_point();
    return amount == nullptr ? std::nullopt
                             : std::optional<std::string>{
                                   {digits.data(), std::to_chars(digits.begin(), digits.end(), amount->get()).ptr}};
}

void take_word(std::string const& file, std::string const& text, option const& which, toml::node const& value,
               line_choices& line)
{
    std::string const key{which.name};
    std::optional<std::string> const word = word_of(value);
    if (not word) {
        refuse_at(file, value.source(), "'" + key + "' has one value: a text, a number, true or false");
    }
    if (word->empty()) {
        refuse_at(file, value.source(), key + " = \"\": the value is empty");
    }
    try {
        which.take(line, *word);
    } catch (ended const& why) {
        refuse_at(file, value.source(),
                  key + " = \"" + *word + "\": " + why.what() +
                      (value.is_floating_point() and std::isfinite(*value.value<double>()) // 8E1 is one to TOML
                           ? hint_at_text(text, value.source())
                           : std::string{}));
    }
}

void check_options(std::string const& file, toml::table const& all)
{
    for (std::string_view const each : {"write", "allow-run", "yes", "no-listen"}) {
        if (auto const found = all.find(each); found != all.end()) {
            refuse_at(file, found->first.source(),
                      "'" + std::string{each} + "' is typed with each command: no file allows it");
        }
    }
    std::vector<std::string_view> known;
    for (option const& each : options) {
        known.push_back(each.name);
    }
    check_keys(file, all, known, "option of this file");
}

/// Whatever is there: what is no file is refused when it is read.
bool is_there(std::string const& name)
{
    std::error_code ignored;
    return std::filesystem::exists(std::filesystem::symlink_status(name, ignored));
}

} // namespace

std::optional<std::string> configuration_file()
{
    constexpr char const* name = "rtuwire.toml";
    if (is_there(name)) {
        return name;
    }
    std::string const place = folder_of_user(user_folder::configuration);
    std::string const file = place + "/" + name;
    return not place.empty() and is_there(file) ? std::optional{file} : std::nullopt;
}

void read_line_options(std::string const& file, std::string const& text, toml::table const& from,
                       std::span<std::string_view const> names, line_choices& line)
{
    for (option const& which : options) {
        toml::node const* const value = from.get(which.name);
        if (value != nullptr and std::ranges::count(names, which.name) != 0) {
            take_word(file, text, which, *value, line);
        }
    }
}

void read_configuration(std::string const& file, line_choices& line)
{
    if (file.empty()) {
        refuse_word("--config: the name of a file is missing");
    }
    file_text const found = text_of_file(file);
    if (not found.failure.empty()) {
        refuse_word("--config " + file + ": " + found.failure);
    }
    toml::table const all = plain_toml_in(file, found.text);
    check_options(file, all);
    for (option const& which : options) {
        toml::node const* const value = all.get(which.name);
        toml::array const* const list = value == nullptr ? nullptr : value->as_array();
        if (list == nullptr or which.name != "name") {
            value == nullptr ? void() : take_word(file, found.text, which, *value, line);
            continue;
        }
        for (toml::node const& each : *list) {
            take_word(file, found.text, which, each, line);
        }
    }
}

} // namespace tool
