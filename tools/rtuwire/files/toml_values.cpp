// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
#include "files/toml_values.hpp"

#include <cmath>
#include <cstdint>

namespace tool {

namespace {

/// The last part of "line.serve".
std::string_view key_of(std::string_view name) { return name.substr(name.rfind('.') + 1); }

} // namespace

toml::table const* toml_values::table_in(toml::table const& from, std::string_view name) const
{
    toml::node const* const value = from.get(key_of(name));
    if (value != nullptr and not value->is_table()) {
        refuse(value->source(),
               std::string{key_of(name)} + " is a table: its keys stand in lines behind [" + std::string{name} + "]");
    }
    return value == nullptr ? nullptr : value->as_table();
}

toml::array const* toml_values::tables_in(toml::table const& from, std::string_view name, std::size_t most) const
{
    toml::node const* const list = from.get(key_of(name));
    if (list == nullptr) {
        return nullptr;
    }
    std::string const header = "[[" + std::string{name} + "]]";
    toml::array const* const tables = list->as_array();
    if (tables == nullptr or not tables->is_homogeneous<toml::table>() or tables->empty()) {
        refuse(list->source(), std::string{key_of(name)} + " are tables: each begins with " + header);
    }
    if (tables->size() > most) {
        refuse(list->source(), std::to_string(tables->size()) + " times " + header + "; at most " +
                                   std::to_string(most) + " are taken");
    }
    return tables;
}

std::optional<unsigned> toml_values::whole_in(toml::table const& from, std::string_view key, unsigned lowest,
                                              unsigned highest) const
{
    toml::node const* const value = from.get(key);
    if (value == nullptr) {
        return std::nullopt;
    }
    std::int64_t const number = value->is_integer() ? value->as_integer()->get() : -1;
    if (number < lowest or number > highest) {
        refuse(value->source(), std::string{key} + " is a whole number from " + std::to_string(lowest) + " to " +
                                    std::to_string(highest));
    }
    return static_cast<unsigned>(number);
}

bool toml_values::flag_in(toml::table const& from, std::string_view key) const
{
    toml::node const* const value = from.get(key);
    if (value != nullptr and not value->is_boolean()) {
        refuse(value->source(), std::string{key} + " is true or false");
    }
    return value != nullptr and value->as_boolean()->get();
}

std::optional<std::string> toml_values::text_in(toml::table const& from, std::string_view key) const
{
    toml::node const* const value = from.get(key);
    if (value == nullptr) {
        return std::nullopt;
    }
    if (not value->is_string()) {
        refuse(value->source(), std::string{key} + " is a text: write it in quotation marks");
    }
    return value->as_string()->get();
}

std::optional<double> toml_values::number_in(toml::table const& from, std::string_view key) const
{
    toml::node const* const value = from.get(key);
    if (value == nullptr) {
        return std::nullopt;
    }
    auto const number = value->is_number() ? value->value<double>() : std::nullopt;
    if (not number or not std::isfinite(*number)) {
        refuse(value->source(), std::string{key} + " is a number");
    }
    return number;
}

} // namespace tool
