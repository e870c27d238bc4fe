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

std::string text_of(json const& value)
{
    return plain_json(value.dump(-1, ' ', false, json::error_handler_t::replace));
}

/// One line. A number stands with the digits of its step, which no floating point number keeps.
std::string json_line(backup_row const& of)
{
    std::string line = "{\"group\":" + text_of(of.group) + ",\"address\":" + std::to_string(of.address) +
                       ",\"register\":" + text_of(of.code);
    auto const add = [&line](char const* name, std::string const& text, bool is_number) {
        if (not text.empty()) {
            line += ",\"" + std::string{name} + "\":" + (is_number ? text : text_of(text));
        }
    };
    add("menu", of.menu, false);
    add("raw", of.raw, of.is_raw_number);
    add("error", of.error, false);
    add("value", of.value.text, of.value.is_number);
    add("unit", of.value.unit, false);
    add("name", of.name, false);
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

std::string json_text_of(backup_rows const& all)
{
    std::string text = "{\n";
    for (auto const& [name, value] : all.head) {
        text += text_of(name) + ": " + text_of(value) + ",\n";
    }
    text += "\"rows\": \"" + std::to_string(all.rows.size()) + "\",\n";
    text += "\"parameters\": [";
    char const* separator = "\n";
    for (backup_row const& each : all.rows) {
        text += separator + json_line(each);
        separator = ",\n";
    }
    return text + "\n]}\n";
}

std::string csv_text_of(backup_rows const& all)
{
    std::string text = csv_line({"group", "address", "register", "menu", "raw", "value", "unit", "name", "error"});
    for (auto const& [name, value] : all.head) {
        text += csv_line({"backup", "", name, "", "", value, "", "", ""});
    }
    text += csv_line({"backup", "", "rows", "", "", std::to_string(all.rows.size()), "", "", ""});
    for (backup_row const& each : all.rows) {
        text += csv_line({each.group, std::to_string(each.address), each.code, each.menu, each.raw, each.value.text,
                          each.value.unit, each.name, each.error});
    }
    return text;
}

backup_rows rows_of(saved_settings const& settings)
{
    backup_rows all{settings.head, {}};
    for (saved_parameter const& each : settings.parameters) {
        register_entry const& entry = *each.entry;
        saved_value value =
            each.word ? value_to_save(entry, *settings.drive, *each.word, settings.word_of(entry.steps_set_by))
                      : saved_value{};
        all.rows.push_back({std::string{entry.group}, entry.address, std::string{entry.code}, std::string{entry.menu},
                            each.word ? std::to_string(*each.word) : std::string{}, true, std::move(value),
                            std::string{entry.name}, each.error});
    }
    std::ranges::stable_sort(all.rows, {}, [](backup_row const& each) { return std::tuple{each.group, each.address}; });
    return all;
}

} // namespace tool
