// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
#include "import/source_value.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>

#include "exit_status.hpp"
#include "words/words.hpp"

namespace tool {

namespace {

constexpr std::size_t most_source_values = 300'000;
constexpr std::size_t deepest_source = 32;

template <typename Number, typename... Base> std::optional<Number> number_in_text(std::string_view text, Base... base)
{
    Number read{};
    auto const [end, why] = std::from_chars(text.data(), text.data() + text.size(), read, base...);
    return why == std::errc{} and end == text.data() + text.size() and not text.empty() ? std::optional{read}
                                                                                        : std::nullopt;
}

/// 010 is 8 to a program that reads YAML 1.1, and 10 to another.
bool has_leading_zero(std::string_view text)
{
    text.remove_prefix(text.starts_with('-') or text.starts_with('+') ? 1 : 0);
    return text.size() > 1 and text[0] == '0' and is_digit(text[1]);
}

} // namespace

source_value const* source_value::find(std::string_view name) const noexcept
{
    if (kind != source_kind::table) {
        return nullptr;
    }
    auto const found = std::ranges::find_if(fields, [name](auto const& each) { return each.first == name; });
    return found == fields.end() or found->second.kind == source_kind::none ? nullptr : &found->second;
}

std::string source_value::text_of(std::string_view name) const
{
    source_value const* const found = find(name);
    return found != nullptr and found->is_plain() ? found->text : std::string{};
}

bool source_value::is_true(std::string_view name) const
{
    std::string const said = lower(text_of(name));
    return said == "true" or said == "yes" or said == "on" or said == "1";
}

std::optional<std::int64_t> source_value::whole_number() const
{
    if (not is_plain() or kind == source_kind::truth) {
        return std::nullopt;
    }
    std::string_view digits = text;
    bool const is_negative = digits.starts_with('-');
    digits.remove_prefix(is_negative or digits.starts_with('+') ? 1 : 0);
    bool const is_hex = digits.starts_with("0x") or digits.starts_with("0X");
    if (has_leading_zero(text) or (not is_hex and (digits.empty() or not is_digit(digits[0])))) {
        return std::nullopt;
    }
    auto const read =
        is_hex ? number_in_text<std::int64_t>(digits.substr(2), 16) : number_in_text<std::int64_t>(digits, 10);
    if (read) {
        return is_negative ? -*read : *read;
    }
    auto const real = is_hex ? std::nullopt : number();
    bool const is_whole = real and std::floor(*real) == *real and std::abs(*real) < 9e15;
    return is_whole ? std::optional{static_cast<std::int64_t>(*real)} : std::nullopt;
}

std::optional<double> source_value::number() const
{
    if (not is_plain() or kind == source_kind::truth or has_leading_zero(text)) {
        return std::nullopt;
    }
    if (text.starts_with("0x") or text.starts_with("0X")) {
        auto const whole = whole_number();
        return whole ? std::optional{static_cast<double>(*whole)} : std::nullopt;
    }
    auto const read = number_in_text<double>(text.starts_with('+') ? std::string_view{text}.substr(1) : text);
    return read and std::isfinite(*read) ? read : std::nullopt;
}

void source_builder::count(text_place place)
{
    if (++values_ > most_source_values) {
        refuse_word(told_place(file_, place) + "more than " + std::to_string(most_source_values) + " values");
    }
}

void source_builder::begin(source_kind kind, text_place place, std::string tag)
{
    count(place);
    if (open_.size() >= deepest_source) {
        refuse_word(told_place(file_, place) + "more than " + std::to_string(deepest_source) +
                    " tables or lists within each other");
    }
    source_value opened;
    opened.kind = kind;
    opened.place = place;
    opened.tag = std::move(tag);
    open_.emplace_back(std::exchange(name_, {}), std::move(opened));
    has_name_ = false;
}

void source_builder::end()
{
    auto [name, value] = std::move(open_.back());
    open_.pop_back();
    name_ = std::move(name);
    if (open_.empty()) {
        whole_ = std::move(value);
    } else {
        open_.back().second.fields.emplace_back(std::exchange(name_, {}), std::move(value));
    }
}

void source_builder::add(source_value value)
{
    count(value.place);
    has_name_ = false;
    if (open_.empty()) {
        whole_ = std::move(value);
    } else {
        open_.back().second.fields.emplace_back(std::exchange(name_, {}), std::move(value));
    }
}

void source_builder::name(std::string text)
{
    name_ = std::move(text);
    has_name_ = true;
}

} // namespace tool
