// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
#include "frame/byte_words.hpp"

#include <algorithm>
#include <charconv>

namespace tool {

namespace {

constexpr std::string_view parts_words = " \t\r\n,;:\\[]<>(){}\"'|-=";
constexpr std::string_view digits_of_hex = "0123456789abcdefABCDEF";
constexpr std::string_view digits_of_ten = "0123456789";

bool has_only(std::string_view word, std::string_view characters)
{
    return not word.empty() and word.find_first_not_of(characters) == word.npos;
}

unsigned value_in(std::string_view digits, int base)
{
    unsigned value = 0;
    std::from_chars(digits.data(), digits.data() + digits.size(), value, base);
    return value;
}

/// The digits of "0x1F", "$1F", "1Fh" and of "\x1F", whose "\" parts words.
std::string_view hex_digits_in(line_word const& word)
{
    std::string_view digits = word.text;
    if (digits.starts_with("0x") or digits.starts_with("0X")) {
        return digits.substr(2);
    }
    if (digits.starts_with('$') or (digits.starts_with('x') and word.before.ends_with('\\'))) {
        return digits.substr(1);
    }
    bool const has_suffix = digits.size() == 3 and (digits[2] == 'h' or digits[2] == 'H');
    return has_suffix ? digits.substr(0, 2) : digits;
}

void read_numbers(line_word& word)
{
    std::string_view const digits = hex_digits_in(word);
    if (has_only(digits, digits_of_hex) and (digits.size() % 2 == 0 or digits.size() == 1)) {
        for (std::size_t at = 0; at < digits.size(); at += 2) {
            word.bytes.push_back(static_cast<std::byte>(value_in(digits.substr(at, 2), 16)));
        }
    }
    // Nobody writes 01 for 1 among decimal numbers, but some write 001.
    bool const is_decimal = word.text.size() <= 3 and has_only(word.text, digits_of_ten) and
                            not(word.text.size() == 2 and word.text[0] == '0') and value_in(word.text, 10) <= 255;
    if (is_decimal) {
        word.decimal = static_cast<std::byte>(value_in(word.text, 10));
    }
}

/// Bytes with points between all of them, of four on: "1.5" is a number, and so is "192.168.1.1".
bool has_points_between(std::string_view word)
{
    if (word.size() < 11 or word.size() % 3 != 2) {
        return false;
    }
    for (std::size_t at = 0; at < word.size(); ++at) {
        if (at % 3 == 2 ? word[at] != '.' : digits_of_hex.find(word[at]) == digits_of_hex.npos) {
            return false;
        }
    }
    return true;
}

/// The byte of an escape behind its "\", and how long that is; 0 where it is none.
std::size_t escape_in(std::string_view text, std::byte& byte)
{
    constexpr std::string_view letters = "abtnvfr\\'\"0", meaning{"\a\b\t\n\v\f\r\\'\"\0", 11};
    if (text.empty()) {
        return 0;
    }
    if (text[0] == 'x') {
        std::string_view const digits = text.substr(1, 2);
        byte = static_cast<std::byte>(value_in(digits, 16));
        return digits.size() == 2 and has_only(digits, digits_of_hex) ? 3 : 0;
    }
    if (text[0] >= '0' and text[0] <= '7') {
        std::size_t const size = (std::min)({text.find_first_not_of("01234567"), text.size(), std::size_t{3}});
        byte = static_cast<std::byte>(value_in(text.substr(0, size), 8));
        return size;
    }
    std::size_t const which = letters.find(text[0]);
    byte = which == letters.npos ? std::byte{} : static_cast<std::byte>(meaning[which]);
    return which == letters.npos ? 0 : 1;
}

/// The literal that begins with the quote at the front, without what is in front of it; its size with both quotes, or 0
/// where it is none. One without an escape is words.
std::size_t literal_in(std::string_view text, std::vector<std::byte>& bytes)
{
    char const quote = text[0];
    bool has_escape = false;
    bytes.clear();
    for (std::size_t at = 1; at < text.size(); ++at) {
        if (text[at] == quote) {
            return has_escape ? at + 1 : 0;
        }
        std::byte byte{static_cast<unsigned char>(text[at])};
        if (text[at] == '\\') {
            std::size_t const size = escape_in(text.substr(at + 1), byte);
            if (size == 0) {
                return 0;
            }
            at += size;
            has_escape = true;
        }
        bytes.push_back(byte);
    }
    return 0;
}

std::string with_one_blank(std::string_view between)
{
    std::string text;
    for (char const each : between) {
        char const shown = each == '\t' or each == '\r' or each == '\n' ? ' ' : each;
        if (shown != ' ' or text.empty() or text.back() != ' ') {
            text += shown;
        }
    }
    return text;
}

bool is_quote(char character) { return character == '\'' or character == '"'; }

} // namespace

bool line_word::is_wrong_number() const
{
    bool const is_escape =
        text.size() > 1 and text[0] == 'x' and has_only(std::string_view{text}.substr(1), digits_of_hex);
    return not is_byte() and (digits_of_ten.find(text[0]) != digits_of_ten.npos or is_escape);
}

std::vector<line_word> words_in(std::string_view line, std::size_t from)
{
    std::vector<line_word> words;
    std::size_t before = from;
    for (std::size_t at = from; at < line.size();) {
        line_word word{.column = at};
        if (is_quote(line[at])) {
            if (std::size_t const size = literal_in(line.substr(at), word.bytes); size > 0) {
                word.is_literal = true;
                word.text = line.substr(at, size);
                words.push_back(word);
                at += size;
                before = at;
                continue;
            }
        }
        if (parts_words.find(line[at]) != parts_words.npos) {
            ++at;
            continue;
        }
        std::size_t const end = (std::min)(line.find_first_of(parts_words, at), line.size());
        std::string_view const text = line.substr(at, end - at);
        bool const is_prefix = (text == "b" or text == "B") and end < line.size() and is_quote(line[end]);
        word.before = with_one_blank(line.substr(before, at - before));
        if (has_points_between(text)) {
            for (std::size_t part = 0; part < text.size(); part += 3) {
                line_word one{.column = at + part,
                              .text = std::string{text.substr(part, 2)},
                              .before = part == 0 ? word.before : "."};
                read_numbers(one);
                words.push_back(one);
            }
        } else if (not is_prefix) {
            word.text = text;
            read_numbers(word);
            words.push_back(word);
        }
        at = end;
        before = is_prefix ? before : end;
    }
    return words;
}

std::string why_no_byte(line_word const& word)
{
    std::string_view const digits = hex_digits_in(word);
    if (has_only(digits, digits_of_hex)) {
        return "has " + std::to_string(digits.size()) + " digits: a byte has two";
    }
    return "is no hexadecimal number";
}

} // namespace tool
