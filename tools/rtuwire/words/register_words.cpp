// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
#include "words/register_words.hpp"

#include <algorithm>
#include <set>
#include <string>
#include <utility>

#include "catalog/value_text.hpp"

namespace tool {

namespace {

using refusal_or_none = std::optional<refusal>;

std::string with_nearest(std::string sentence, std::string_view nearest)
{
    return nearest.empty() ? std::move(sentence) : std::move(sentence) + "; did you mean " + std::string{nearest} + "?";
}

refusal unknown(std::string kind, std::string_view culprit, std::string_view what, std::string_view nearest)
{
    std::string const sentence = std::string{culprit} + ": " + std::string{what};
    return {std::move(kind), std::string{culprit}, with_nearest(sentence, nearest), std::string{nearest}};
}

std::string listed(std::span<std::string_view const> words)
{
    std::string all;
    for (std::string_view const each : words) {
        all += (all.empty() ? "" : ", ") + std::string{each};
    }
    return all;
}

/// A mnemonic may be right, and its register one of which no public list tells.
std::string not_among(drive_catalog const& drive)
{
    return "is not among the " + std::to_string(drive.registers.size()) + " registers that are known of an " +
           std::string{drive.name} + "; read it by its address";
}

/// Another group in the form in which one was typed.
std::string group_like(std::string_view word, std::string_view group)
{
    return std::string{word.substr(0, word.size() - group_in(word).size())} + std::string{group};
}

/// Collects registers, each once.
class collector {
public:
    explicit collector(vocabulary const& known) noexcept : drive_{known.drive}, names_{known.names} {}

    void add(std::uint16_t address, int bit = -1) { add(place{.address = address, .bit = bit}); }
    void add(place const& where, named_place const* named = nullptr)
    {
        place key = where;
        key.is_space_said = false;
        if (seen_.insert(key).second) {
            bool const is_of_drive = drive_ != nullptr and where.space == register_space::holding;
            found_.push_back({where, is_of_drive ? drive_->at(where.address) : nullptr, named});
        }
    }

    [[nodiscard]] refusal_or_none add_word(std::string_view word);
    [[nodiscard]] std::vector<chosen_register> take() noexcept { return std::move(found_); }

private:
    [[nodiscard]] refusal_or_none add_names(std::string_view word);
    [[nodiscard]] refusal_or_none add_named_group(std::string_view word);
    [[nodiscard]] refusal_or_none add_places(std::string_view word);
    [[nodiscard]] refusal_or_none add_numbers(std::string_view word, std::size_t dash);
    [[nodiscard]] refusal_or_none add_group(std::string_view word);
    [[nodiscard]] refusal_or_none add_matches(std::string_view word);
    [[nodiscard]] refusal_or_none add_bit(std::string_view word, std::size_t dot);
    [[nodiscard]] refusal_or_none add_code(std::string_view word);

    drive_catalog const* drive_;
    named_places const* names_;
    std::vector<chosen_register> found_;
    std::set<place> seen_;
};

/// The codes of a drive's registers, for the search of the nearest.
std::vector<std::string_view> codes_of(drive_catalog const& drive)
{
    std::vector<std::string_view> codes;
    for (register_entry const& each : drive.registers) {
        codes.push_back(each.code);
    }
    return codes;
}

refusal_or_none collector::add_word(std::string_view word)
{
    if (is_place_word(word)) {
        return add_places(word);
    }
    if (names_ != nullptr and not word.empty() and not is_digit(word[0])) {
        return word[0] == '@' or not group_in(word).empty() ? add_named_group(word) : add_names(word);
    }
    if (register_entry const* const entry = drive_ == nullptr ? nullptr : drive_->by_menu(word); entry != nullptr) {
        add(entry->address);
        return {};
    }
    std::size_t const dot = word.find('.');
    if (not word.empty() and is_digit(word[0]) and dot == word.npos) {
        return add_numbers(word, word.find('-'));
    }
    if (drive_ == nullptr and not(not word.empty() and is_digit(word[0]))) {
        return unknown("no_drive", word,
                       "no drive is known, so there are only addresses (40, input:40:f32); name one with --drive", "");
    }
    if (word.starts_with('@') or not group_in(word).empty()) {
        return add_group(word);
    }
    if (dot != word.npos) {
        return add_bit(word, dot);
    }
    return word.find_first_of("*?") != word.npos ? add_matches(word) : add_code(word);
}

/// A name of the register file, or a glob of several.
refusal_or_none collector::add_names(std::string_view word)
{
    std::size_t matched = 0;
    std::vector<std::string_view> known;
    for (named_place const& each : names_->places) {
        known.push_back(each.where.name);
        if (matches(word, each.where.name)) {
            add(each.where, &each);
            ++matched;
        }
    }
    std::string const begun = std::string{word} + '_';
    auto const longer = std::ranges::find_if(known, [&](std::string_view each) { return each.starts_with(begun); });
    return matched > 0 ? refusal_or_none{}
                       : unknown("unknown_register", word, names_->file + " has no such register",
                                 longer != known.end() ? *longer : nearest_word(word, known));
}

/// All registers of a group of the register file.
refusal_or_none collector::add_named_group(std::string_view word)
{
    std::vector<std::string_view> known;
    for (named_group const& each : names_->groups) {
        known.push_back(each.name);
    }
    std::string_view const name = group_in(word);
    named_group const* const group = names_->group_named(name);
    if (group == nullptr) {
        std::string_view const nearest = nearest_word(name, known);
        return unknown("unknown_group", word,
                       names_->file + (known.empty() ? " has no groups" : " has no such group, but " + listed(known)),
                       nearest.empty() ? std::string{} : group_like(word, nearest));
    }
    for (named_place const& each : names_->places) {
        if (each.group == group->name) {
            add(each.where, &each);
        }
    }
    return {};
}

refusal_or_none collector::add_places(std::string_view word)
{
    places_typed typed = read_places(word);
    for (place const& each : typed.places) {
        add(each);
    }
    return std::move(typed.refused);
}

refusal_or_none collector::add_numbers(std::string_view word, std::size_t dash)
{
    auto const first = word_number(word.substr(0, dash));
    auto const last = dash == word.npos ? first : word_number(word.substr(dash + 1));
    if (not first or not last) {
        return unknown("wrong_address", word, "an address is a number from 0 to 65535: 3202, 0x0C82, 3201-3205", "");
    }
    if (*last < *first) {
        return unknown("wrong_address", word, "a range begins with its lower address", "");
    }
    for (std::uint32_t address = *first; address <= *last; ++address) {
        add(static_cast<std::uint16_t>(address));
    }
    return {};
}

/// A group to look at comes before one of the menu; no two have one name.
refusal_or_none collector::add_group(std::string_view word)
{
    std::string_view const name = group_in(word);
    for (register_group const& each : register_groups()) {
        for (std::string_view const code : is_same_word(each.name, name) ? each.codes : decltype(each.codes){}) {
            if (register_entry const* entry = drive_->by_code(code); entry != nullptr) {
                add(entry->address);
            }
        }
    }
    for (register_entry const& each : drive_->registers) {
        if (is_same_word(each.group, name)) {
            add(each.address);
        }
    }
    std::vector<std::string_view> const names = all_groups_of(*drive_);
    if (std::any_of(names.begin(), names.end(), [name](auto each) { return is_same_word(each, name); })) {
        return {};
    }
    std::string_view const nearest = nearest_word(name, names);
    std::string const shown = nearest.empty() ? std::string{} : group_like(word, nearest);
    return unknown("unknown_group", word,
                   "an " + std::string{drive_->name} + " has no such group, but " + listed(names), shown);
}

refusal_or_none collector::add_matches(std::string_view word)
{
    std::size_t matched = 0;
    for (register_entry const& each : drive_->registers) {
        if (matches(word, each.code)) {
            add(each.address);
            ++matched;
        }
    }
    if (matched > 0) {
        return {};
    }
    return unknown("unknown_register", word, "no register of " + std::string{drive_->name} + " matches it", "");
}

refusal_or_none collector::add_bit(std::string_view word, std::size_t dot)
{
    std::string_view const code = word.substr(0, dot);
    std::string name = lower(word.substr(dot + 1));
    std::replace(name.begin(), name.end(), '-', '_');
    auto const plain = word_number(code);
    register_entry const* entry = drive_ == nullptr ? nullptr : plain ? drive_->at(*plain) : drive_->by_code(code);
    if (drive_ == nullptr and not plain) {
        return unknown("wrong_address", word, "an address is a number from 0 to 65535, such as 3201.3 with a bit", "");
    }
    if (entry == nullptr and not plain) {
        return unknown("unknown_register", word, std::string{code} + " " + not_among(*drive_),
                       nearest_word(code, codes_of(*drive_)));
    }
    std::uint16_t const address = plain ? *plain : entry->address;
    if (auto const bit = word_number(name); bit and *bit < 16) {
        add(address, *bit);
        return {};
    }
    if (entry == nullptr or entry->kind != register_kind::bits) {
        return unknown("unknown_bit", word, "it has no named bits; a bit has a number from 0 to 15", "");
    }
    for (std::size_t bit = 0; bit < entry->bits.size(); ++bit) {
        if (not entry->bits[bit].empty() and entry->bits[bit] == name) {
            add(address, static_cast<int>(bit));
            return {};
        }
    }
    std::string_view const nearest = nearest_word(name, entry->bits);
    std::string const shown = nearest.empty() ? std::string{} : std::string{code} + "." + std::string{nearest};
    return unknown("unknown_bit", word, std::string{entry->code} + " has no such bit", shown);
}

refusal_or_none collector::add_code(std::string_view word)
{
    if (register_entry const* entry = drive_->by_code(word); entry != nullptr) {
        add(entry->address);
        return {};
    }
    return unknown("unknown_register", word, not_among(*drive_), nearest_word(word, codes_of(*drive_)));
}

} // namespace

register_selection select_registers(std::span<std::string_view const> words, vocabulary const& known)
{
    collector found{known};
    for (std::string_view const word : words) {
        for (std::string_view const part : parts_of(word)) {
            if (auto wrong = part.empty()
                                 ? refusal_or_none{unknown("wrong_address", word, "a register is missing here", "")}
                                 : found.add_word(part)) {
                return {{}, std::move(wrong)};
            }
        }
    }
    return {found.take(), {}};
}

std::optional<refusal> wrong_place_in(std::span<std::string_view const> words)
{
    for (std::string_view const word : words) {
        for (std::string_view const part : parts_of(word)) {
            if (auto wrong = is_place_word(part) ? read_places(part).refused : std::nullopt) {
                return wrong;
            }
        }
    }
    return std::nullopt;
}

std::string_view first_menu_number(std::span<std::string_view const> words)
{
    for (std::string_view const word : words) {
        for (std::string_view const part : parts_of(word)) {
            bool const is_any = std::ranges::any_of(
                all_catalogs(), [part](drive_catalog const* each) { return each->by_menu(part) != nullptr; });
            if (is_any) {
                return part;
            }
        }
    }
    return {};
}

std::string ambiguity_of(std::string_view menu_number)
{
    std::size_t const dot = menu_number.find('.');
    bool const is_bit = dot != menu_number.npos;
    auto const address = word_number(menu_number.substr(0, dot));
    std::string const number{menu_number};
    return number + " is of an ATV310's menu, elsewhere " + (is_bit ? "a bit" : "an address") + ": say --drive, or " +
           hex_word(*address) + (is_bit ? number.substr(dot) : "") + " for that";
}

} // namespace tool
