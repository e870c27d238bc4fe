// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
#include <algorithm>
#include <string>

#include "words/register_words.hpp"

namespace tool {

namespace {

bool is_named(register_entry const& entry, std::string_view word)
{
    return holds_word(entry.code, word) or holds_word(entry.name, word) or entry.menu.starts_with(word);
}

bool has_value_named(register_entry const& entry, std::string_view word)
{
    bool const holds = std::ranges::any_of(entry.choices, [&](rtuwire::choice const& each) {
        bool const is_value = entry.kind == register_kind::enumeration;
        return (is_value and holds_word(each.mnemonic, word)) or holds_word(each.meaning, word);
    });
    return holds or std::any_of(entry.bits.begin(), entry.bits.end(), [word](std::string_view bit) {
               std::string words{bit};
               std::replace(words.begin(), words.end(), '_', ' ');
               return holds_word(bit, word) or holds_word(words, word);
           });
}

} // namespace

std::vector<register_entry const*> search_registers(drive_catalog const& drive, std::string_view word)
{
    std::vector<register_entry const*> found;
    std::vector<register_entry const*> by_values;
    for (register_entry const& each : drive.registers) {
        if (is_named(each, word)) {
            found.push_back(&each);
        } else if (has_value_named(each, word)) {
            by_values.push_back(&each);
        }
    }
    found.insert(found.end(), by_values.begin(), by_values.end());
    return found;
}

} // namespace tool
