// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
#include "words/words.hpp"

#include <algorithm>
#include <charconv>
#include <vector>

namespace tool {

namespace {

char lower(char c) noexcept { return c >= 'A' and c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; }
char upper(char c) noexcept { return c >= 'a' and c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c; }

} // namespace

std::string lower(std::string_view text)
{
    std::string changed{text};
    for (char& c : changed) {
        c = lower(c);
    }
    return changed;
}

std::string upper(std::string_view text)
{
    std::string changed{text};
    for (char& c : changed) {
        c = upper(c);
    }
    return changed;
}

bool is_same_word(std::string_view left, std::string_view right) noexcept
{
    return left.size() == right.size() and
           std::equal(left.begin(), left.end(), right.begin(), [](char a, char b) { return lower(a) == lower(b); });
}

std::vector<std::string_view> parts_of(std::string_view text, std::string_view between)
{
    std::vector<std::string_view> parts;
    while (true) {
        std::size_t const end = text.find(between);
        parts.push_back(text.substr(0, end));
        if (end == text.npos) {
            return parts;
        }
        text.remove_prefix(end + between.size());
    }
}

bool holds_word(std::string_view text, std::string_view word) { return lower(text).find(lower(word)) != text.npos; }

bool matches(std::string_view pattern, std::string_view word) noexcept
{
    // One star is open at a time: where the rest does not match, it takes one character more.
    std::size_t at = 0;
    std::size_t in_word = 0;
    std::size_t star = pattern.npos;
    std::size_t taken = 0;
    while (in_word < word.size()) {
        if (at < pattern.size() and pattern[at] == '*') {
            star = at++;
            taken = in_word;
        } else if (at < pattern.size() and (pattern[at] == '?' or lower(pattern[at]) == lower(word[in_word]))) {
            ++at;
            ++in_word;
        } else if (star != pattern.npos) {
            at = star + 1;
            in_word = ++taken;
        } else {
            return false;
        }
    }
    return pattern.find_first_not_of('*', at) == pattern.npos;
}

std::size_t edit_distance(std::string_view left, std::string_view right)
{
    std::vector<std::size_t> two_above(right.size() + 1);
    std::vector<std::size_t> above(right.size() + 1);
    std::vector<std::size_t> row(right.size() + 1);
    for (std::size_t j = 0; j <= right.size(); ++j) {
        row[j] = j;
    }
    for (std::size_t i = 1; i <= left.size(); ++i) {
        two_above.swap(above);
        above.swap(row);
        row[0] = i;
        for (std::size_t j = 1; j <= right.size(); ++j) {
            bool const is_same = lower(left[i - 1]) == lower(right[j - 1]);
            row[j] = (std::min)({above[j] + 1, row[j - 1] + 1, above[j - 1] + (is_same ? 0U : 1U)});
            bool const is_swapped = i > 1 and j > 1 and lower(left[i - 1]) == lower(right[j - 2]) and
                                    lower(left[i - 2]) == lower(right[j - 1]);
            row[j] = is_swapped ? (std::min)(row[j], two_above[j - 2] + 1) : row[j];
        }
    }
    return row[right.size()];
}

std::string_view nearest_word(std::string_view word, std::span<std::string_view const> candidates)
{
    std::string_view nearest;
    std::size_t least = (std::max)(word.size() / 3, std::size_t{1}) + 1;
    for (std::string_view const each : candidates) {
        std::size_t const distance = edit_distance(word, each);
        if (distance < least and distance < each.size()) {
            least = distance;
            nearest = each;
        }
    }
    return nearest;
}

std::optional<std::uint16_t> word_number(std::string_view text) noexcept
{
    bool const is_hex = text.size() > 2 and text[0] == '0' and lower(text[1]) == 'x';
    text.remove_prefix(is_hex ? 2 : 0);
    std::uint32_t number = 0;
    auto const [end, error] = std::from_chars(text.data(), text.data() + text.size(), number, is_hex ? 16 : 10);
    bool const is_number = error == std::errc{} and end == text.data() + text.size() and number <= 0xFFFF;
    return is_number ? std::optional{static_cast<std::uint16_t>(number)} : std::nullopt;
}

} // namespace tool
