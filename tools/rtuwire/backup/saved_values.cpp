// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
#include <algorithm>

#include "backup/saved_settings.hpp"
#include "catalog/named_values.hpp"
#include "catalog/value_text.hpp"
#include "words/amount_words.hpp"

namespace tool {

namespace {

value_reading wrong(register_entry const& entry, std::string const& value, std::string const& why)
{
    return {{}, std::string{entry.code} + ": '" + value + "' " + why};
}

value_reading read_number(register_entry const& entry, std::string const& value, std::string const& unit,
                          step_size step)
{
    std::string const number = with_point(value);
    bool const has_unit = number.find_first_not_of("+-.0123456789") != number.npos;
    std::string const text = has_unit or unit.empty() ? number : number + " " + unit;
    typed_amount const typed = read_amount(text, entry.unit);
    if (typed.fault == amount_fault::wrong_unit) {
        return wrong(entry, value + (unit.empty() ? "" : " " + unit),
                     entry.unit.empty() ? "has something behind its number" : "is not in " + units_for(entry.unit));
    }
    if (typed.fault != amount_fault::none) {
        return wrong(entry, value, "is no number that is written in digits");
    }
    std::int64_t const count = typed.amount.counts_below(step);
    if (count != typed.amount.counts_above(step)) {
        return wrong(entry, value, "is not a whole number of steps of " + amount_text(1, step, entry.unit));
    }
    bool const is_signed = entry.kind == register_kind::signed_number;
    if (count < (is_signed ? -32'768 : 0) or count > (is_signed ? 32'767 : 65'535)) {
        return wrong(entry, value, "is more than the register holds");
    }
    return {static_cast<std::uint16_t>(count), {}};
}

} // namespace

std::string with_point(std::string text)
{
    std::size_t const comma = text.find(',');
    if (comma != text.npos and text.find_first_of(",.", comma + 1) == text.npos and text.find('.') > comma) {
        text[comma] = '.';
    }
    return text;
}

value_reading read_saved_value(register_entry const& entry, drive_catalog const& drive, std::string const& value,
                               std::string const& unit, std::optional<std::uint16_t> set_by)
{
    if (entry.is_amount()) {
        auto const step = step_of(entry, drive, set_by);
        return step ? read_number(entry, value, unit, *step)
                    : wrong(entry, value, "needs " + std::string{entry.steps_set_by} + ", which sets its steps");
    }
    // A person may have left the words in: "SEP: separate".
    named_reading const read = read_named(entry, value.substr(0, value.find(':')));
    return read.word ? value_reading{*read.word, {}} : wrong(entry, value, "is none of its values; " + read.sentence);
}

saved_value value_to_save(register_entry const& entry, drive_catalog const& drive, std::uint16_t word,
                          std::optional<std::uint16_t> set_by)
{
    if (entry.is_amount()) {
        auto const step = step_of(entry, drive, set_by);
        return step ? saved_value{number_text(entry.count_of(word), *step), true, std::string{entry.unit}}
                    : saved_value{};
    }
    if (entry.kind == register_kind::bits) {
        return {hex_word(word), false, {}};
    }
    rtuwire::choice const* const found = entry.choice_of(word);
    return found != nullptr ? saved_value{std::string{std::string_view{found->mnemonic}}, false, {}} : saved_value{};
}

} // namespace tool
