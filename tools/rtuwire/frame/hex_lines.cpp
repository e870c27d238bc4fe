// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
#include "frame/hex_lines.hpp"

#include <algorithm>
#include <charconv>

#include "exit_status.hpp"

namespace tool {

namespace {

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

bool is_alphanumeric(char each)
{
    return (each >= '0' and each <= '9') or (each >= 'a' and each <= 'z') or (each >= 'A' and each <= 'Z');
}

/// "25.11.2026", "11/25/2026".
bool take_date_behind_day(std::string_view& text)
{
    std::string_view rest = text;
    bool const is_date = take_number(rest, 2, 1, 31) and take_one_of(rest, "-/.") and take_number(rest, 2, 1, 31) and
                         take_one_of(rest, "-/.") and take_number(rest, 4, 1970, 2099);
    text = is_date ? rest : text;
    return is_date;
}

/// "07:03:01:123" besides the times of `take_time`.
bool take_any_time(std::string_view& text)
{
    if (not take_time(text)) {
        return false;
    }
    std::string_view rest = text;
    if (take_one_of(rest, ":") and take_number(rest, 3, 0, 999)) {
        text = rest;
    }
    return true;
}

/// How long a date or a time at the front of a text is; 0 where there is none, or where it goes on as bytes would.
std::size_t size_of_time(std::string_view text)
{
    std::string_view rest = text;
    bool const is_date = take_date(rest) or take_date_behind_day(rest);
    if (is_date) {
        static_cast<void>(take_one_of(rest, "T_"));
    }
    bool const is_time = take_any_time(rest);
    bool const ends = rest.empty() or not(is_alphanumeric(rest[0]) or rest[0] == ':' or rest[0] == '-');
    return (is_date or is_time) and ends ? text.size() - rest.size() : 0;
}

/// A line whose dates and times are blank, if text or four bytes are left, of which none are parted as a time is.
std::string without_times(std::string const& line)
{
    std::string masked = line;
    bool is_bare = false;
    for (std::size_t at = 0; at < line.size(); ++at) {
        std::size_t const size =
            at == 0 or not is_alphanumeric(line[at - 1]) ? size_of_time(std::string_view{line}.substr(at)) : 0;
        if (size > 0) {
            is_bare = is_bare or at == 0 or line[at - 1] != '[';
            masked.replace(at, size, size, ' ');
            at += size;
        }
    }
    std::size_t count = 0;
    bool has_text = false;
    bool is_before_byte = false;
    for (line_word const& word : words_in(masked)) {
        if (is_bare and is_before_byte and word.is_byte() and word.before == ":") {
            return line;
        }
        has_text = has_text or not(word.is_byte() or word.is_wrong_number());
        count += word.bytes.empty() ? (word.decimal ? 1U : 0U) : word.bytes.size();
        is_before_byte = word.is_byte();
    }
    return count >= 4 or has_text ? masked : line;
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

void hex_lines::refuse(line_refusal const& what) const
{
    refuse_word("line " + std::to_string(number_) + ", character " + std::to_string(what.column + 1) + ": '" +
                what.word + "' " + what.why);
}

void hex_lines::add_dump(std::string_view line, std::size_t from, byte_run& run) const
{
    for (line_word const& word : words_in(line, from)) {
        if (word.bytes.empty()) {
            refuse({word.column, word.text, why_no_byte(word)});
        }
        run.bytes.insert(run.bytes.end(), word.bytes.begin(), word.bytes.end());
    }
}

byte_run hex_lines::read_line() const
{
    line_refusal refusal;
    byte_run run = run_in(words_in(without_times(line_)), refusal);
    if (not refusal.why.empty()) {
        refuse(refusal);
    }
    return run;
}

bool hex_lines::next_line()
{
    if (has_line_) {
        has_line_ = false;
        return true;
    }
    if (not std::getline(from_, line_)) {
        return false;
    }
    ++number_;
    if (std::size_t const end = end_of_time(line_); end > 0) {
        line_.replace(0, end, end, ' ');
    }
    return true;
}

bool hex_lines::next(byte_run& run)
{
    run = {};
    while (next_line()) {
        line_start const start = start_of(line_, run.is_single ? 0 : run.bytes.size());
        bool const is_of_dump = start.first != 0;
        byte_run its;
        if (not is_of_dump) {
            its = read_line();
        }
        bool const goes_on = is_of_dump ? start.goes_on : run.is_single and its.is_single;
        if (not run.bytes.empty() and not goes_on) {
            has_line_ = true; // belongs to the next run
            return true;
        }
        if (is_of_dump) {
            add_dump(std::string_view{line_}.substr(0, start.end), start.first, run);
        } else if (run.is_single) {
            run.bytes.push_back(its.bytes.front());
        } else {
            run = its;
        }
        bool const may_go_on = run.is_single or (is_of_dump and start.first < line_.size());
        if (not run.bytes.empty() and not may_go_on) {
            return true;
        }
    }
    return not run.bytes.empty();
}

} // namespace tool
