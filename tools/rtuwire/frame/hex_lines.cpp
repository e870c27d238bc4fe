// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
#include "frame/hex_lines.hpp"

#include <algorithm>
#include <charconv>

#include "exit_status.hpp"

namespace tool {

namespace {

constexpr std::string_view between = " \t\r\n,;:\\[]<>(){}\"'|-";
constexpr std::string_view hex_digits = "0123456789abcdefABCDEF";

std::size_t number_in(std::string_view digits, int base)
{
    std::size_t value = 0;
    auto const [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value, base);
    return error == std::errc{} and end == digits.data() + digits.size() ? value : ~std::size_t{0};
}

/// Whether a text begins with words of two digits, as the bytes behind an offset do.
bool begins_with_byte(std::string_view text)
{
    std::size_t const first = text.find_first_not_of(" \t");
    if (first == text.npos) {
        return false;
    }
    std::string_view const word = text.substr(first, text.find_first_of(" \t\r", first) - first);
    return word.size() == 2 and word.find_first_not_of(hex_digits) == word.npos;
}

/// Takes so many digits from the front of a text; nothing where they are others, or a number outside of the limits.
bool take_number(std::string_view& text, std::size_t digits, std::size_t lowest, std::size_t highest)
{
    std::string_view const word = text.substr(0, digits);
    bool const is_number = word.size() == digits and word.find_first_not_of("0123456789") == word.npos;
    std::size_t const value = is_number ? number_in(word, 10) : 0;
    text.remove_prefix(is_number ? digits : 0);
    return is_number and value >= lowest and value <= highest;
}

bool take_one_of(std::string_view& text, std::string_view characters)
{
    bool const is_there = not text.empty() and characters.find(text[0]) != characters.npos;
    text.remove_prefix(is_there ? 1 : 0);
    return is_there;
}

/// "2026-11-25", "2026/11/25".
bool take_date(std::string_view& text)
{
    std::string_view rest = text;
    bool const is_date = take_number(rest, 4, 1970, 2099) and take_one_of(rest, "-/.") and
                         take_number(rest, 2, 1, 12) and take_one_of(rest, "-/.") and take_number(rest, 2, 1, 31);
    text = is_date ? rest : text;
    return is_date;
}

/// "07:03:01", "07:03:01.123", with a zone behind it: "Z", "+0100", "+01:00".
bool take_time(std::string_view& text)
{
    std::string_view rest = text;
    bool const is_time = take_number(rest, 2, 0, 23) and take_one_of(rest, ":") and take_number(rest, 2, 0, 59) and
                         take_one_of(rest, ":") and take_number(rest, 2, 0, 60);
    if (not is_time) {
        return false;
    }
    if (take_one_of(rest, ".,")) {
        rest.remove_prefix((std::min)(rest.find_first_not_of("0123456789"), rest.size()));
    }
    std::string_view zone = rest;
    if (take_one_of(zone, "Z")) {
        rest = zone;
    } else if (take_one_of(zone, "+-") and take_number(zone, 2, 0, 14)) {
        static_cast<void>(take_one_of(zone, ":"));
        rest = take_number(zone, 2, 0, 59) ? zone : rest;
    }
    text = rest;
    return true;
}

/// Where the bytes of a line begin, behind a date, a time or both; 0 where there is none. Bytes with colons between all
/// of them are no time.
std::size_t end_of_time(std::string_view line)
{
    std::string_view rest = line;
    rest.remove_prefix((std::min)(rest.find_first_not_of(" \t[("), rest.size()));
    bool const has_date = take_date(rest);
    std::string_view behind_date = rest;
    bool has_time = false;
    if (has_date ? take_one_of(behind_date, " T_") : true) {
        has_time = take_time(behind_date);
        rest = has_time ? behind_date : rest;
    }
    bool const ends = rest.empty() or take_one_of(rest, " \t])>");
    bool const has_bytes = rest.find_first_not_of(" \t\r") != rest.npos;
    bool const is_time_alone = has_time and has_bytes and rest.find(':') == rest.npos;
    return ends and (has_date or is_time_alone) ? line.size() - rest.size() : 0;
}

} // namespace

/// Where the bytes of a line are, and whether they go on with the run before.
struct hex_lines::line_start {
    std::size_t first{0};
    std::size_t end{std::string_view::npos};
    bool goes_on{false};
};

hex_lines::line_start hex_lines::start_of(std::string_view line, std::size_t so_far) const
{
    std::size_t const begin = (std::min)(line.find_first_not_of(" \t"), line.size());
    std::size_t const end = (std::min)(line.find_first_not_of(hex_digits, begin), line.size());
    std::string_view const word = line.substr(begin, end - begin);
    std::string_view const rest = line.substr(end);
    bool const is_of_xxd = rest.starts_with(": ");
    std::size_t const value = number_in(word, 16);
    bool const goes_on = so_far > 0 and (value == so_far or (word.size() == 7 and number_in(word, 8) == so_far));
    if (word.size() < 4 or word.size() > 8) {
        return {};
    }
    if (goes_on and rest.find_first_not_of(" \t\r") == rest.npos) {
        return {line.size(), line.size(), true}; // the length, which ends a dump
    }
    bool const is_offset = is_of_xxd or (begins_with_byte(rest) and (goes_on or value == 0 or rest.starts_with("  ")));
    if (not is_offset) {
        return {};
    }
    std::size_t const first = line.find_first_not_of(": \t", end);
    std::size_t const text = line.find(is_of_xxd ? "  " : "   ", first);
    return {first, (std::min)(line.find_first_of("|>", first), text), goes_on};
}

void hex_lines::refuse(std::string_view word, std::size_t column, std::string const& why) const
{
    refuse_word("line " + std::to_string(number_) + ", character " + std::to_string(column + 1) + ": '" +
                std::string{word} + "' " + why);
}

void hex_lines::add_word(std::string_view word, std::size_t column, std::vector<std::byte>& run) const
{
    bool const has_mark = word.starts_with("0x") or word.starts_with("0X");
    bool const is_escape = column > 0 and line_[column - 1] == '\\' and word.starts_with('x');
    std::string_view const digits = word.substr(has_mark ? 2 : is_escape ? 1 : 0);
    if (digits.empty() or digits.find_first_not_of(hex_digits) != digits.npos) {
        refuse(word, column, "is no hexadecimal number");
    }
    if (digits.size() % 2 != 0 and digits.size() > 1) {
        refuse(word, column, "has " + std::to_string(digits.size()) + " digits: a byte has two");
    }
    for (std::size_t at = 0; at < digits.size(); at += 2) {
        run.push_back(static_cast<std::byte>(number_in(digits.substr(at, 2), 16)));
    }
}

void hex_lines::add_words(std::string_view line, std::size_t at, std::vector<std::byte>& run) const
{
    for (at = line.find_first_not_of(between, at); at != line.npos; at = line.find_first_not_of(between, at)) {
        std::size_t const end = (std::min)(line.find_first_of(between, at), line.size());
        add_word(line.substr(at, end - at), at, run);
        at = end;
    }
}

bool hex_lines::next(std::vector<std::byte>& run)
{
    run.clear();
    while (has_line_ or std::getline(from_, line_)) {
        number_ += has_line_ ? 0 : 1;
        has_line_ = false;
        if (std::size_t const end = end_of_time(line_); end > 0) {
            line_.replace(0, end, end, ' ');
        }
        line_start const start = start_of(line_, run.size());
        if (not run.empty() and not start.goes_on) {
            has_line_ = true; // belongs to the next run
            return true;
        }
        add_words(std::string_view{line_}.substr(0, start.end), start.first, run);
        bool const may_go_on = start.first != 0 and start.first < line_.size();
        if (not run.empty() and not may_go_on) {
            return true;
        }
    }
    return not run.empty();
}

} // namespace tool
