// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
#include "configuration.hpp"

#include <cstdlib>
#include <filesystem>
#include <optional>
#include <set>
#include <sstream>
#include <string_view>
#include <vector>

#include "catalog/catalog.hpp"
#include "exit_status.hpp"
#include "files/regular_file.hpp"
#include "line/line_words.hpp"
#include "line/who_is_it.hpp"
#include "port/port_word.hpp"
#include "words/suggestion.hpp"

namespace tool {

namespace {

/// "baud = 19200", and where it stands.
struct entry {
    std::string key;
    std::vector<std::string> values;
    unsigned line;
};

/// The entries of a file, one by one.
class entries {
public:
    entries(std::string file, std::string text) : file_{std::move(file)}, text_{std::move(text)} {}

    std::optional<entry> next()
    {
        skip(" \t\r\n");
        if (at_ == text_.size()) {
            return std::nullopt;
        }
        line_of_entry_ = line_;
        entry found{word(), {}, line_};
        skip(" \t");
        if (found.key.empty() or now() != '=') {
            refuse("'" + rest_of_line() + "' is no line such as baud = 19200");
        }
        ++at_;
        skip(" \t");
        found.values = now() == '[' ? list() : std::vector<std::string>{value()};
        skip(" \t\r");
        if (at_ < text_.size() and now() != '\n') {
            refuse("'" + rest_of_line() + "' stands behind the value of " + found.key);
        }
        return found;
    }

    /// At the line of the last entry, or of what is wrong inside it.
    [[noreturn]] void refuse(std::string const& why) const
    {
        refuse_word(file_ + ":" + std::to_string(line_) + ": " + why);
    }
    [[noreturn]] void refuse(entry const& which, std::string const& why) const
    {
        refuse_word(file_ + ":" + std::to_string(which.line) + ": " + why);
    }

private:
    char now() const { return at_ < text_.size() ? text_[at_] : '\n'; }

    /// Such characters, and comments.
    void skip(std::string_view blank)
    {
        while (at_ < text_.size() and (blank.find(now()) != std::string_view::npos or now() == '#')) {
            if (now() == '#') {
                at_ = std::min(text_.find('\n', at_), text_.size());
                continue;
            }
            line_ += now() == '\n' ? 1U : 0U;
            ++at_;
        }
    }

    std::string rest_of_line() const
    {
        std::string rest = text_.substr(at_, text_.find_first_of("\r\n", at_) - at_);
        return line_of_entry_ == line_ ? rest : rest.substr(0, 40);
    }

    std::string word()
    {
        std::size_t const end = text_.find_first_of(" \t\r\n=#,[]\"'", at_);
        std::string const found = text_.substr(at_, end - at_);
        at_ += found.size();
        return found;
    }

    std::string value()
    {
        char const mark = now();
        if (mark != '"' and mark != '\'') {
            std::string const plain = word();
            if (plain.empty()) {
                refuse("a value is missing");
            }
            bool const is_number = plain.find_first_not_of("0123456789.") == std::string::npos;
            if (not is_number and plain != "true" and plain != "false") {
                refuse("'" + plain + "' is a text: write it as \"" + plain + "\"");
            }
            return plain;
        }
        std::size_t const end = text_.find_first_of(std::string{mark} + "\n", at_ + 1);
        if (end == std::string::npos or text_[end] == '\n') {
            refuse("the text " + rest_of_line() + " does not end on its line");
        }
        std::string const found = text_.substr(at_ + 1, end - at_ - 1);
        at_ = end + 1;
        return found;
    }

    std::vector<std::string> list()
    {
        std::vector<std::string> found;
        ++at_;
        for (skip(" \t\r\n"); now() != ']'; skip(" \t\r\n")) {
            if (at_ == text_.size()) {
                refuse("a list has no ]");
            }
            found.push_back(value());
            skip(" \t\r\n");
            if (now() == ',') {
                ++at_;
            } else if (now() != ']') {
                refuse("'" + rest_of_line() + "' stands where a , or ] has to be");
            }
        }
        ++at_;
        return found;
    }

    std::string file_;
    std::string text_;
    std::size_t at_{0};
    unsigned line_{1};
    unsigned line_of_entry_{1};
};

double number_in(std::string const& word, double lowest, double highest)
{
    char* end = nullptr;
    double const number = std::strtod(word.c_str(), &end);
    if (word.empty() or *end != '\0' or not(number >= lowest and number <= highest)) {
        std::ostringstream text;
        text << "'" << word << "' is no number from " << lowest << " to " << highest;
        refuse_word(text.str());
    }
    return number;
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
         line.baud = baud_in(static_cast<unsigned>(number_in(word, 1, 10'000'000)));
     }},
    {"format",
     [](line_choices& line, std::string const& word) {
         static_cast<void>(format_in(word));
         line.format = word;
     }},
    {"drive", [](line_choices& line, std::string const& word) { line.drive = drive_in(word); }},
    {"name",
     [](line_choices& line, std::string const& word) {
         line.names.push_back(word);
         if (auto const named = names_in(line); not named.back().drive.empty()) {
             static_cast<void>(drive_in(named.back().drive));
         }
     }},
    {"timeout",
     [](line_choices& line, std::string const& word) { line.response_timeout = number_in(word, 0.001, 30); }},
    {"retries",
     [](line_choices& line, std::string const& word) { line.retries = static_cast<unsigned>(number_in(word, 0, 10)); }},
    {"pause", [](line_choices& line,
                 std::string const& word) { line.pause = static_cast<unsigned>(number_in(word, 0, 3'000)); }},
    {"echo",
     [](line_choices& line, std::string const& word) {
         if (word != "true" and word != "false") {
             refuse_word("it is true or false");
         }
         line.has_echo = word == "true";
     }},
    {"listen", [](line_choices& line, std::string const& word) { line.listen = number_in(word, 0, 3'600); }},
};

option const& option_of(entries const& from, entry const& one)
{
    std::vector<std::string_view> known;
    for (option const& each : options) {
        if (each.name == one.key) {
            return each;
        }
        known.push_back(each.name);
    }
    for (std::string_view const each : {"write", "allow-run", "yes", "no-listen"}) {
        if (each == one.key) {
            from.refuse(one, "'" + one.key + "' is typed with each command: no file allows it");
        }
    }
    from.refuse(one, "'" + one.key + "' is no option of this file" + suggestion(one.key, known));
}

void take(entries const& from, entry const& one, line_choices& line)
{
    option const& which = option_of(from, one);
    if (one.key != "name" and one.values.size() != 1) {
        from.refuse(one, "'" + one.key + "' has one value");
    }
    for (std::string const& word : one.values) {
        if (word.empty()) {
            from.refuse(one, one.key + " = \"\": the value is empty");
        }
        try {
            which.take(line, word);
        } catch (ended const& why) {
            from.refuse(one, one.key + " = \"" + word + "\": " + why.what());
        }
    }
}

/// Whatever is there: what is no file is refused when it is read.
bool is_there(std::string const& name)
{
    std::error_code ignored;
    return std::filesystem::exists(std::filesystem::symlink_status(name, ignored));
}

std::string variable(char const* name)
{
    char const* const value = std::getenv(name);
    return value == nullptr ? std::string{} : std::string{value};
}

} // namespace

std::optional<std::string> configuration_file()
{
    constexpr char const* name = "rtuwire.toml";
    if (is_there(name)) {
        return name;
    }
    std::string place = variable("XDG_CONFIG_HOME");
    if (place.empty() and not variable("HOME").empty()) {
        place = variable("HOME") + "/.config";
    }
    std::string const file = place + "/" + name;
    return not place.empty() and is_there(file) ? std::optional{file} : std::nullopt;
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
    constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF"; // as some editors write it
    bool const has_mark = found.text.starts_with(byte_order_mark);
    entries all{file, found.text.substr(has_mark ? byte_order_mark.size() : 0)};
    std::set<std::string> seen;
    while (auto const one = all.next()) {
        if (not seen.insert(one->key).second) {
            all.refuse(*one, "'" + one->key + "' stands here a second time");
        }
        take(all, *one, line);
    }
}

} // namespace tool
