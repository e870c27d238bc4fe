// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
#include "catalog/named_values.hpp"

#include <algorithm>
#include <vector>

#include "words/words.hpp"

namespace tool {

namespace {

named_reading read_enumerator(register_entry const& entry, std::string_view text)
{
    std::vector<std::string_view> names;
    for (rtuwire::choice const& each : entry.values()) {
        names.push_back(each.mnemonic);
        if (text == names.back()) {
            return {each.word};
        }
    }
    for (rtuwire::choice const& each : entry.values()) {
        if (is_same_word(std::string_view{each.mnemonic}, text)) {
            return {each.word};
        }
    }
    if (auto const number = word_number(text)) {
        return {*number};
    }
    std::string const sentence = std::string{entry.code} + " takes " + list_of_values(entry);
    return {{}, "value_without_meaning", sentence, std::string{nearest_word(text, names)}};
}

named_reading read_bits(register_entry const& entry, std::string_view text)
{
    if (auto const number = word_number(text)) {
        return {*number};
    }
    std::uint32_t word = 0;
    while (true) {
        std::size_t const plus = text.find_first_of("+|");
        std::string name = lower(text.substr(0, plus));
        std::replace(name.begin(), name.end(), '-', '_');
        std::size_t bit = 0;
        while (bit < entry.bits.size() and (entry.bits[bit].empty() or entry.bits[bit] != name)) {
            ++bit;
        }
        if (bit == entry.bits.size()) {
            return {{},
                    "unknown_bit",
                    std::string{entry.code} + " has no bit called " + name,
                    std::string{nearest_word(name, entry.bits)}};
        }
        word |= 1U << bit;
        if (plus == text.npos) {
            return {static_cast<std::uint16_t>(word)};
        }
        text.remove_prefix(plus + 1);
    }
}

} // namespace

named_reading read_named(register_entry const& entry, std::string_view text)
{
    return entry.kind == register_kind::bits ? read_bits(entry, text) : read_enumerator(entry, text);
}

bool has_meaning(register_entry const& entry, std::uint16_t word) noexcept
{
    return entry.values().empty() or entry.choice_of(word) != nullptr;
}

std::string list_of_values(register_entry const& entry)
{
    std::string list;
    for (rtuwire::choice const& each : entry.values()) {
        list += (list.empty() ? "" : ", ") + std::string{std::string_view{each.mnemonic}} + " (" +
                std::to_string(each.word) + ")";
    }
    return list.empty() ? "a number from 0 to 65535" : list;
}

} // namespace tool
