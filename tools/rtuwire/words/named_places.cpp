// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
#include "words/named_places.hpp"

#include <algorithm>

namespace tool {

namespace {

constexpr std::size_t longest_name = 40;

} // namespace

bool overlap(place const& one, place const& other) noexcept
{
    bool const shares = one.space == other.space and one.address < other.address + other.size() and
                        other.address < one.address + one.size();
    return shares and (one.address != other.address or (one.mask() & other.mask()) != 0);
}

named_place const* named_places::by_name(std::string_view name) const noexcept
{
    auto const found =
        std::ranges::find_if(places, [name](named_place const& each) { return is_same_word(each.where.name, name); });
    return found == places.end() ? nullptr : &*found;
}

named_place const* named_places::overlapping(place const& where) const noexcept
{
    auto const found =
        std::ranges::find_if(places, [&where](named_place const& each) { return overlap(each.where, where); });
    return found == places.end() ? nullptr : &*found;
}

named_group const* named_places::group_named(std::string_view name) const noexcept
{
    auto const found =
        std::ranges::find_if(groups, [name](named_group const& each) { return is_same_word(each.name, name); });
    return found == groups.end() ? nullptr : &*found;
}

std::string why_no_word(std::string_view word)
{
    auto const is_letter = [](char c) { return (c >= 'a' and c <= 'z') or (c >= 'A' and c <= 'Z'); };
    bool const is_word = not word.empty() and is_letter(word[0]) and word.size() <= longest_name and
                         std::ranges::all_of(word, [&](char c) { return is_letter(c) or is_digit(c) or c == '_'; });
    return is_word ? std::string{} : "a name begins with a letter and has letters, digits and _, at most 40 of them";
}

std::string why_no_name(std::string_view name)
{
    if (std::string why = why_no_word(name); not why.empty()) {
        return why;
    }
    // `watch` has these beside the names of registers.
    for (std::string_view const column : {"time", "seconds", "unit", "error"}) {
        if (is_same_word(name, column)) {
            return "is a column of what is shown, and no name";
        }
    }
    // As the first part of a place, or as a form behind one.
    std::string const text{name};
    bool const is_space = not read_places(text + ":1").refused or is_same_word(name, "list");
    bool const is_form = not read_places("1:" + text).refused or not read_places("1:u64:" + text).refused;
    return is_space or is_form ? "is a space, a type or an order of places, and no name" : std::string{};
}

} // namespace tool
