// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
#include "import/forms.hpp"

#include <algorithm>
#include <set>

#include "exit_status.hpp"

namespace tool {

void refuse_base(register_file_writer const& into, std::optional<std::int64_t> base)
{
    if (base) {
        refuse_word(into.file() + ": its addresses are those of the device, and have no --base");
    }
}

void lose_other_fields(register_file_writer& into, source_value const& from, std::string_view name,
                       std::span<std::string_view const> taken)
{
    for (auto const& [key, value] : from.fields) {
        if (value.kind == source_kind::none or std::ranges::count(taken, key) != 0) {
            continue;
        }
        std::string const what = value.tag.empty() ? "" : " (" + value.tag + ')';
        std::string const said =
            value.is_plain() and value.text.size() < 60 and value.text.find('\n') == value.text.npos
                ? " = " + value.text
                : std::string{};
        into.lose(value.place, std::string{name} + ": " + key + said + what + " is not carried over");
    }
}

bool has_names_twice(register_file_writer& into, source_value const& from)
{
    std::set<std::string_view> names;
    bool is_right = true;
    for (auto const& [key, value] : from.fields) {
        if (from.kind == source_kind::table and not names.insert(key).second) {
            into.lose(value.place, from.text_of("name") + ": " + key + " stands here a second time");
            is_right = false;
        }
    }
    return not is_right;
}

std::optional<std::int64_t> whole_field(register_file_writer& into, source_value const& from, std::string_view key)
{
    source_value const* const value = from.find(key);
    auto const number = value == nullptr ? std::nullopt : value->whole_number();
    if (value != nullptr and not number) {
        into.lose(value->place,
                  std::string{key} + " is no whole number: " + (value->tag.empty() ? value->text : value->tag));
    }
    return number;
}

std::optional<double> number_field(register_file_writer& into, source_value const& from, std::string_view key)
{
    source_value const* const value = from.find(key);
    auto const number = value == nullptr ? std::nullopt : value->number();
    if (value != nullptr and not number) {
        into.lose(value->place, std::string{key} + " is no number: " + (value->tag.empty() ? value->text : value->tag));
    }
    return number;
}

double number_or_raw(source_value const& from, std::string_view key, double otherwise, written_register& one)
{
    source_value const* const value = from.find(key);
    auto const number = value == nullptr ? std::optional{otherwise} : value->number();
    if (not number) {
        one.not_the_value =
            "its " + std::string{key} + " is no number: " + (value->tag.empty() ? value->text : value->tag);
    }
    return number.value_or(otherwise);
}

std::int64_t whole_or_raw(source_value const& from, std::string_view key, std::int64_t otherwise, written_register& one)
{
    source_value const* const value = from.find(key);
    auto const number = value == nullptr ? std::optional{otherwise} : value->whole_number();
    if (not number) {
        one.not_the_value =
            "its " + std::string{key} + " is no whole number: " + (value->tag.empty() ? value->text : value->tag);
    }
    return number.value_or(otherwise);
}

void read_invalid(register_file_writer& into, source_value const& from, std::string_view key, written_register& one)
{
    auto const number = whole_field(into, from, key);
    if (not number) {
        return;
    }
    unsigned const width = one.type.ends_with("64") ? 64U : one.type.ends_with("32") ? 32U : 16U;
    std::uint64_t const all = width >= 64 ? ~std::uint64_t{0} : (std::uint64_t{1} << width) - 1;
    std::uint64_t const bits = static_cast<std::uint64_t>(*number) & all;
    bool const fits = width >= 64 or (*number < 0 ? *number >= -(std::int64_t{1} << (width - 1))
                                                  : static_cast<std::uint64_t>(*number) == bits);
    if (not fits) {
        into.lose(from.find(key)->place, one.name + ": " + std::string{key} + ' ' + from.text_of(key) +
                                             " is left out: it is beyond " + std::to_string(width) + " bits");
    } else if (std::ranges::count(one.invalid, bits) == 0) {
        one.invalid.push_back(bits);
    }
}

} // namespace tool
