// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
#include "catalog/drive_family.hpp"

#include <algorithm>
#include <cctype>

#include "words/words.hpp"

namespace tool {

std::string_view family_of(std::string_view product)
{
    auto const is_digit = [](char each) { return std::isdigit(static_cast<unsigned char>(each)) != 0; };
    auto const first = std::ranges::find_if(product, is_digit);
    auto const end = std::find_if_not(first, product.end(), is_digit);
    return product.substr(0, static_cast<std::size_t>(end - product.begin()));
}

bool names_a_drive(std::string const& name)
{
    constexpr std::string_view families[]{"altivar", "altistart", "lexium"};
    constexpr std::string_view codes[]{"atv", "ats", "lxm"};
    std::string const text = lower(name);
    for (std::string_view const each : codes) {
        for (std::size_t at = text.find(each); at != text.npos; at = text.find(each, at + 1)) {
            std::size_t const next = text.find_first_not_of(" -_", at + each.size());
            bool const begins_a_word = at == 0 or std::isalnum(static_cast<unsigned char>(text[at - 1])) == 0;
            bool const is_alone = next == text.npos and each == codes[0];
            if (begins_a_word and (is_alone or (next != text.npos and is_digit(text[next])))) {
                return true;
            }
        }
    }
    return std::ranges::any_of(families, [&text](auto each) { return text.find(each) != text.npos; });
}

std::optional<std::uint16_t> only_in(drive_catalog const& one, drive_catalog const& other)
{
    for (register_entry const& each : one.registers) {
        if (each.is_for_driving and other.at(each.address) == nullptr) {
            return each.address;
        }
    }
    return std::nullopt;
}

} // namespace tool
