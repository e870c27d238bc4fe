// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
#include "frame/register_names.hpp"

#include <algorithm>
#include <iterator>
#include <utility>

#include "catalog/value_text.hpp"

namespace tool {

register_entry const* names_by_drive::entry_at(register_space space, unsigned address) const
{
    bool const is_known = space == register_space::holding and address <= 0xFFFFU;
    return is_known ? drive_.at(static_cast<std::uint16_t>(address)) : nullptr;
}

std::string names_by_drive::name_at(register_space space, unsigned address) const
{
    register_entry const* const entry = entry_at(space, address);
    return entry == nullptr ? std::string{} : std::string{entry->code};
}

std::vector<passed_value> names_by_drive::values_at(register_space space, unsigned address,
                                                    std::span<std::uint16_t const> words) const
{
    std::vector<passed_value> values;
    if (register_entry const* const entry = entry_at(space, address); entry != nullptr) {
        auto const step = step_of(*entry, drive_); // nobody knows here what sets it
        register_value found = value_of(*entry, words[0], step);
        std::string short_text = step ? text_of(*entry, words[0], *step) : found.text;
        values.push_back({address, 1, std::string{entry->code}, std::move(found.text), std::move(short_text),
                          std::move(found.value), std::move(found.measure)});
    }
    return values;
}

std::vector<passed_value> values_in(register_names const* names, register_space space, unsigned first,
                                    std::span<std::uint16_t const> words)
{
    std::vector<passed_value> values;
    for (std::size_t at = 0; at < words.size(); at += values.back().count) {
        unsigned const address = first + static_cast<unsigned>(at);
        auto found =
            names == nullptr ? std::vector<passed_value>{} : names->values_at(space, address, words.subspan(at));
        if (found.empty()) {
            std::string const number = std::to_string(words[at]);
            found.push_back({address, 1, {}, number, number});
        }
        std::ranges::move(found, std::back_inserter(values));
    }
    return values;
}

} // namespace tool
