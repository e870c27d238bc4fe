// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
#include "backup/backup_text.hpp"

#include <algorithm>
#include <tuple>

#include <nlohmann/json.hpp>

#include "output/plain_text.hpp"

namespace tool {

namespace {

using json = nlohmann::ordered_json;

/// By group and address, whatever order they were read in.
std::vector<saved_parameter const*> in_order(saved_settings const& settings)
{
    std::vector<saved_parameter const*> all;
    for (saved_parameter const& each : settings.parameters) {
        all.push_back(&each);
    }
    std::ranges::sort(all, {}, [](auto const* each) { return std::tuple{each->entry->group, each->entry->address}; });
    return all;
}

saved_value value_of(saved_parameter const& of, saved_settings const& in)
{
    return of.word ? value_to_save(*of.entry, *in.drive, *of.word, in.word_of(of.entry->steps_set_by)) : saved_value{};
}

std::string text_of(json const& value)
{
    return plain_json(value.dump(-1, ' ', false, json::error_handler_t::replace));
}

/// One line. A number stands with the digits of its step, which no floating point number keeps.
std::string json_line(saved_parameter const& of, saved_settings const& in)
{
    std::string line = "{\"group\":" + text_of(of.entry->group) + ",\"address\":" + std::to_string(of.entry->address) +
                       ",\"register\":" + text_of(of.entry->code);
    auto const add = [&line](char const* name, std::string const& text) {
        line += ",\"" + std::string{name} + "\":" + text;
    };
    if (not of.entry->menu.empty()) {
        add("menu", text_of(of.entry->menu));
    }
    saved_value const value = value_of(of, in);
    if (of.word) {
        add("raw", std::to_string(*of.word));
    } else {
        add("error", text_of(of.error));
    }
    if (not value.text.empty()) {
        add("value", value.is_number ? value.text : text_of(value.text));
    }
    if (not value.unit.empty()) {
        add("unit", text_of(value.unit));
    }
    add("name", text_of(of.entry->name));
    return line + "}";
}

std::string csv_field(std::string const& raw)
{
    std::string const text = plain_text(raw);
    if (text.find_first_of(",\"") == text.npos) {
        return text;
    }
    std::string quoted = "\"";
    for (char const each : text) {
        quoted += each == '"' ? "\"\"" : std::string{each};
    }
    return quoted + '"';
}

std::string csv_line(std::initializer_list<std::string> fields)
{
    std::string line;
    for (std::string const& each : fields) {
        line += (&each == fields.begin() ? "" : ",") + csv_field(each);
    }
    return line + "\r\n";
}

} // namespace

std::string json_text_of(saved_settings const& settings)
{
    std::string text = "{\n";
    for (auto const& [name, value] : settings.head) {
        text += text_of(name) + ": " + text_of(value) + ",\n";
    }
    text += "\"rows\": \"" + std::to_string(settings.parameters.size()) + "\",\n";
    text += "\"parameters\": [";
    char const* separator = "\n";
    for (saved_parameter const* const each : in_order(settings)) {
        text += separator + json_line(*each, settings);
        separator = ",\n";
    }
    return text + "\n]}\n";
}

std::string csv_text_of(saved_settings const& settings)
{
    std::string text = csv_line({"group", "address", "register", "menu", "raw", "value", "unit", "name", "error"});
    for (auto const& [name, value] : settings.head) {
        text += csv_line({"backup", "", name, "", "", value, "", "", ""});
    }
    text += csv_line({"backup", "", "rows", "", "", std::to_string(settings.parameters.size()), "", "", ""});
    for (saved_parameter const* const each : in_order(settings)) {
        saved_value const value = value_of(*each, settings);
        text += csv_line({std::string{each->entry->group}, std::to_string(each->entry->address),
                          std::string{each->entry->code}, std::string{each->entry->menu},
                          each->word ? std::to_string(*each->word) : "", value.text, value.unit,
                          std::string{each->entry->name}, each->error});
    }
    return text;
}

} // namespace tool
