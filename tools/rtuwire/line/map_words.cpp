// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
#include "line/map_words.hpp"

#include <algorithm>

#include "exit_status.hpp"
#include "line/asked_registers.hpp"

namespace tool {

namespace {

constexpr unsigned last_address = 65'535;

/// One end of a range: a space and an address, nothing more.
place end_in(std::string const& word, std::string const& of)
{
    places_typed const typed = read_places(word);
    if (typed.refused) {
        refuse(*typed.refused);
    }
    bool const is_plain = typed.places.size() == 1 and typed.places[0].bit < 0 and typed.places[0].form.said.empty();
    if (not is_plain) {
        refuse_word("'" + of + "': a map is of addresses alone, such as input:1000-1999");
    }
    return typed.places[0];
}

address_range range_in(std::string const& word)
{
    for (register_space const each :
         {register_space::holding, register_space::input, register_space::coil, register_space::discrete}) {
        if (word == name_of(each) or word == name_of(each).substr(0, 1)) {
            return {each, 0, last_address};
        }
    }
    std::size_t const colon = word.find(':');
    std::string const space = colon == std::string::npos ? std::string{"holding:"} : word.substr(0, colon + 1);
    std::string const where = colon == std::string::npos ? word : word.substr(colon + 1);
    std::size_t const dash = where.find('-');
    place const first = end_in(space + where.substr(0, dash), word);
    place const last = dash == std::string::npos ? first : end_in(space + where.substr(dash + 1), word);
    if (last.space != first.space or last.address < first.address) {
        refuse_word("'" + word + "' is no range of addresses: it looks like input:1000-1999");
    }
    return {first.space, first.address, last.address};
}

} // namespace

std::vector<address_range> ranges_in(std::vector<std::string> const& words)
{
    constexpr unsigned last_of_list = 9'999;
    if (words.empty()) {
        return {{register_space::holding, 0, last_of_list}, {register_space::input, 0, last_of_list}};
    }
    std::vector<address_range> ranges;
    for (std::string const& word : words) {
        address_range const one = range_in(word);
        bool const is_twice = std::ranges::any_of(ranges, [&one](address_range const& each) {
            return each.space == one.space and each.first <= one.last and one.first <= each.last;
        });
        if (is_twice) {
            refuse_word("'" + word + "' has addresses that a word before it has");
        }
        ranges.push_back(one);
    }
    return ranges;
}

} // namespace tool
