// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
#include "catalog/catalog.hpp"

#include <algorithm>

#include "words/words.hpp"

namespace tool {

std::int32_t register_entry::lowest_count() const noexcept
{
    if (min.is_number()) {
        return static_cast<std::int32_t>(min.raw());
    }
    return kind == register_kind::signed_number ? -32'768 : 0;
}

std::int32_t register_entry::highest_count() const noexcept
{
    if (max.is_number()) {
        return static_cast<std::int32_t>(max.raw());
    }
    return kind == register_kind::signed_number ? 32'767 : 65'535;
}

register_entry const* drive_catalog::at(std::uint16_t address) const noexcept
{
    auto const found = std::lower_bound(registers.begin(), registers.end(), address,
                                        [](auto const& entry, std::uint16_t wanted) { return entry.address < wanted; });
    return found != registers.end() and found->address == address ? &*found : nullptr;
}

register_entry const* drive_catalog::by_code(std::string_view code) const noexcept
{
    auto const found = std::find_if(registers.begin(), registers.end(),
                                    [code](auto const& entry) { return is_same_word(entry.code, code); });
    return found != registers.end() ? &*found : nullptr;
}

register_entry const* drive_catalog::by_menu(std::string_view number) const noexcept
{
    auto const found = std::find_if(registers.begin(), registers.end(), [number](auto const& entry) {
        return not number.empty() and entry.menu == number;
    });
    return found != registers.end() ? &*found : nullptr;
}

rtuwire::choice const* register_entry::choice_of(std::uint16_t word) const noexcept
{
    auto const found = std::ranges::find(choices, word, &rtuwire::choice::word);
    return found != choices.end() ? &*found : nullptr;
}

drive_catalog const* catalog_named(std::string_view name) noexcept
{
    for (drive_catalog const* each : all_catalogs()) {
        if (is_same_word(each->name, name)) {
            return each;
        }
    }
    return nullptr;
}

std::string text_of_bound(rtuwire::bound const& limit)
{
    if (limit.is_open()) {
        return {};
    }
    if (limit.is_number()) {
        return std::to_string(limit.raw());
    }
    std::string text{std::string_view{limit.code()}};
    if (limit.factor().size() > 0) {
        text += "*" + std::string{std::string_view{limit.factor()}};
    }
    if (limit.numerator() != 1 or limit.denominator() != 1) {
        text = std::to_string(limit.numerator()) + "/" + std::to_string(limit.denominator()) + " " + text;
    }
    return text;
}

std::string_view text_of(rtuwire::access mode) noexcept
{
    switch (mode) {
    case rtuwire::access::read_only: return "read only";
    case rtuwire::access::read_write: return "read, write";
    case rtuwire::access::configuration: return "read, write at rest";
    }
    return "";
}

std::string_view text_of(rtuwire::provenance source) noexcept
{
    switch (source) {
    case rtuwire::provenance::documented: return "documented";
    case rtuwire::provenance::inferred: return "inferred";
    case rtuwire::provenance::doubtful: return "doubtful";
    }
    return "";
}

std::string_view text_of(register_kind kind) noexcept
{
    switch (kind) {
    case register_kind::number: return "number";
    case register_kind::signed_number: return "signed number";
    case register_kind::bits: return "bits";
    case register_kind::enumeration: return "enumeration";
    }
    return "";
}

} // namespace tool
