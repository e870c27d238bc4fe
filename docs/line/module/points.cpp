// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
#include "points.hpp"

#include <algorithm>
#include <bit>
#include <charconv>
#include <optional>
#include <ranges>
#include <utility>

#include "catalog/value_text.hpp"
#include "words/words.hpp"

namespace line_page {

namespace {

using tool::register_space;
using tool::value_type;

template <typename T> struct word_for {
    std::string_view word;
    T what;
};
constexpr word_for<register_space> spaces[]{{"holding", register_space::holding},
                                            {"input", register_space::input},
                                            {"coil", register_space::coil},
                                            {"discrete", register_space::discrete}};
constexpr word_for<value_type> types[]{
    {"u16", value_type::u16},     {"i16", value_type::i16},     {"u32", value_type::u32}, {"i32", value_type::i32},
    {"f32", value_type::f32},     {"u64", value_type::u64},     {"i64", value_type::i64}, {"f64", value_type::f64},
    {"bcd16", value_type::bcd16}, {"bcd32", value_type::bcd32}, {"hex", value_type::hex}, {"bits", value_type::bits}};
constexpr std::uint16_t most_letters = 250; // of a text: those of 125 registers
constexpr std::string_view orders[]{"abcd", "cdab", "badc", "dcba"};

template <typename T, std::size_t Size>
std::optional<T> meant_by(std::string_view word, word_for<T> const (&known)[Size])
{
    auto const found = std::ranges::find(known, word, &word_for<T>::word);
    return found == std::end(known) ? std::nullopt : std::optional{found->what};
}

std::uint16_t registers_of(value_type type)
{
    switch (type) {
    case value_type::u32:
    case value_type::i32:
    case value_type::f32:
    case value_type::bcd32: return 2;
    case value_type::u64:
    case value_type::i64:
    case value_type::f64: return 4;
    default: return 1;
    }
}

/// "input:1000-1003:f32:cdab"; empty where it is no place.
std::vector<point> places_in(std::string_view word)
{
    auto parts = tool::parts_of(word, ":");
    point first;
    if (auto const space = meant_by(parts[0], spaces)) {
        first.space = *space;
        parts.erase(parts.begin());
    }
    bool const is_bit = first.space == register_space::coil or first.space == register_space::discrete;
    if (parts.empty() or parts.size() > 3 or (is_bit and parts.size() > 1)) {
        return {};
    }
    std::size_t const dash = parts[0].find('-');
    auto const from = tool::word_number(parts[0].substr(0, dash));
    auto const to = dash == parts[0].npos ? from : tool::word_number(parts[0].substr(dash + 1));
    if (parts.size() > 1) {
        constexpr std::string_view text = "text";
        auto const type = meant_by(parts[1], types);
        auto const letters =
            parts[1].starts_with(text) ? tool::word_number(parts[1].substr(text.size())) : std::nullopt;
        if (not type and (not letters or *letters == 0 or *letters > most_letters)) {
            return {};
        }
        first.type = type.value_or(value_type::text);
        first.letters = type ? std::uint16_t{0} : *letters;
        first.count = static_cast<std::uint16_t>(type ? registers_of(*type) : (*letters + 1) / 2);
    }
    if (parts.size() > 2) {
        if (first.count == 1 or std::ranges::find(orders, parts[2]) == std::end(orders)) {
            return {};
        }
        first.order = parts[2];
    }
    constexpr std::uint32_t most = 500;
    std::vector<point> all;
    for (std::uint32_t at = from.value_or(1);
         to and from and at + first.count - 1U <= 0xFFFF and at <= *to and all.size() < most; at += first.count) {
        point& each = all.emplace_back(first);
        each.address = static_cast<std::uint16_t>(at);
        bool const is_plain = first.space == register_space::holding;
        each.name =
            (is_plain ? "" : std::string{spaces[static_cast<int>(first.space)].word} + ":") + std::to_string(at);
    }
    return all;
}

std::vector<point> points_of_word(std::string_view word, tool::drive_catalog const* drive)
{
    auto const* const by_code = drive == nullptr ? nullptr : drive->by_code(word);
    std::vector<point> all;
    if (by_code != nullptr) {
        all.emplace_back().address = by_code->address;
    } else {
        all = places_in(tool::lower(word));
    }
    for (point& each : all) {
        bool const is_drives = drive != nullptr and each.space == register_space::holding and
                               each.type == value_type::u16 and drive->at(each.address) != nullptr;
        if (is_drives) {
            each.entry = drive->at(each.address);
            each.name = each.entry->code;
            each.unit = each.entry->unit;
        }
    }
    return all;
}

std::optional<std::int64_t> whole_number(std::string_view text)
{
    bool const is_hex = text.starts_with("0x");
    text.remove_prefix(is_hex ? 2 : 0);
    std::int64_t number = 0;
    auto const [end, wrong] = std::from_chars(text.data(), text.data() + text.size(), number, is_hex ? 16 : 10);
    return wrong == std::errc{} and end == text.data() + text.size() ? std::optional{number} : std::nullopt;
}

/// "0.1", "10".
tool::step_size step_in(std::string_view text)
{
    std::size_t const sign = text.find('.');
    std::string digits{text.substr(0, sign)};
    std::int64_t places = 1;
    if (sign != text.npos) {
        digits += text.substr(sign + 1);
        for (std::size_t i = sign + 1; i < text.size(); ++i) {
            places *= 10;
        }
    }
    return {whole_number(digits).value_or(1), places};
}

/// The fields of a register file.
std::vector<point> point_of_fields(std::vector<std::string_view> const& fields)
{
    auto all = places_in(fields[1]);
    for (point& each : all) {
        each.name = fields[0];
        each.step = step_in(fields[2].empty() ? "1" : fields[2]);
        each.unit = fields[3];
        for (std::string_view const choice : tool::parts_of(fields[4])) {
            std::size_t const sign = choice.find('=');
            if (auto const number = whole_number(choice.substr(sign == choice.npos ? 0 : sign + 1));
                sign != choice.npos and number) {
                each.choices.emplace_back(choice.substr(0, sign), *number);
            }
        }
        for (std::string_view const none : tool::parts_of(fields[5])) {
            if (auto const number = whole_number(none)) {
                each.invalid.push_back(static_cast<std::uint64_t>(*number));
            }
        }
    }
    return all;
}

std::uint64_t bits_of(point const& of, std::span<std::uint16_t const> words)
{
    bool const has_low_word_first = of.order.starts_with('c') or of.order.starts_with('d');
    bool const has_low_byte_first = of.order.starts_with('b') or of.order.starts_with('d');
    std::uint64_t bits = 0;
    for (std::size_t i = 0; i < words.size(); ++i) {
        unsigned const word = words[has_low_word_first ? words.size() - 1 - i : i];
        bits = bits << 16U | (has_low_byte_first ? (word << 8U | word >> 8U) & 0xFFFFU : word);
    }
    return bits;
}

/// Of packed decimals nothing where a digit is none.
std::optional<std::int64_t> count_of(value_type type, std::uint64_t bits)
{
    switch (type) {
    case value_type::i16: return static_cast<std::int16_t>(bits);
    case value_type::i32: return static_cast<std::int32_t>(bits);
    case value_type::bcd16:
    case value_type::bcd32: break;
    default: return static_cast<std::int64_t>(bits);
    }
    std::int64_t number = 0;
    for (unsigned left = 8; left-- > 0;) {
        auto const digit = static_cast<int>(bits >> 4 * left & 0xFU);
        if (digit > 9) {
            return std::nullopt;
        }
        number = number * 10 + digit;
    }
    return number;
}

std::string hex_text(std::span<std::uint16_t const> words)
{
    std::string text = "0x";
    for (std::uint16_t const word : words) {
        text += tool::hex_word(word).substr(2);
    }
    return text;
}

std::string hex_of(std::uint64_t bits)
{
    std::uint16_t const words[]{static_cast<std::uint16_t>(bits >> 48U), static_cast<std::uint16_t>(bits >> 32U),
                                static_cast<std::uint16_t>(bits >> 16U), static_cast<std::uint16_t>(bits)};
    return hex_text(words);
}

/// Up to a 0, without blanks behind; what is no printable letter of ASCII is a question mark.
std::string letters_of(point const& of, std::span<std::uint16_t const> words)
{
    std::string text;
    for (unsigned const i : std::views::iota(0U, unsigned{of.letters})) {
        bool const is_high = (i % 2 == 0) != of.order.starts_with('b');
        unsigned const letter = words[i / 2] >> (is_high ? 8U : 0U) & 0xFFU;
        if (letter == 0) {
            break;
        }
        text += letter >= ' ' and letter <= '~' ? static_cast<char>(letter) : '?';
    }
    return text.erase(text.find_last_not_of(' ') + 1);
}

std::string with_unit(std::string text, std::string const& unit)
{
    return unit.empty() ? text : text.append(" ").append(unit);
}

} // namespace

std::uint8_t point::function() const noexcept
{
    switch (space) {
    case register_space::coil: return 1;
    case register_space::discrete: return 2;
    case register_space::holding: return 3;
    case register_space::input: return 4;
    }
    return 0;
}

points_read points_in(std::string_view text, tool::drive_catalog const* drive)
{
    constexpr std::size_t fields_of_file = 6;
    points_read read;
    for (std::string_view const line : tool::parts_of(text, "\n")) {
        auto const fields = tool::parts_of(line, "\t");
        auto found = fields.size() == fields_of_file ? point_of_fields(fields) : points_of_word(line, drive);
        if (found.empty()) {
            return {.flaw = std::string{line}};
        }
        read.points.insert(read.points.end(), found.begin(), found.end());
    }
    return read;
}

point_value value_of(point const& of, tool::drive_catalog const* drive, std::span<std::uint16_t const> words)
{
    if (of.entry != nullptr and drive != nullptr) {
        auto const step = tool::step_of(*of.entry, *drive);
        return {of.entry->is_amount() and step ? tool::number_text(of.entry->count_of(words[0]), *step)
                                               : std::to_string(words[0]),
                step ? tool::full_text(*of.entry, words[0], *step) : std::to_string(words[0]) + " steps"};
    }
    if (of.type == value_type::text) {
        return {.text = letters_of(of, words)};
    }
    std::uint64_t const bits = bits_of(of, words);
    if (std::ranges::find(of.invalid, bits) != of.invalid.end()) {
        return {.text = "no value: " + hex_text(words)};
    }
    bool const is_plain = of.step.numerator == 1 and of.step.denominator == 1;
    if (of.type == value_type::f32 and is_plain) {
        auto const number = std::bit_cast<float>(static_cast<std::uint32_t>(bits));
        auto const shown = rtuwire::text_of(rtuwire::real<rtuwire::count16>{number});
        std::string text{std::string_view{shown}};
        bool const is_finite = (bits >> 23U & 0xFFU) != 0xFFU;
        return {is_finite ? text : std::string{}, is_finite ? with_unit(text, of.unit) : text};
    }
    if (of.type == value_type::hex or of.type == value_type::bits) {
        return {std::to_string(static_cast<std::uint32_t>(bits)), tool::hex_word(words[0])};
    }
    if (of.count == 4 or of.type == value_type::f32) {
        char const* const type = of.type == value_type::f32   ? "f32:"
                                 : of.type == value_type::f64 ? "f64:"
                                 : of.type == value_type::i64 ? "i64:"
                                                              : "u64:";
        return {.text = with_unit(hex_text(words), of.unit), .wide = type + hex_of(bits)};
    }
    auto const count = count_of(of.type, bits);
    if (not count) {
        return {.text = hex_text(words) + ", which is no BCD"};
    }
    auto const choice = std::ranges::find(of.choices, *count, [](auto const& each) { return each.second; });
    std::string const number = tool::number_text(*count, of.step);
    return {number, choice != of.choices.end() ? choice->first : with_unit(number, of.unit)};
}

point const* point_names::at(register_space space, unsigned address) const
{
    auto const found = std::ranges::find_if(
        points_, [&](point const& each) { return each.space == space and each.address == address; });
    return found == points_.end() ? nullptr : &*found;
}

std::string point_names::name_at(register_space space, unsigned address) const
{
    point const* const found = at(space, address);
    return found == nullptr ? std::string{} : found->name;
}

std::vector<tool::passed_value> point_names::values_at(register_space space, unsigned address,
                                                       std::span<std::uint16_t const> words) const
{
    point const* const found = at(space, address);
    if (found == nullptr or words.size() < found->count) {
        return {};
    }
    std::string const text = value_of(*found, nullptr, words).text;
    return {{.address = address, .count = found->count, .name = found->name, .text = text, .short_text = text}};
}

} // namespace line_page
