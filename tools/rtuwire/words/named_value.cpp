// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
#include "words/named_value.hpp"

#include <algorithm>
#include <limits>
#include <optional>
#include <variant>

#include "words/suggestion.hpp"

namespace tool {

namespace {

double amount_of(cell const& value)
{
    return std::holds_alternative<double>(value)          ? std::get<double>(value)
           : std::holds_alternative<std::int64_t>(value)  ? static_cast<double>(std::get<std::int64_t>(value))
           : std::holds_alternative<std::uint64_t>(value) ? static_cast<double>(std::get<std::uint64_t>(value))
                                                          : std::numeric_limits<double>::quiet_NaN();
}

/// The choice that a number stands for; null where none does.
named_choice const* choice_of(named_place const& named, cell const& value)
{
    bool const* const bit = std::get_if<bool>(&value);
    std::int64_t const* const number = std::get_if<std::int64_t>(&value);
    if (bit == nullptr and number == nullptr) {
        return nullptr;
    }
    auto const found =
        std::ranges::find(named.choices, bit != nullptr ? std::int64_t{*bit} : *number, &named_choice::number);
    return found == named.choices.end() ? nullptr : &*found;
}

/// "at least -10 degC and at most 95.5 degC".
std::string text_of_limits(named_place const& named)
{
    std::string const unit = named.where.form.unit.empty() ? "" : ' ' + named.where.form.unit;
    auto const text = [&unit](std::optional<double> const& limit) { return text_of_cell(*limit) + unit; };
    return (named.lowest ? "at least " + text(named.lowest) : "") + (named.lowest and named.highest ? " and " : "") +
           (named.highest ? "at most " + text(named.highest) : "");
}

} // namespace

bool is_no_value(named_place const& named, std::span<std::uint16_t const> words)
{
    return not named.invalid.empty() and std::ranges::count(named.invalid, bits_of(named.where, words)) != 0;
}

formed_value value_of(named_place const& named, std::span<std::uint16_t const> words)
{
    if (is_no_value(named, words)) {
        return {{}, "no value (" + hex_words(words) + ')'};
    }
    formed_value formed = value_of(named.where, words);
    if (named.choices.empty()) {
        return formed;
    }
    named_choice const* const choice = choice_of(named, formed.value);
    return choice == nullptr ? formed_value{formed.value, text_of_cell(formed.value) + ", which is none of its choices"}
                             : formed_value{choice->name, choice->name + " (" + std::to_string(choice->number) + ')'};
}

std::string why_not_written(named_place const& named, std::span<std::uint16_t const> words)
{
    cell const value = value_of(named.where, words).value;
    if (is_no_value(named, words)) {
        return hex_words(words) + " means that " + named.where.name + " has no value";
    }
    if (not named.choices.empty() and choice_of(named, value) == nullptr) {
        return named.where.name + " takes " + list_of_choices(named);
    }
    double const amount = amount_of(value);
    bool const has_limits = named.lowest or named.highest;
    bool const is_within = amount >= named.lowest.value_or(amount) and amount <= named.highest.value_or(amount);
    return has_limits and not is_within ? named.where.name + " takes " + text_of_limits(named) : std::string{};
}

words_typed words_to_hold(named_place const& named, std::string_view text)
{
    place const& where = named.where;
    auto const choice =
        std::ranges::find_if(named.choices, [text](named_choice const& each) { return is_same_word(each.name, text); });
    std::string const number = choice != named.choices.end() ? std::to_string(choice->number) : std::string{text};
    bool const is_word = not named.choices.empty() and choice == named.choices.end() and why_no_word(text).empty();
    if (is_word and not where.is_single_bit()) {
        std::vector<std::string_view> known;
        for (named_choice const& each : named.choices) {
            known.push_back(each.name);
        }
        return {.wrong = where.name + " takes " + list_of_choices(named) + suggestion(text, known)};
    }
    return words_for(where, number);
}

words_typed words_for(named_place const& named, std::string_view text)
{
    words_typed typed = words_to_hold(named, text);
    if (std::string why = typed.wrong.empty() ? why_not_written(named, typed.words) : std::string{}; not why.empty()) {
        return {.wrong = std::move(why)};
    }
    return typed;
}

std::string list_of_choices(named_place const& named)
{
    std::string all;
    for (named_choice const& each : named.choices) {
        all += (all.empty() ? "" : ", ") + each.name + ' ' + std::to_string(each.number);
    }
    return all;
}

} // namespace tool
