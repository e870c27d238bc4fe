// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
#include "frame/names_by_file.hpp"

#include <algorithm>

#include "words/named_value.hpp"

namespace tool {

namespace {

/// "register 2", "registers 1 to 2".
std::string part_text(std::size_t first, std::size_t count)
{
    return count == 1 ? "register " + std::to_string(first)
                      : "registers " + std::to_string(first) + " to " + std::to_string(first + count - 1);
}

/// What the words are, of which the first may be one in the middle of the place. A part of a value is none.
passed_value value_at(named_place const& named, unsigned address, std::span<std::uint16_t const> words)
{
    std::size_t const before = address - named.where.address;
    std::size_t const size = named.where.size();
    std::size_t const count = std::min(size - before, words.size());
    if (count < size) {
        std::string const text = "no value: " + hex_words(words.first(count)) + " is " + part_text(before + 1, count) +
                                 " of its " + std::to_string(size);
        return {address, count, named.where.name, text, text};
    }
    formed_value const found = value_of(named, words.first(size));
    return {address, count, named.where.name, found.text, found.text, found.value, named.where.form.unit};
}

} // namespace

names_by_file::names_by_file(named_places const& said)
{
    for (named_place const& each : said.places) {
        for (unsigned i = 0; i < each.where.size(); ++i) {
            places_.emplace(std::pair{each.where.space, each.where.address + i}, &each);
        }
    }
}

std::string names_by_file::name_at(register_space space, unsigned address) const
{
    std::string names;
    auto const [begin, end] = places_.equal_range({space, address});
    for (auto at = begin; at != end; ++at) {
        place const& where = at->second->where;
        std::string const part =
            where.address == address ? std::string{} : part_text(address - where.address + 1U, 1) + " of ";
        names += (names.empty() ? "" : ", ") + part + where.name;
    }
    return names;
}

std::vector<passed_value> names_by_file::values_at(register_space space, unsigned address,
                                                   std::span<std::uint16_t const> words) const
{
    std::vector<passed_value> values;
    auto const [begin, end] = places_.equal_range({space, address});
    for (auto at = begin; at != end; ++at) {
        bool const is_part = at->second->where.bit >= 0;
        if (is_part and values.empty()) { // the other bits have passed, too
            std::string const number = std::to_string(words[0]);
            values.push_back({address, 1, {}, number, number});
        }
        values.push_back(value_at(*at->second, address, words));
    }
    return values;
}

} // namespace tool
