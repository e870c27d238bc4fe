// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
#include <array>
#include <charconv>

#include "files/toml_file.hpp"
#include "import/source_value.hpp"

namespace tool {

namespace {

text_place place_of(toml::source_region const& where) { return {where.begin.line, where.begin.column}; }

std::string text_of_number(double number)
{
    std::array<char, 40> text{};
    auto const end = std::to_chars(text.data(), text.data() + text.size(), number).ptr;
    return {text.data(), end};
}

/// Not deeper than the parser goes.
void add_toml(source_builder& built, toml::node const& from)
{
    if (toml::table const* const table = from.as_table()) {
        built.begin(source_kind::table, place_of(from.source()));
        for (auto const& [key, value] : *table) {
            built.name(std::string{key.str()});
            add_toml(built, value);
        }
        built.end();
        return;
    }
    if (toml::array const* const list = from.as_array()) {
        built.begin(source_kind::list, place_of(from.source()));
        for (toml::node const& each : *list) {
            add_toml(built, each);
        }
        built.end();
        return;
    }
    source_value value;
    value.place = place_of(from.source());
    if (from.is_string()) {
        value.kind = source_kind::text;
        value.text = from.as_string()->get();
    } else if (from.is_boolean()) {
        value.kind = source_kind::truth;
        value.text = from.as_boolean()->get() ? "true" : "false";
    } else if (from.is_integer()) {
        value.kind = source_kind::number;
        value.text = std::to_string(from.as_integer()->get());
    } else if (from.is_floating_point()) {
        value.kind = source_kind::number;
        value.text = text_of_number(from.as_floating_point()->get());
    }
    built.add(std::move(value));
}

} // namespace

source_value toml_source(std::string const& file, std::string const& text)
{
    source_builder built{file};
    add_toml(built, toml_in(file, text));
    return built.take();
}

} // namespace tool
