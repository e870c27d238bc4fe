// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
#include "files/toml_file.hpp"

#include <algorithm>
#include <optional>

#include "exit_status.hpp"
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
