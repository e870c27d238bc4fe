// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
#include "files/toml_file.hpp"

#include <algorithm>
#include <optional>

#include "exit_status.hpp"
#include "files/text_place.hpp"
#include "output/plain_text.hpp"
#include "words/suggestion.hpp"

namespace tool {

namespace {

std::string_view trimmed(std::string_view text)
{
    constexpr std::string_view blank = " \t\r";
    std::size_t const first = std::min(text.find_first_not_of(blank), text.size());
    return text.substr(first, text.find_last_not_of(blank) + 1 - first);
}

/// Nothing where the parser asserts what does not hold.
std::optional<toml::parse_result> parsed_or_nothing(std::string_view text, std::string const& file)
{
    try {
        return toml::parse(text, std::string_view{file});
    } catch (toml_assertion const&) {
        return std::nullopt;
    }
}

/// The line at whose end the parser asserts: none before it makes it do so.
toml::source_index line_of_assertion(std::string_view text, std::string const& file)
{
    std::vector<std::size_t> ends;
    for (std::size_t at = text.find('\n'); at != text.npos; at = text.find('\n', at + 1)) {
        ends.push_back(at + 1);
    }
    auto const first = std::ranges::partition_point(
        ends, [&](std::size_t end) { return parsed_or_nothing(text.substr(0, end), file).has_value(); });
    return static_cast<toml::source_index>(first - ends.begin() + 1);
}

void refuse_if_not_plain(std::string const& file, toml::source_region const& where, std::string_view word)
{
    if (std::string const shown = plain_text(word); shown != word) {
        refuse_at(file, where, "'" + shown + "' has a control character, which nothing in this file may: leave it out");
    }
}

void refuse_control_characters(std::string const& file, toml::node const& value)
{
    if (auto const* const text = value.as_string()) {
        refuse_if_not_plain(file, value.source(), text->get());
    } else if (auto const* const list = value.as_array()) {
        for (toml::node const& each : *list) {
            refuse_control_characters(file, each);
        }
    } else if (auto const* const table = value.as_table()) {
        for (auto const& [key, each] : *table) {
            refuse_if_not_plain(file, key.source(), key.str());
            refuse_control_characters(file, each);
        }
    }
}

constexpr std::size_t most_key_parts = 32;

/// The end of a text of TOML that begins at `from`, in its quotation marks.
std::size_t end_of_text(std::string_view text, std::size_t from)
{
    char const mark = text[from];
    std::string const three(3, mark);
    bool const is_long = text.substr(from).starts_with(three);
    std::size_t at = from + (is_long ? 3 : 1);
    while (at < text.size()) {
        if (mark == '"' and text[at] == '\\') {
            at += 2;
        } else if (is_long ? text.substr(at).starts_with(three) : text[at] == mark) {
            at += is_long ? 3 : 1;
            for (int more = 0; is_long and more < 2 and at < text.size() and text[at] == mark; ++more) {
                ++at; // one or two marks before the three that end it
            }
            return at;
        } else if (not is_long and text[at] == '\n') {
            return at;
        } else {
            ++at;
        }
    }
    return text.size();
}

/// The parser builds a table in a table of each part of a key, and takes them apart by calls within calls.
void refuse_long_keys(std::string const& file, std::string_view text)
{
    std::size_t parts = 1;
    for (std::size_t at = 0; at < text.size();) {
        char const c = text[at];
        if (c == '"' or c == '\'') {
            at = end_of_text(text, at);
            continue;
        }
        if (c == '#') {
            at = std::min(text.find('\n', at), text.size());
            continue;
        }
        parts = c == '.' ? parts + 1 : std::string_view{"=,[]{}\n"}.find(c) != std::string_view::npos ? 1 : parts;
        if (parts > most_key_parts) {
            refuse_word(told_place(file, place_counter{text}.of(at)) + "a key of more than " +
                        std::to_string(most_key_parts) + " parts");
        }
        ++at;
    }
}

} // namespace

void refuse_at(std::string const& file, toml::source_region const& where, std::string const& why)
{
    refuse_word(file + ':' + std::to_string(where.begin.line) + ':' + std::to_string(where.begin.column) + ": " + why);
}

std::string hint_at_text(std::string_view text, toml::source_region const& where)
{
    for (auto each = where.begin.line; each > 1; --each) {
        text.remove_prefix(std::min(text.find('\n'), text.size() - 1) + 1);
    }
    text = text.substr(0, text.find('\n'));
    std::size_t const sign = text.find('=');
    std::string_view const value = sign == text.npos ? std::string_view{} : trimmed(text.substr(sign + 1));
    if (value.starts_with('"') and std::ranges::count(value, '"') == 1) {
        return "; the text does not end on its line";
    }
    std::string_view const word = trimmed(value.substr(0, value.find('#')));
    bool const may_be_text = not word.empty() and word.find_first_of("\"'[]{}") == word.npos and
                             word.find_first_not_of("0123456789.+-_") != word.npos;
    return may_be_text ? "; a text is written in quotation marks: \"" + std::string{word} + '"' : std::string{};
}

toml::table toml_in(std::string const& file, std::string const& text)
{
    if (text.size() > longest_toml) {
        refuse_word(file + ": " + std::to_string(text.size()) + " bytes; such a file has at most " +
                    std::to_string(longest_toml));
    }
    if (text.find('\0') != text.npos) {
        refuse_word(file + ": a byte is zero: it is no text");
    }
    refuse_long_keys(file, text);
    auto parsed = parsed_or_nothing(text, file);
    if (not parsed) {
        toml::source_position const where{line_of_assertion(text, file), 1};
        refuse_at(file, {where, where, nullptr}, "this line is no TOML; a table's header has a name: [name]");
    }
    if (not *parsed) {
        toml::source_region const& where = parsed->error().source();
        refuse_at(file, where, std::string{parsed->error().description()} + hint_at_text(text, where));
    }
    return std::move(*parsed).table();
}

toml::table plain_toml_in(std::string const& file, std::string const& text)
{
    toml::table all = toml_in(file, text);
    refuse_control_characters(file, all);
    return all;
}

void check_keys(std::string const& file, toml::table const& from, std::vector<std::string_view> const& known,
                std::string_view what)
{
    for (auto const& [key, value] : from) {
        if (std::ranges::count(known, key.str()) == 0) {
            refuse_at(file, key.source(),
                      "'" + std::string{key.str()} + "' is no " + std::string{what} + suggestion(key.str(), known));
        }
    }
}

} // namespace tool
